// What the files of this folder share. Each of them writes a part of a calibration's result.json, and makes what the page says of it.
#pragma once
#include <limits>

#include "percal/calibrate/result.hpp"
#include "percal/page/sections.hpp"

namespace percal::calibration_page {

using namespace page;

inline constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

// --- parameters.cpp: what was looked for and found -----------------------------------------------------------------
std::string key_of(const std::string& key, const FreeParameter& parameter);  // with its unit behind it: "value_Pa"
Json numbers_to_json(const std::vector<double>& values);
Json interval_to_json(const Interval& interval);
Json searched_to_json(const CalibrationJob& job);
std::vector<FreeParameter> fitted_parameters(const CalibrationJob& job, const HypothesisResult& result);
Json minimum_to_json(const CalibrationJob& job, const std::vector<FreeParameter>& parameters, const Minimum& minimum);
// One entry for each parameter at the best minimum: value, intervals, whether it is known.
Json parameters_to_json(const std::vector<FreeParameter>& parameters, const Minimum& best,
                        const std::vector<ProfileInterval>& intervals, const std::optional<Bootstrap>& bootstrap);
Json fit_to_json(const CalibrationJob& job, const HypothesisResult& result);  // several keys of a hypothesis
std::string allowed_words(const Json& parameter);  // its interval, or the pieces of its region where there are several
Table searched_table(const Json& result);
void add_fit(Section& section, const Json& result, const Json& hypothesis, int number);

// --- curves.cpp ----------------------------------------------------------------------------------------------------
Json measured_curves_to_json(const CalibrationJob& job);
Json curves_to_json(const CalibrationJob& job, const std::vector<CurveStresses>& curves);
void add_curves(Section& section, const Json& result, const Json& hypothesis, int number);

// --- shots.cpp: measured depths and the model's --------------------------------------------------------------------
Json measured_shots_to_json(const CalibrationJob& job);
Json shots_to_json(const CalibrationJob& job, const std::vector<ShotDepth>& depths);
struct FittedDepths {
  int count = 0, within = 0;  // within the interval of one such shot
  double deviation = 0;       // mean size
};
FittedDepths fitted_depths(const Json& hypothesis);
const Json& datum_of(const Json& result, const Json& entry);  // the shot of the data that a hypothesis' entry is of
double measured_depth(const Json& shot);                      // the depth, or the least depth
bool is_along_depth(const Json& shot);                        // whether what was measured is a depth
std::vector<std::string> each_once(const Json& shots, const char* key);  // a key's words, in the order of the shots
void add_shots(Section& section, const Json& result, const Json& hypothesis, int number);
Section depths_section(const Json& result);

// --- speeds.cpp: depth over speed ----------------------------------------------------------------------------------
void add_speeds(Section& section, const Json& result, const Json& hypothesis, int number);

// --- predictions.cpp: deviations of sets and of what the fit did not see; Dehn's closed form beside them -------------
Json predictions_to_json(const CalibrationJob& job, const std::vector<Deviation>& sets,
                         const std::vector<CrossValidationResult>& cross_validations,
                         const std::vector<CrossValidationResult>& leave_one_out);  // several keys of a hypothesis
Json dehn_to_json(const CalibrationJob& job, const DehnResult& dehn);
void add_predictions(Section& section, const Json& result, const Json& hypothesis);
Section predictions_section(const Json& result);

// --- ridges.cpp ----------------------------------------------------------------------------------------------------
Json ridges_to_json(const std::vector<FreeParameter>& parameters, const std::vector<RidgeMap>& maps);
Json published_to_json(const CalibrationJob& job);
Section ridges_section(const Json& result);

// --- moduli.cpp: moduli in both conventions, where their errors come from, what would make them smaller --------------
Json moduli_to_json(const HypothesisResult& result);  // several keys of a hypothesis
std::string estimate_words(const Json& estimate);     // "478 kPa (106 kPa to above 1.92 MPa)"
Section moduli_section(const Json& result);
void add_errors(Section& section, const Json& result, const Json& hypothesis);
List advice_list(const Json& hypothesis);  // the best measurement for each quantity, where one helps

// --- emulator.cpp: the emulator, and the fresh runs that check it -----------------------------------------------------
Json emulator_to_json(const EmulatorReport& emulator);
Json fresh_to_json(const CalibrationJob& job, const std::vector<FreshRun>& runs);
void add_fresh_runs(Section& section, const Json& result, const Json& hypothesis, int number);
Section emulator_section(const Json& result);

// --- answer.cpp: what the terminal shows unasked --------------------------------------------------------------------
std::string summary_of(const Json& result);
void add_answer(Page& page, const Json& result);
std::vector<std::string> findings_of_all(const Json& result);  // sentences that every hypothesis has

}  // namespace percal::calibration_page
