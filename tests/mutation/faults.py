"""Faults that the tests have to catch, each a text of the sources and what stands in its place. tests: the test programs that are built and run.

A text occurs once in its file; plant.py --check holds that, so that the list does not outlive the code."""
from typing import NamedTuple


class Fault(NamedTuple):
    name: str
    file: str
    text: str
    instead: str
    tests: tuple


FAULTS = [
    Fault("MU1 is taken for mu alpha, not mu alpha/2", "lib/percal/material/conventions.cpp",
          "? mu_as_given * alpha / 2 : mu_as_given", "? mu_as_given * alpha : mu_as_given", ("material", "card", "scene")),
    Fault("J^(-1/3) is missing in the isochoric stretch of the hoop", "lib/percal/impact/kernel/element.hpp",
          "const V hoop = F.hoop * F.hoop * s.inverse_jacobian * F.hoop;", "const V hoop = F.hoop * F.hoop * F.hoop;", ("impact",)),
    Fault("the hourglass force has the wrong sign", "lib/percal/impact/kernel/internal_forces.hpp",
          "solid_.hourglass_force(j, r.hourglass(), z.hourglass())", "solid_.hourglass_force(j, -r.hourglass(), -z.hourglass())", ("impact",)),
    Fault("contact pulls where it should push", "lib/percal/impact/particle/touch.cpp",
          "dot(q) > 0;", "dot(q) < 0;", ("impact",)),
    Fault("a node at the surface takes twice the impulse", "lib/percal/impact/particle/touch.cpp",
          "std::max(0.0, stiffness_of(touch) * (touch.rate + J.dot(q)))", "std::max(0.0, 2 * stiffness_of(touch) * (touch.rate + J.dot(q)))", ("impact",)),
    Fault("the ledger leaves out what contact takes", "lib/percal/impact/particle/touch.cpp",
          "lost -= touch.impulse", "lost -= 0 * touch.impulse", ("impact",)),
    Fault("friction knows no cone", "lib/percal/impact/particle/touch.cpp",
          "std::clamp(touch.mass * sliding(touch, q), -bound, bound)", "touch.mass * sliding(touch, q)", ("impact",)),
    Fault("fibres bear compression", "lib/percal/impact/kernel/fibres.hpp",
          "const auto taut = strain > Real(0);", "const auto taut = strain > Real(-10);", ("impact",)),
    Fault("a stretched layer's stress is taken over the unstretched volume", "lib/percal/impact/kernel/general_solid.hpp",
          "const V r = c.initial_r * c.per_initial_jacobian,", "const V r = c.initial_r,", ("impact",)),
    Fault("of several limits the last one reached decides", "lib/percal/impact/kernel/general_solid.hpp",
          "larger(tension(F, s, P, q) * constants_.per_stress, energy(s, g) * constants_.per_energy)",
          "smaller(tension(F, s, P, q) * constants_.per_stress, energy(s, g) * constants_.per_energy)", ("impact",)),
    Fault("kPa are MPa", "lib/percal/units/quantity.cpp",
          'Unit{"kPa", {dimension::pressure, 1, 3}}', 'Unit{"kPa", {dimension::pressure, 1, 6}}', ("units", "scene")),
    Fault("a similar system's quantity has the inverse power", "lib/percal/scaling/groups.cpp",
          "std::pow(wanted, 1.0 / std::abs(own))", "std::pow(wanted, std::abs(own))", ("scaling",)),
    Fault("95 % intervals are 90 % ones", "lib/percal/estimate/profile.cpp",
          "student_quantile((1 + level) / 2, freedom)", "student_quantile(level, freedom)", ("estimate",)),
    Fault("Green's strain lacks its half", "lib/percal/material/conventions.cpp",
          "return (stretch * stretch - 1) / 2;", "return stretch * stretch - 1;", ("material", "fit", "card")),
    Fault("the pressure of a relaxing test is not that of its free face", "lib/percal/material/isochoric.cpp",
          ".to_nominal = {std::exp(along), -std::exp(2 * normal - along)}", ".to_nominal = {std::exp(along), -std::exp(normal - along)}", ("fit",)),
    Fault("a step of a hereditary integral takes all that is new", "lib/percal/material/prony.cpp",
          "const double taken = -std::expm1(-x) / x;", "const double taken = 1;", ("fit",)),
    Fault("second Piola stress is taken for nominal", "lib/percal/fit/read/curve_measures.cpp",
          "? strained.amount * stress : stress", "? stress : stress", ("fit",)),
    Fault("replicates do not walk the phase of the mesh", "lib/percal/problem/replicates.cpp",
          "from_middle * walk_span(elements_per_radius) / count", "0 * from_middle * walk_span(elements_per_radius) / count", ("problem",)),
    Fault("graded columns grow by another factor than they say", "lib/percal/mesh/graded.cpp",
          "at += width *= mesh.growth", "at += width *= 1.05 * mesh.growth", ("mesh",)),
    Fault("heavy fast shots get the wall of light ones", "lib/percal/scene/width.cpp",
          "density_ratio > heavy_above ? farthest_wall : far_wall", "density_ratio > heavy_above ? far_wall : far_wall", ("scene",)),
    Fault("the stable step forgets the hoop", "lib/percal/impact/kernel/element.hpp",
          "const V w3 = per_hoop2 * s.inverse_hoop * s.inverse_hoop;", "const V w3 = Real(0) * per_hoop2 * s.inverse_hoop * s.inverse_hoop;", ("impact",)),
    Fault("Dehn's depth has the wrong slope along the strength", "lib/percal/invert/dehn.cpp",
          "const double strength = -q / ((1 + q) * logarithm);", "const double strength = q / ((1 + q) * logarithm);", ("invert", "calibrate")),
    Fault("K is chosen for another Mach number", "lib/percal/problem/reduce.cpp",
          "1.01 * pi4 / (recommended_mach * recommended_mach)", "1.01 * pi4 / recommended_mach", ("problem", "scene")),
    Fault("erosion is averaged with weights that do not fall", "lib/percal/impact/target/averaged_erosion.cpp",
          "return inside * inside;", "return inside > 0 ? 1.0 : 0.0;", ("impact",)),
    Fault("cards write mu where the program wants 2 mu/alpha", "lib/percal/card/card_material.cpp",
          "case CardModulus::two_mu_over_alpha: return 2 * term.mu / term.alpha;", "case CardModulus::two_mu_over_alpha: return term.mu;", ("card",)),
    Fault("the speed behind a layer is that of the step's end", "lib/percal/impact/march/layer_speeds.hpp",
          "before_.speed + share * (now.speed - before_.speed)", "now.speed", ("impact",)),
    Fault("fragments are taken for the channel's wall", "lib/percal/impact/march/channel_record.hpp",
          "while (right > 0 && is_alive(right - 1)) --right;", "while (right > 0 && !is_alive(columns - right)) --right; right = columns - right;", ("impact",)),
    Fault("the implied rate factor works the wrong way", "lib/percal/calibrate/verdict.cpp",
          "rate.implied = {rate.given * std::exp(joined.at[factor])", "rate.implied = {rate.given * std::exp(-joined.at[factor])", ("calibrate",)),
    Fault("a search sees one phase of the mesh", "lib/percal/one_depth/one_depth.cpp",
          "phases[answer++ % usual_replicates]", "phases[0 * answer++]", ("one_depth",)),
    Fault("a swept group forgets how the scene means its modulus", "lib/percal/sweep/group_change.cpp",
          "return modulus_as_given(number, *system.system.alpha, system.convention);", "return number;", ("sweep",)),
    Fault("a claim is never refused", "lib/percal/store/claims.cpp",
          "return !is_held_by_another();", "return true;", ("store", "campaign")),
]
