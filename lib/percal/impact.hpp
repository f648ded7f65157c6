// impact: the explicit finite-element solver.
//
// Runs one dimensionless problem: forces, contact, erosion, energy ledger, time step. Same input, same bits, at any
// number of threads. Most users want the layer campaign, which runs many and keeps them.
//
//     const percal::ImpactResult run = percal::run_impact(problem, 1);
//     if (run.outcome == percal::Outcome::stopped) std::cout << run.depth << " radii\n";
//
// See docs/theory/impact.md.
#pragma once
#include "percal/impact/kernel/kernel.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/impact/result.hpp"
#include "percal/impact/target/size.hpp"
