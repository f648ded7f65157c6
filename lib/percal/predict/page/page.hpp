// The result of percal predict, as JSON, as a table to go on with, and as a page.              docs/formats/predict.md
#pragma once
#include <string>

#include "percal/page/page.hpp"
#include "percal/page/result.hpp"
#include "percal/predict/prediction.hpp"

namespace percal {

// `result`: the file that the prediction is from, as the user named it.
page::Json prediction_to_json(const Prediction& prediction, const std::string& result);

// A row for each shot, or for each point of the curve; columns with their units.
std::string prediction_to_csv(const Prediction& prediction);

page::Page predict_page(const page::Json& result);

}  // namespace percal
