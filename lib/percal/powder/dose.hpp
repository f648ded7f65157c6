// The dose of a powder over depth, with what the parameters' uncertainty makes of it.              docs/theory/powder.md
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "percal/powder/depth_distribution.hpp"
#include "percal/powder/depth_table.hpp"

namespace percal {

// One of the worlds that a calibration does not rule out.
struct Draw {
  Eigen::Index point = 0;  // of the parameters
  double error = 0;        // of the model, in its standard deviations; the same for all particles
  double scatter = 0;      // of ln depth of single particles
};
// The best of all first, at least `fewest` altogether; the same ones every time.                                    (8)
std::vector<Draw> draws_of(const ForwardModel& model, Eigen::Index points, int fewest);

// A number at the best draw, and the interval of all draws.
struct DoseEstimate {
  double best = 0, low = 0, high = 0;
};

// Numbers of the distribution of each draw: draws in rows.
using Readings = std::function<Eigen::VectorXd(const DepthDistribution&)>;
Eigen::MatrixXd readings_of(const std::vector<ParticleClass>& classes, const DepthTable& table,
                            const std::vector<Draw>& draws, const Bounce& bounce, const Readings& readings);
DoseEstimate estimate_of(const Eigen::Ref<const Eigen::VectorXd>& of_draws, double level);

// Where a dose is wanted, m.
struct DepthBand {
  double from = 0, to = 0;
};

// What is asked of a powder.
struct DoseQuestion {
  Bounce bounce = Breach{};
  double layer_depth = 0;  // m: what goes as deep has passed
  std::vector<double> ends =
      {};  // m: lower ends of the layers that shares are asked of, rising, within the layer's depth
  std::optional<DepthBand> band = {};
  double known_depth = 0;  // m: of the deepest shot that the calibration was fitted to; 0: none was
  double level = 0.95;
};

struct DosePoint {
  double depth = 0;           // m
  DoseEstimate number, mass;  // of all: went in, and ended above it
};

struct DoseShares {
  DoseEstimate bounced;
  std::vector<DoseEstimate> layers;  // between the ends
  DoseEstimate deeper;               // below the last end, within the layer's depth
  DoseEstimate passed;
  DoseEstimate in_band;       // of the question's band
  DoseEstimate beyond_known;  // deeper than the known depth, passed or not
};

// Of the particles that end within the layer; m.
struct DoseDepths {
  DoseEstimate mean, deviation, tenth, median, ninetieth;
};

struct Dose {
  std::vector<DosePoint> curve;
  DoseShares number_shares, mass_shares;
  DoseDepths number_depths, mass_depths;
  double integration_error = 0;  // largest change of a share with half as many cells
};

Dose dose_of(const Powder& powder, const ForwardModel& model, const DoseQuestion& question);

// Standard deviation of the depth, by number, with all that spreads and with one source alone, the others at their medians.  (9)
struct SpreadSource {
  std::string name;  // "all", "size", "density", "speed", "scatter"
  DoseEstimate deviation, mean;
};
std::vector<SpreadSource> spread_by_source(const Powder& powder, const ForwardModel& model,
                                           const DoseQuestion& question);

}  // namespace percal
