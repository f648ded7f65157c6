// What a field measures of an impact besides the depth: as JSON, in words, as a picture of the channel.       docs/formats/impact.md
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "percal/observe/field_measures.hpp"
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal {

// `impact_parameter_kg_m_s`, `sectional_density_kg_m2`, `layers`, `exit_speed_m_s` with its scatter, `final`, `channel`.
page::Json field_measures_to_json(const FieldMeasures& measures, const Scene& scene, const Reduction& reduction,
                                  const Penetration& penetration, const std::vector<Evaluation>& runs);

// Of one run: a number for each layer that it crossed; how it ended, null of a run that did not go on.
page::Json speeds_behind_to_json(const ImpactResult& run, const Scales& scales);
page::Json aftermath_to_json(const std::optional<Aftermath>& after, const Scales& scales);

namespace page {

// "; it comes to rest at 18.4 um ± 0.5 um", "; it leaves upwards at 278 m/s"; empty where no run went on.
std::string final_words(const Json& result);
// ", left with 520 m/s"; empty where that is not known.
std::string exit_words(const Json& result);

// What and how much, for the table of the answer.
std::vector<std::pair<std::string, std::string>> field_rows(const Json& result);

// The channel and the particle, both sides of the middle line; empty where no scene asked for it.
Section channel_section(const Json& result);

}  // namespace page
}  // namespace percal
