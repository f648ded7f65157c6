// The results of `percal dose` and `percal design`, and their pages.                  docs/formats/dose.md, docs/formats/design.md
#pragma once
#include <string>

#include "percal/page/page.hpp"
#include "percal/page/result.hpp"
#include "percal/powder/design_answer.hpp"
#include "percal/powder/dose_answer.hpp"

namespace percal {

page::Json dose_to_json(const PowderJob& job, const DoseAnswer& answer);
// dose.csv: shares that end above each depth.
std::string dose_to_csv(const DoseAnswer& answer);
page::Page dose_page(const page::Json& result);

page::Json design_to_json(const PowderJob& job, const DesignAnswer& answer);
// map.csv: a row for each point of the map.
std::string design_to_csv(const DesignAnswer& answer);
page::Page design_page(const page::Json& result);

// --- shared by both -------------------------------------------------------------------------------------------------

// What both results have.
template <class Answer>
page::Json powder_head(const char* command, const PowderJob& job, const Answer& answer);

// {best, low, high, low_open, high_open}
page::Json estimate_to_json(const DoseEstimate& estimate);
page::Json particle_to_json(const PowderParticle& particle);
page::Json powder_to_json(const PowderJob& job);
page::Json beyond_to_json(const std::vector<BeyondFitted>& beyond);

// "12.3 %", "10 % to 14 %" of an estimate under a key.
std::string share_words(const page::Json& object, const std::string& key);
std::string share_interval_words(const page::Json& object, const std::string& key);
// Of a length under KEY.
std::string length_words(const page::Json& object, const std::string& key);

template <class Answer>
page::Json powder_head(const char* command, const PowderJob& job, const Answer& answer) {
  page::Json head = page::result_head(command, {{"job", job.file}, {"toml", job.text}});
  head.update({{"title", job.title},
               {"level", answer.level},
               {"calibration", job.calibration.text},
               {"material", answer.material},
               {"hypothesis", answer.hypothesis},
               {"layer_depth_m", answer.layer_depth},
               {"powder", powder_to_json(job)},
               {"beyond", beyond_to_json(answer.beyond)},
               {"findings", answer.findings},
               {"cost", page::cost_to_json(answer.cost)}});
  return head;
}

}  // namespace percal
