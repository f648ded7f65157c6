#include "percal/scaling/groups.hpp"

#include <algorithm>
#include <cmath>

namespace percal {
namespace {

double power(double base, int exponent) {
  double result = 1;
  for (int i = 0; i < std::abs(exponent); ++i) result *= base;
  return exponent < 0 ? 1 / result : result;
}

}  // namespace

std::span<const Group> groups() {
  using enum GroupKind;
  // clang-format off
  static const std::vector<Group> all = {
      {1, "pi1", "target depth", "L / a", geometry,
       {{&System::depth, 1}, {&System::radius, -1}}},
      {2, "pi2", "target width", "w / a", geometry,
       {{&System::width, 1}, {&System::radius, -1}}},
      {3, "pi3", "inertia over particle stiffness", "rho_p v^2 / E", material,
       {{&System::particle_density, 1}, {&System::speed, 2}, {&System::particle_modulus, -1}}},
      {4, "pi4", "inertia over target stiffness", "rho_t v^2 / mu", material,
       {{&System::target_density, 1}, {&System::speed, 2}, {&System::mu, -1}}},
      {5, "pi5", "density ratio", "rho_t / rho_p", material,
       {{&System::target_density, 1}, {&System::particle_density, -1}}},
      {6, "pi6", "strain hardening", "alpha", material,
       {{&System::alpha, 1}}},
      {7, "pi7", "erosion strain", "eps_t", material,
       {{&System::erosion_strain, 1}}},
      {8, "pi8", "penetration", "P_d / a", response,
       {{&System::penetration, 1}, {&System::radius, -1}}},
      {9, "pi9", "strain rate", "rate a / v", response,
       {{&System::strain_rate, 1}, {&System::radius, 1}, {&System::speed, -1}}},
      {10, "pi10", "time", "t v / a", response,
       {{&System::time, 1}, {&System::speed, 1}, {&System::radius, -1}}},
  };
  // clang-format on
  return all;
}

const Group& group(int number) { return groups()[static_cast<std::size_t>(number - 1)]; }

std::vector<std::string> missing_for(const Group& group, const System& system) {
  std::vector<std::string> missing;
  for (const auto& factor : group.factors)
    if (!(system.*factor.member)) missing.push_back(system_quantity(factor.member).key);
  return missing;
}

std::optional<double> value(const Group& group, const System& system) {
  double product = 1;
  for (const auto& factor : group.factors) {
    if (!(system.*factor.member)) return std::nullopt;
    product *= power(*(system.*factor.member), factor.power);
  }
  return product;
}

std::optional<double> solve(const Group& group, double group_value, std::optional<double> System::*member,
                            const System& system) {
  double others = 1;
  int own = 0;
  for (const auto& factor : group.factors) {
    if (factor.member == member) {
      own = factor.power;
    } else {
      if (!(system.*factor.member)) return std::nullopt;
      others *= power(*(system.*factor.member), factor.power);
    }
  }
  if (own == 0) return std::nullopt;
  double wanted = group_value / others;  // = number^own
  if (own < 0) wanted = 1 / wanted;
  return std::abs(own) == 1 ? wanted : std::pow(wanted, 1.0 / std::abs(own));
}

std::string word(Agreement agreement) {
  switch (agreement) {
    case Agreement::agree: return "agree";
    case Agreement::differ: return "differ";
    case Agreement::missing: break;
  }
  return "missing";
}

std::vector<Comparison> compare(const System& prototype, const System& model, double tolerance) {
  std::vector<Comparison> all;
  for (const auto& group : groups()) {
    Comparison one{.group = &group,
                   .prototype = value(group, prototype),
                   .model = value(group, model),
                   .missing_in_prototype = missing_for(group, prototype),
                   .missing_in_model = missing_for(group, model),
                   .agreement = Agreement::missing,
                   .difference = std::nullopt};
    if (one.prototype && one.model) {
      if (*one.prototype != 0) one.difference = *one.model / *one.prototype - 1;
      bool agree = one.difference ? std::abs(*one.difference) <= tolerance : *one.model == 0;
      one.agreement = agree ? Agreement::agree : Agreement::differ;
    }
    all.push_back(one);
  }
  return all;
}

std::optional<double> particle_compliance(const System& system) {
  if (!system.target_density || !system.speed || !system.mu || !system.particle_modulus) return std::nullopt;
  return (*system.target_density * *system.speed * *system.speed + 10 * *system.mu) / *system.particle_modulus;
}

}  // namespace percal
