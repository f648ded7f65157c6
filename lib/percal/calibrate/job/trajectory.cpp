#include "percal/calibrate/job/trajectory.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "percal/text/csv.hpp"

namespace percal {
namespace {

constexpr int fewest_frames = 8;
constexpr int fewest_in_window = 5;
constexpr double window_share = 0.25;  // of the frames, in each parabola of the smooth course
constexpr double still = 0.05;         // of the speed at impact: slower than this at its end, a record shows a stop
constexpr double latest_start = 0.75;  // of the speed at impact: a record that begins slower misses its beginning
constexpr double fastest_start = 1.25;
constexpr double farthest = 1;  // windows from the middle of its own in which a parabola is looked at

struct Record {
  std::vector<double> time, depth;
  std::vector<int> line;
};

constexpr const char* time_key = "trajectory_time";
constexpr const char* depth_key = "trajectory_depth";
constexpr const char* speed_key = "trajectory_speed";

void need_rising_times(const CsvTable& table, const std::vector<double>& time) {
  for (std::size_t k = 1; k < time.size(); ++k)
    if (!(time[k] > time[k - 1]))
      throw BadInput({table.file, table.rows[k].line, "time"}, "a time that is not after the one before",
                     "times that rise");
}

// Depths by the trapezoidal rule.
std::vector<double> travelled(const std::vector<double>& time, const std::vector<double>& speed) {
  std::vector<double> depth{0};
  for (std::size_t k = 1; k < time.size(); ++k)
    depth.push_back(depth.back() + 0.5 * (speed[k] + speed[k - 1]) * (time[k] - time[k - 1]));
  return depth;
}

Record read_record(const std::string& path, const TomlTable& point) {
  const CsvTable table = read_csv(path);
  Record record{.time = table.numbers(point.text(time_key, "time"), dimension::time), .depth = {}, .line = {}};
  for (const CsvRow& row : table.rows) record.line.push_back(row.line);
  if (std::ssize(record.time) < fewest_frames)
    throw BadInput({table.file, 0, ""}, fmt::format("{} frames", record.time.size()),
                   fmt::format("{} frames or more", fewest_frames));
  need_rising_times(table, record.time);
  record.depth = point.has(speed_key) ? travelled(record.time, table.numbers(point.text(speed_key), dimension::speed))
                                      : table.numbers(point.text(depth_key, "depth"), dimension::length);
  return record;
}

// The parabola through the frames of a window, in s = (t - time)/span: depth = c_0 + c_1 s + c_2 s^2, with the covariance of c.
struct Parabola {
  double time, span;
  Eigen::Vector3d c;
  Eigen::Matrix3d covariance;
  double squares, neighbours;  // sums over the residuals: of squares, of products of neighbours
  double depth(double s) const { return c[0] + s * (c[1] + s * c[2]); }
  double speed(double s) const { return (c[1] + 2 * s * c[2]) / span; }
};

Parabola parabola(const Record& record, int begin, int count) {
  const double first = record.time[begin], last = record.time[begin + count - 1];
  Parabola found{
      .time = 0.5 * (first + last), .span = last - first, .c = {}, .covariance = {}, .squares = 0, .neighbours = 0};
  Eigen::MatrixXd powers(count, 3);
  Eigen::VectorXd depth(count);
  for (int k = 0; k < count; ++k) {
    const double s = (record.time[begin + k] - found.time) / found.span;
    powers.row(k) << 1, s, s * s;
    depth[k] = record.depth[begin + k];
  }
  found.c = powers.colPivHouseholderQr().solve(depth);
  const Eigen::VectorXd residuals = depth - powers * found.c;
  found.covariance = residuals.squaredNorm() / (count - 3) * (powers.transpose() * powers).inverse();
  found.squares = residuals.squaredNorm();
  found.neighbours = residuals.head(count - 1).dot(residuals.tail(count - 1));
  return found;
}

// How many neighbouring frames are worth one, by the first correlation of the residuals, which a parabola through n of them makes 3/n less.
double worth_one(const std::vector<Parabola>& course, int window) {
  double squares = 0, neighbours = 0;
  for (const Parabola& at : course) {
    squares += at.squares;
    neighbours += at.neighbours;
  }
  if (!(squares > 0)) return 1;
  const double together = std::clamp((neighbours * window / (window - 1) / squares) + 3.0 / window, 0.0, 0.9);
  return (1 + together) / (1 - together);
}

std::vector<Parabola> smooth_course(const Record& record) {
  const auto frames = static_cast<int>(record.time.size());
  const int window = std::max(fewest_in_window, static_cast<int>(std::lround(window_share * frames)));
  std::vector<Parabola> course;
  for (int begin = 0; begin + window <= frames; ++begin) course.push_back(parabola(record, begin, window));
  const double worth = worth_one(course, window);
  for (Parabola& at : course) at.covariance *= worth;
  return course;
}

// Where the parabola has this speed. A wrong parabola moves the depth there, and the place.
RecordedShot depth_at_speed(const Parabola& at, double speed, const Place& place) {
  const double s = (speed * at.span - at.c[1]) / (2 * at.c[2]);
  if (!(std::abs(s) <= farthest))
    throw BadInput(place, fmt::format("no frames where half of the speed at impact, {:.3g} m/s, is left", speed),
                   "a record without a gap there, or one that ends before");
  const Eigen::Vector3d moves =
      Eigen::Vector3d(1, s, s * s) - speed * at.span / (2 * at.c[2]) * Eigen::Vector3d(0, 1, 2 * s);
  return {RecordedShot::End::half_speed, at.depth(s), std::sqrt(moves.dot(at.covariance * moves))};
}

// Columns may say anything; a shot has a depth.
RecordedShot checked(const RecordedShot& shot, const Place& place) {
  if (!(shot.depth > 0) || !std::isfinite(shot.depth) || !std::isfinite(shot.standard_error))
    throw BadInput(place, fmt::format("frames that make a depth of {:.3g} m", shot.depth),
                   "depths below the surface, from 0 at impact on");
  return shot;
}

}  // namespace

std::optional<std::string> record_path(const TomlTable& point) {
  for (const char* key : {time_key, depth_key, speed_key}) {
    point.describe(key, {"text", "the name of a column of the trajectory", ""});
    point.knows(key);
    if (point.has(key) && !point.has("trajectory")) point.refuse(key, "this without trajectory", "both or none");
  }
  if (point.has(depth_key) && point.has(speed_key))
    point.refuse(speed_key, "this beside trajectory_depth", "one of the two");
  return point.optional_path("trajectory");
}

RecordedShot recorded_shot(const std::string& path, const TomlTable& point, double speed) {
  const Record record = read_record(path, point);
  const std::vector<Parabola> course = smooth_course(record);
  const auto speed_at = [](const Parabola& at) { return at.speed(0); };
  const Place whole{path, 0, ""};
  const double first = course.front().speed((record.time.front() - course.front().time) / course.front().span);
  if (!(first >= latest_start * speed && first <= fastest_start * speed))
    throw BadInput({path, record.line.front(), ""}, fmt::format("a record that begins with {:.3g} m/s", first),
                   fmt::format("one that begins at impact, with about {:.4g} m/s", speed));
  const auto deepest = std::ranges::max_element(course, {}, [](const Parabola& at) { return at.depth(0); });
  if (speed_at(*deepest) < still * speed)
    return checked({RecordedShot::End::stopped, deepest->depth(0), std::sqrt(deepest->covariance(0, 0))}, whole);
  if (std::ranges::min(course, {}, speed_at).speed(0) > 0.5 * speed)
    return checked({RecordedShot::End::still_faster, std::ranges::max(record.depth), 0}, whole);
  const Parabola& nearest =
      std::ranges::min(course, {}, [&](const Parabola& at) { return std::abs(at.speed(0) - 0.5 * speed); });
  return checked(depth_at_speed(nearest, 0.5 * speed, whole), whole);
}

}  // namespace percal
