// problem: the same impact without dimensions.
//
// A scene becomes a Problem in which particle radius, impact speed and target density are 1; similar systems are one
// problem, bit for bit. Lists what is left out and why.
//
//     const percal::Reduction reduction = percal::reduce(scene);
//     for (const auto& omission : reduction.left_out) std::cout << omission.what << ": " << omission.why << "\n";
//
// See docs/theory/impact.md.
#pragma once
#include "percal/problem/choices.hpp"
#include "percal/problem/domain.hpp"
#include "percal/problem/particle.hpp"
#include "percal/problem/problem.hpp"
#include "percal/problem/replicates.hpp"
