// A calibration as tables and sentences for a reader.
#pragma once
#include <string>
#include <vector>

#include "percal/calibrate/result.hpp"

namespace percal {

// The first row is the header. A table without rows has notes alone.
struct TextTable {
  std::string title;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;
};

enum class ShotTables { where_few, all };
inline constexpr std::size_t few_shots = 12;  // of a job, whose depths are shown without being asked for

// All hypotheses side by side, where there are several.
TextTable hypotheses_side_by_side(const CalibrationJob& job, const CalibrationResult& result);

// Everything about one hypothesis: parameters, moduli, depths, predictions beside the closed form's, fresh runs, where the
// error comes from, what to measure next, and what a reader must know.
std::vector<TextTable> hypothesis_tables(const CalibrationJob& job, const CalibrationResult& result,
                                         const HypothesisResult& hypothesis, ShotTables shots);

// The closed form's own constants.
TextTable dehn_table(const CalibrationJob& job, const DehnResult& dehn);

// What the emulators were trained on, how sure they are, and how their error fell.
std::vector<TextTable> emulator_tables(const CalibrationResult& result);

// "1240 runs, 310 from the store, 812.4 s of processor time, ..."; the budget and what more time would buy.
std::vector<std::string> cost_sentences(const CalibrationCost& cost);

}  // namespace percal
