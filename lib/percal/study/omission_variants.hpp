// The scenes of the audit of omissions: each is the scene with one thing switched on that it leaves out, or with one setting
// changed.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/problem/problem.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// physics: something that a scene may have; domain: where the layer ends; numerics: how it is computed.
enum class OmissionKind { physics, domain, numerics };
std::string word(OmissionKind kind);

struct OmissionVariant {
  std::string name;
  OmissionKind kind;
  std::string how;       // what was changed, with its figures
  std::string left_out;  // the LeftOut::what that it switches back on; empty where there is none
  bool is_illustration;  // the figures are not the scene's own: what such a thing would be worth
  Scene scene;
};

struct SkippedVariant {
  std::string name;
  OmissionKind kind;
  std::string why;
  std::string left_out;
};

struct OmissionPlan {
  std::vector<OmissionVariant> variants;
  std::vector<SkippedVariant> skipped;
};

// Every variant passes the scene reader's checks; what does not is skipped with the reader's words. `depth`, m, is the
// baseline's penetration, in whose middle an illustrated second layer begins; without it, in the middle of the target.
OmissionPlan plan_omissions(const Scene& scene, const Reduction& baseline, const std::optional<double>& depth);

}  // namespace percal
