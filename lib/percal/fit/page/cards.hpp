// The material card of a fit, without what curves do not tell.                                       docs/formats/cards.md
#pragma once
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/fit/interval/uncertainty.hpp"

namespace percal {

CardInterval card_interval(const std::string& parameter, const Interval& interval);

// Of the best minimum, none without one: density and bulk modulus are not known, its name is "fit" or, where rows were chosen
// (`where`, COLUMN=VALUE), their values: "Ecoflex 00-30". Intervals where `uncertainty` has them. `data`, `fit` and `uncertainty` belong
// together.
std::vector<CardMaterial> fit_cards(const CurveData& data, const CurveFit& fit, const Uncertainty& uncertainty,
                                    const std::vector<std::string>& where);

}  // namespace percal
