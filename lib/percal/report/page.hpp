// A page as data: sections of paragraphs, tables and figures. The pages of the commands make one from a result's JSON;
// html.hpp renders it.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

#include "percal/plot/chart.hpp"

namespace percal {

struct Paragraph {
  std::string text;  // plain text
};

struct Bullets {
  std::vector<std::string> items;
};

struct PageTable {
  std::string caption;
  std::vector<std::vector<std::string>> rows;  // the first row is the header; the first column names the row
  std::vector<std::string> notes;
};

struct PageFigure {
  std::string name;     // of its files, unique on the page: "ridge_mu"
  std::string caption;  // what it shows, a sentence or two
  std::string alt;      // what a reader who cannot see it should know: axes, series, the finding
  Chart chart;
};

// Text to be kept as it stands: the scene, a log.
struct Preformatted {
  std::string caption;
  std::string text;
};

using PageBlock = std::variant<Paragraph, Bullets, PageTable, PageFigure, Preformatted>;

struct PageSection {
  std::string id;     // of the link: "ridge"
  std::string title;  // "The ridge"
  std::vector<PageBlock> blocks;
};

struct Page {
  std::string title;
  std::string summary;  // a sentence or two: the answer with its interval
  std::vector<PageSection> sections;
};

// The page of a result.json of any command that writes one. Throws BadInput with `file` where it is none, or where its
// schema is not known.
Page page_of_result(const nlohmann::json& result, const std::string& file);

// Two results of the same command side by side: what was asked differently, what came out differently beside both errors.
// Throws BadInput where they are of different commands.
Page page_of_comparison(const nlohmann::json& first, const std::string& first_file, const nlohmann::json& second,
                        const std::string& second_file);

// The pages of each command's results, for page_of_result().
Page fit_page(const nlohmann::json& result);
Page scale_page(const nlohmann::json& result);
Page impact_page(const nlohmann::json& result);
Page study_page(const nlohmann::json& result);
Page identify_page(const nlohmann::json& result);
Page calibrate_page(const nlohmann::json& result);

}  // namespace percal
