// Numbers beside somebody else's: a comparison for each step of the chain, and published tables recomputed.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace percal {

inline constexpr double kPa = 1e3, MPa = 1e6, cm = 1e-2, um = 1e-6;  // units of the tables

struct IdentifyJob;
struct Identification;
struct PredictionResult;

// Numbers are in `unit`. `error` is the standard error that we know of; what it holds and leaves out stands in the note.
struct ComparedNumber {
  std::string what;
  std::string unit = "";
  std::optional<double> reference = {};
  std::optional<double> ours = {};
  std::optional<double> error = {};
  int digits = 4;
  std::string remark = "";
};

struct ComparedNumbers {
  std::string name;
  std::string note;
  std::string beside = "";  // what `reference` is; empty: the job's reference
  std::vector<ComparedNumber> rows;
};

inline std::optional<double> over(const std::optional<double>& value, double unit) {
  return value ? std::optional(*value / unit) : std::nullopt;
}

// The steps of the chain: steps.cpp.
ComparedNumbers law_step(const IdentifyJob& job, const Identification& found);
ComparedNumbers ridge_step(const IdentifyJob& job, const Identification& found);
ComparedNumbers similarity_step(const IdentifyJob& job, const Identification& found);
ComparedNumbers formulation_step(const IdentifyJob& job, const Identification& found);
ComparedNumbers tissue_step(const IdentifyJob& job, const Identification& found);
ComparedNumbers check_step(const IdentifyJob& job, const Identification& found);
ComparedNumbers mesh_step(const IdentifyJob& job, const Identification& found);
ComparedNumbers prediction_step(const IdentifyJob& job, const PredictionResult& result);

// What a reader must know before using the numbers, in sentences.
std::vector<std::string> findings(const IdentifyJob& job, const Identification& found);

// The published tables that the job lets us recompute: published_tables.cpp.
std::vector<ComparedNumbers> published_tables(const IdentifyJob& job, const Identification& found);

}  // namespace percal
