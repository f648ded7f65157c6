// The numbers behind an identification's figures, as JSON: points, lines and scans that its tables show only in part.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "percal/identify/identification.hpp"

namespace percal::identification_json {

nlohmann::json sphere_to_json(const ParticleScene& sphere);
nlohmann::json formulations_to_json(const IdentifyJob& job, const Identification& found);
// The trials of the scan, and the score of each alpha between the candidates; empty arrays where alpha was given.
nlohmann::json alpha_trials_to_json(const IdentifyJob& job, const Identification& found);
nlohmann::json alpha_scores_to_json(const Identification& found);
nlohmann::json mesh_study_to_json(const IdentifyJob& job, const Identification& found);
// CPU seconds of each mesh's runs, whether they were made now or taken from the store.
nlohmann::json mesh_cost_to_json(const IdentifyJob& job, const Identification& found);
nlohmann::json trends_to_json(const IdentifyJob& job);
// The line through the model's shots, these, and the depths that it gives; null where the job has none.
nlohmann::json scaled_line_to_json(const IdentifyJob& job, const Identification& found);
// What the calibration impact at the identified pair does without; empty where there is no pair.
nlohmann::json left_out_to_json(const IdentifyJob& job, const Identification& found);

}  // namespace percal::identification_json
