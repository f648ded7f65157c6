// percal predict RESULT: shots that were not fired, from a finished calibration.
#include <chrono>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "pages.hpp"
#include "percal/campaign/run_cost.hpp"
#include "percal/predict/page/page.hpp"
#include "percal/predict/prediction.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {

Exit run_predict(const PredictArguments& arguments, const Common& common) {
  const auto start = std::chrono::steady_clock::now();
  const NamedResult result = read_json_result(arguments.result);
  const ShotModel model = kept_shot_model(result.json, result.file);
  const PredictRequest request = understood(arguments.words, model);
  if (common.check)
    return say_valid(arguments.result + ": a calibration that can predict this",
                     {{"command", "predict"}, {"result", arguments.result}}, common);
  const std::string folder = common.out.empty() ? "" : out_folder(arguments.result, common);
  Prediction prediction = predict(model, request);
  prediction.cost.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (arguments.verify) {
    Store store(store_file(common));
    Campaign campaign(&store, common.threads);
    check_by_runs(prediction, model, campaign);
    prediction.cost = cost_since(start, campaign);
  }
  const page::Json json = prediction_to_json(prediction, arguments.result);
  deliver(json, folder, common);
  if (!folder.empty()) write_file(folder + "/shots.csv", prediction_to_csv(prediction));
  write_page_figures(predict_page(json), folder, common);
  return prediction.solved && !prediction.solved->found ? Exit::outcome_not_reached : Exit::done;
}

}  // namespace percal::tools
