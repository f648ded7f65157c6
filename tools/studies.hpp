// The kinds of study, each in a file of its own.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "commands.hpp"
#include "percal/campaign/campaign.hpp"

namespace percal::tools {

Exit study_error_vs_time(const StudyArguments&, const Common&);  // study_error_vs_time.cpp
Exit study_omissions(const StudyArguments&, const Common&);      // study_omissions.cpp
Exit study_extremes(const StudyArguments&, const Common&);       // study_extremes.cpp

// What studies write beside their own tables: study_page.cpp.

// The keys of every study's result: schema, program, the name of the study, what it cost.
nlohmann::json study_header(const std::string& study, const CampaignCost& cost, double wall_seconds);
std::string json_text(const nlohmann::json& json);

// A page that says which command wrote it, with which program, on which processor.
std::string study_page(const std::string& title, const std::string& command, const std::string& about,
                       const std::string& body);

}  // namespace percal::tools
