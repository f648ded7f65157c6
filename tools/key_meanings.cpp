#include "key_reference.hpp"

namespace percal::tools {

const std::vector<KeyMeaning>& key_meanings() {
  static const std::vector<KeyMeaning> all = [] {
    std::vector<KeyMeaning> meanings;
    for (const auto& some : {scene_meanings(), scale_meanings(), identify_meanings(), calibrate_meanings()})
      meanings.insert(meanings.end(), some.begin(), some.end());
    return meanings;
  }();
  return all;
}

}  // namespace percal::tools
