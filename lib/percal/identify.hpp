// identify: the whole chain from gelatin to tissue.
//
// Concentration law, exponent, ridge of modulus and erosion strain, similar model system, the tissue's modulus,
// predictions, card.
//
//     const percal::IdentifyJob job = percal::read_identify_job("skin.toml");
//     const percal::Identification found = percal::identify(job, campaign, {});
//
// See docs/formats/identify.md.
#pragma once
#include "percal/identify/identification.hpp"
#include "percal/identify/job.hpp"
#include "percal/identify/page/identification_json.hpp"
