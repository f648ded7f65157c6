// The specimen's size before the test, by which a machine's force and displacement are stress and strain.  docs/formats/csv.md
#pragma once
#include <functional>
#include <optional>
#include <string>

namespace percal {

// Nothing where the file has the stretch, or the stress, itself.
struct Specimen {
  std::optional<double> gauge_length;  // m, between the grips or plates; in simple shear the height between the plates
  std::optional<double> area;          // m2, that the force acts on
};

// As a user says it, in SI: one cross-section at most, as an area, a width with a thickness, or a diameter.
struct SpecimenSizes {
  std::optional<double> gauge_length, area, width, thickness, specimen_diameter;
};

// Throws the message of a key, what was found and what is accepted: an option's or a job's.
using RefusedKey = std::function<void(const std::string& key, const std::string& found, const std::string& accepted)>;

// Calls `refuse` with the key of SpecimenSizes that is one too many, or that is missing.
Specimen specimen_of(const SpecimenSizes& sizes, const RefusedKey& refuse);

}  // namespace percal
