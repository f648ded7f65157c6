// Where the error of a quantity comes from.                                                     docs/theory/calibration.md
#pragma once
#include "percal/calibrate/job_fit.hpp"

namespace percal {

// A quantity whose logarithm is linear in the fitted parameters near the minimum: ln q = value + gradient . (searched - minimum).
struct LogQuantity {
  std::string name;
  double value = 0;          // q at the minimum, SI
  Eigen::VectorXd gradient;  // d ln q / d fitted parameter
  double own_error = 0;      // relative standard deviation that q has besides (a rate factor's)
  std::string own_error_name = "";
};

// The fit is a linear map of the data near its minimum: each source of the data's covariance is carried through it by itself.
// `mesh_shift`: ln depth without mesh error less ln depth on the mesh, of each fitted shot.
ErrorBudget error_budget(const CalibrationJob& job, const JobModel& model, const JobFit& fit,
                         const LogQuantity& quantity, const Eigen::VectorXd& mesh_shift);

// The interval of a material's number that the fit has among its parameters.
std::optional<Interval> interval_of(const JobModel& model, const JobFit& fit, const MaterialNumber& number,
                                    const std::vector<ProfileInterval>& profiles);

// Moduli of every material that the fit moves, and of the fixed ones. The interval of a modulus that is itself a fitted parameter is
// its profile's; those of numbers derived from several parameters are linearised.
std::vector<MaterialModuli> material_moduli(const CalibrationJob& job, const Hypothesis& hypothesis,
                                            const JobModel& model, const JobFit& fit,
                                            const std::vector<ProfileInterval>& profiles);

// ln of the quasi-static Young's modulus 3 mu_true / rate factor of a material as a quantity; of mu_true where no factor is known.
LogQuantity stiffness_quantity(const CalibrationJob& job, const Hypothesis& hypothesis, const JobModel& model,
                               const JobFit& fit, int material);

// Which measurement would help most: shots at speeds and into materials of the job that could be made, and curves. The best few for
// each quantity, best first; what each would do to the quantity's interval, linearised.
std::vector<Advice> advise(const CalibrationJob& job, const JobModel& model, const JobFit& fit,
                           const std::vector<LogQuantity>& quantities);

}  // namespace percal
