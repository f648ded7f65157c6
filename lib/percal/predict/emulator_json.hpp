// What an emulator has learnt, as a result keeps it: its runs and its settings. What is read is checked: page::MissingKey with the key.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "percal/invert/emulator.hpp"
#include "percal/page/result.hpp"

namespace percal {

double wanted(const page::Json& object, const std::string& key);
// Not below zero, and an int holds it.
int whole(const page::Json& object, const std::string& key);
// The numbers of a row of the wanted length, finite.
std::vector<double> row_of(const page::Json& json, std::size_t length, const char* key);

page::Json settings_to_json(const EmulatorSettings& settings);
EmulatorSettings settings_of(const page::Json& json);
// Every input that an emulator of these runs sees has a length.
void require_lengths(const EmulatorSettings& settings, const std::vector<TrainingRun>& runs);

// Rows of the inputs of a run under so many covers in the order of SphereInputs, the element's size and what is learnt; read from the key "runs".
page::Json runs_to_json(const std::vector<TrainingRun>& runs, std::size_t covers);
std::vector<TrainingRun> runs_of(const page::Json& json, std::size_t covers);

}  // namespace percal
