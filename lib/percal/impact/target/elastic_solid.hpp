// What a layer's elements are made of, in plain numbers, for whoever looks at single ones: matrix and fibres.
#pragma once
#include "percal/impact/kernel/element.hpp"
#include "percal/impact/kernel/fibres.hpp"

namespace percal {

struct ElasticSolid {
  scalar::ElasticConstants matrix;
  FibreConstants fibres = {};

  // Per undeformed volume.
  double energy_density(const scalar::Gradient<double>& F) const {
    const auto s = scalar::stretches(F);
    const double energy = scalar::strain_energy(matrix, s, scalar::isochoric_powers(F, s, matrix.alpha));
    return fibres.is_none() ? energy : energy + response(F, s).energy;
  }
  scalar::Piola<double> first_piola(const scalar::Gradient<double>& F) const {
    const auto s = scalar::stretches(F);
    const auto P = scalar::elastic_piola(matrix, F, s, scalar::isochoric_powers(F, s, matrix.alpha));
    return fibres.is_none() ? P : P + response(F, s).stress;
  }

 private:
  scalar::FibreResponse<double> response(const scalar::Gradient<double>& F, const scalar::Stretches<double>& s) const {
    return scalar::fibre_response(F, s, fibres.k1, fibres.k2, fibres.kappa);
  }
};

}  // namespace percal
