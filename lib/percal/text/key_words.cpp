#include "percal/text/key_words.hpp"

#include <algorithm>
#include <array>

#include "percal/units/words.hpp"

namespace percal {
namespace {

// What others call it, and its keys here; a document has one of these.
struct Synonym {
  const char* word;
  std::array<const char*, 3> keys;
};
constexpr std::array synonyms{
    Synonym{"velocity", {"speed"}},
    Synonym{"v", {"speed"}},
    Synonym{"impact_velocity", {"speed"}},
    Synonym{"rho", {"density"}},
    Synonym{"r", {"radius"}},
    Synonym{"d", {"diameter"}},
    Synonym{"size", {"diameter", "radius"}},
    Synonym{"calibre", {"diameter", "radius"}},
    Synonym{"caliber", {"diameter", "radius"}},
    Synonym{"weight", {"mass"}},
    Synonym{"g", {"mu"}},
    Synonym{"modulus", {"mu"}},
    Synonym{"shear_modulus", {"mu"}},
    Synonym{"exponent", {"alpha"}},
    Synonym{"e", {"youngs_modulus", "particle_modulus"}},
    Synonym{"young", {"youngs_modulus", "particle_modulus"}},
    Synonym{"elastic_modulus", {"youngs_modulus", "particle_modulus"}},
    Synonym{"poisson", {"nu", "poisson_ratio"}},
    Synonym{"poissons_ratio", {"nu", "poisson_ratio"}},
    Synonym{"thickness", {"depth"}},
    Synonym{"height", {"depth"}},
    Synonym{"penetration", {"depth"}},
    Synonym{"failure_strain", {"strain", "erosion_strain"}},
    Synonym{"projectile", {"particle"}},
    Synonym{"bullet", {"particle"}},
    Synonym{"sphere", {"particle"}},
    Synonym{"material", {"target"}},
    Synonym{"tissue", {"target"}},
    Synonym{"layer", {"target"}},
};

bool is_word_for(const std::string& written, const std::string& key) {
  return std::ranges::any_of(synonyms, [&](const Synonym& one) {
    return lower_case(written) == one.word &&
           std::ranges::any_of(one.keys, [&](const char* other) { return other && key == other; });
  });
}

}  // namespace

std::optional<std::string> key_meant(const std::string& written, const std::vector<std::string>& known) {
  const auto synonym = std::ranges::find_if(known, [&](const std::string& key) { return is_word_for(written, key); });
  return synonym != known.end() ? std::optional(*synonym) : nearest_word(written, known);
}

std::optional<std::string> meant_by(const std::string& wanted, const std::vector<std::string>& written) {
  const auto synonym =
      std::ranges::find_if(written, [&](const std::string& one) { return is_word_for(one, wanted); });
  return synonym != written.end() ? std::optional(*synonym) : nearest_word(wanted, written);
}

}  // namespace percal
