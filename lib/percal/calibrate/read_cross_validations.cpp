// [[cross_validation]].
#include <algorithm>
#include <set>

#include "percal/calibrate/job_fit.hpp"
#include "percal/calibrate/read_job.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// What shots have to say about a column, for messages.
std::string values_of(const CalibrationJob& job, const std::string& column) {
  std::set<std::string> values, columns{"set"};
  for (const MeasuredShot& shot : job.shots) {
    for (const auto& [name, cell] : shot.row) columns.insert(name);
    if (column == "set") values.insert(in_quotes(job.sets[shot.set].name));
    if (const auto cell = shot.row.find(column); cell != shot.row.end()) values.insert(in_quotes(cell->second));
  }
  if (values.empty()) return "a column of the shots' tables: " + listed({columns.begin(), columns.end()});
  return column + " with one of " + listed({values.begin(), values.end()});
}

ShotFilter filter_from(const TomlTable& block, const std::string& key, const CalibrationJob& job) {
  ShotFilter filter;
  for (const std::string& condition : block.texts(key)) {
    const auto equals = condition.find('=');
    if (equals == std::string::npos) block.refuse(key, in_quotes(condition), "\"COLUMN=VALUE\" or \"set=NAME\"");
    const std::string column = trimmed(condition.substr(0, equals));
    filter.push_back(column + "=" + trimmed(condition.substr(equals + 1)));
    if (chosen(job, {filter.back()}).empty())
      block.refuse(key, in_quotes(condition) + ", which no shot meets", values_of(job, column));
  }
  if (chosen(job, filter).empty())
    block.refuse(key, "conditions that no shot meets together", "conditions that some shot meets");
  return filter;
}

std::vector<int> hypotheses_from(const TomlTable& block, const CalibrationJob& job) {
  std::vector<int> hypotheses;
  const std::string key = block.has("readings") ? "readings" : "hypotheses";  // the older spelling
  if (!block.has(key)) return hypotheses;
  for (const std::string& name : block.texts(key)) {
    const auto found =
        std::find_if(job.hypotheses.begin(), job.hypotheses.end(), [&](const auto& r) { return r.name == name; });
    if (found == job.hypotheses.end())
      block.refuse(key, in_quotes(name), "hypotheses of the job: " + names_of(job.hypotheses));
    hypotheses.push_back(static_cast<int>(found - job.hypotheses.begin()));
  }
  return hypotheses;
}

void check_apart(const TomlTable& block, const CalibrationJob& job, const CrossValidation& wanted) {
  const auto fitted = chosen(job, wanted.fit);
  for (const int shot : chosen(job, wanted.predict))
    if (std::find(fitted.begin(), fitted.end(), shot) != fitted.end())
      block.refuse("predict", "the shot " + in_quotes(job.shots[shot].label) + ", which is fitted too",
                   "shots that are not among the fitted");
}

}  // namespace

void read_cross_validations(const TomlTable& root, CalibrationJob& job) {
  for (const TomlTable& block : root.tables("cross_validation")) {
    CrossValidation wanted{.name = block.text("name"),
                           .fit = filter_from(block, "fit", job),
                           .predict = filter_from(block, "predict", job),
                           .hypotheses = hypotheses_from(block, job),
                           .goal = optional_share_from(block, "goal", positive("share"))};
    check_apart(block, job, wanted);
    for (const CrossValidation& other : job.cross_validations)
      if (other.name == wanted.name) block.refuse("name", in_quotes(wanted.name) + " again", "a name of its own");
    job.cross_validations.push_back(std::move(wanted));
  }
}

}  // namespace percal
