// Single shots: predicted from a calibration, inverted by themselves. Words in, a result.json out.
#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>

#include "core.hpp"
#include "page_of_result.hpp"
#include "percal/campaign/run_cost.hpp"
#include "percal/one_depth/page/page.hpp"
#include "percal/predict/page/page.hpp"
#include "percal/text/json.hpp"

namespace percal::python {
namespace {

namespace py = pybind11;
using Said = std::map<std::string, std::string>;
using Clock = std::chrono::steady_clock;

template <class Words>
Words words_from(const Said& said, const std::optional<double>& level) {
  Words words;
  const auto texts = named_texts(words);
  for (const auto& [name, text] : said) {
    const auto place = std::ranges::find_if(texts, [&](const NamedText& one) { return one.first == name; });
    if (place == texts.end()) throw py::type_error("unexpected keyword argument '" + name + "'");
    *place->second = text;
  }
  words.level = level;
  return words;
}

std::string predicted(const std::string& result_text, const std::string& file, const Said& said,
                      const std::optional<double>& level, bool v50, bool verify, const std::string& store_path,
                      int threads) {
  const auto start = Clock::now();
  auto words = words_from<PredictWords>(said, level);
  words.v50 = v50;
  std::string result;
  interruptible([&](const std::atomic<bool>& stop) {
    const page::Json calibration = parse_json(result_text, file, "a result of percal calibrate");
    tools::check_result(calibration, file);
    const ShotModel model = kept_shot_model(calibration, file);
    Prediction prediction = predict(model, understood(words, model));
    prediction.cost.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (verify) {
      Store store(store_path);
      Campaign campaign(&store, threads);
      campaign.stop_when([&] { return stop.load(); });
      check_by_runs(prediction, model, campaign);
      prediction.cost = cost_since(start, campaign);
    }
    result = text_of(prediction_to_json(prediction, file));
  });
  return result;
}

std::string inverted(const Said& said, const std::optional<double>& level, const std::string& store_path, int threads) {
  const auto start = Clock::now();
  const auto words = words_from<InvertWords>(said, level);
  std::string result;
  interruptible([&](const std::atomic<bool>& stop) {
    const InvertRequest request = understood(words);
    Store store(store_path);
    Campaign campaign(&store, threads);
    campaign.stop_when([&] { return stop.load(); });
    OneDepth found = find_at_depth(request, campaign);
    found.cost = cost_since(start, campaign);
    result = text_of(one_depth_to_json(found));
  });
  return result;
}

}  // namespace

void bind_shots(py::module_& core) {
  core.def("predict", &predicted);
  core.def("invert", &inverted);
}

}  // namespace percal::python
