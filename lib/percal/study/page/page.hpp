// The page of `percal study`, and what the results of its three kinds have alike.                   docs/formats/study.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/page/page.hpp"
#include "percal/page/result.hpp"
#include "percal/page/result_csv.hpp"
#include "percal/scene/scene.hpp"
#include "percal/study/ladder.hpp"

namespace percal {

// What the result says, of whichever kind it is.
page::Page study_page(const page::Json& result);

// The kinds, as results name them under `study`.
namespace study_kind {
inline constexpr const char *error_vs_time = "error vs time", *omissions = "omissions", *extremes = "extremes";
}

// --- writing ------------------------------------------------------------------------------------------------------

page::Json study_head(const std::string& kind, const page::Json& input, const page::Cost& cost);
page::Json input_of(const Scene& scene);
page::Json rung_to_json(const Rung& rung);  // without errors

// The same keys, with null under each: of what is not there.
page::Json emptied(page::Json object);

// --- reading ------------------------------------------------------------------------------------------------------

std::string studied_scene(const page::Json& result);         // "gold into skin (gold.toml)"
std::string cpu_time(const std::optional<double>& seconds);  // "0.061 s", "1234 s"
std::string depth_or_outcome(const page::Json& rung);        // "27.7 um", "passed through"
std::string joined(const std::vector<std::string>& words, const std::string& between = ", ");

}  // namespace percal
