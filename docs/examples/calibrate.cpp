// A curve and depths together -> modulus, exponent and erosion strain with intervals.        calibrate JOB.toml STORE
#include <cstdio>
#include <exception>
#include <percal/calibrate.hpp>

int main(int argc, char** argv) try {
  if (argc != 3) return std::fprintf(stderr, "usage: calibrate JOB.toml STORE\n"), 2;
  const percal::CalibrationJob job = percal::read_calibration_job(argv[1]);

  // Finished runs are kept in the store: an interrupted calibration goes on from there.
  percal::Store store(argv[2]);
  percal::Campaign campaign(&store, 0);  // a thread for each core

  const auto say = [](const std::string& sentence) { std::printf("%s\n", sentence.c_str()); };
  const percal::CalibrationResult result =
      percal::calibrate(job, store, campaign, percal::CalibrationLimits{.budget_seconds = 300}, say);

  // One result for each way to read the data that the job names.
  for (const percal::HypothesisResult& hypothesis : result.hypotheses) {
    const percal::Minimum& best = hypothesis.minima.front();
    for (std::size_t k = 0; k < hypothesis.parameters.size(); ++k) {
      const percal::FreeParameter& parameter = job.parameters[hypothesis.parameters[k]].free;
      const percal::ProfileInterval& sure = hypothesis.intervals[k];
      std::printf("%s = %.4g %s, %.4g to %.4g%s\n", parameter.name.c_str(), parameter.natural(best.searched[k]),
                  parameter.unit.c_str(), sure.interval.low, sure.interval.high,
                  sure.identifiable ? "" : ": these data cannot tell");
    }
    for (const std::string& finding : hypothesis.findings) std::printf("note: %s\n", finding.c_str());
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
