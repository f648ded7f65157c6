// What a block is made of: impact/target/constants.hpp, with an initial stretch of two directions.
#pragma once
#include "percal/impact/target/constants.hpp"
#include "percal/solid/kernel/hexahedron.hpp"
#include "percal/solid/kernel/kernel.hpp"

namespace percal {

// The layers of a block take whole rows, by the nearest plane of nodes; the last one takes what is left.
std::vector<LayerRows> layers_of_block(const Problem& problem, const std::vector<double>& depths);

TargetSolid solid_of_block(const Problem& problem, const std::vector<LayerRows>& rows);

LayeredSolidView view_of(const TargetSolid& solid);

// Of one brick's solid over its own reference, fibres too.
scalar::hex::Tensor<double> first_piola(const MaterialConstants&, const scalar::hex::Tensor<double>& F);
double energy_density(const MaterialConstants&, const scalar::hex::Tensor<double>& F);
scalar::hex::Symmetric<double> kirchhoff(const MaterialConstants&, const scalar::hex::Tensor<double>& F,
                                         const scalar::hex::Deformation<double>&);

// What erosion is judged by (LayeredBrick::erosion_measure), and the shares of (lambda^2 - 1), tension and energy in their limits.
double erosion_measure(const TargetSolid&, int row, const scalar::hex::Tensor<double>& F);
std::array<double, 3> shares_of_limits(const TargetSolid&, int row, const scalar::hex::Tensor<double>& F);

scalar::hex::Tensor<double> gradient_of_stretch(const InitialStretch& initial);  // r is x, hoop is y

}  // namespace percal
