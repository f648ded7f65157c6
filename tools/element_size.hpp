// percal card write --element-size: the card's erosion strain for the user's own elements.
#pragma once
#include "commands.hpp"
#include "percal/campaign/strain_at_size.hpp"
#include "percal/card/card_material.hpp"

namespace percal::tools {

// The strain with which a shot of the card's result, one of the scenes beside it, goes as deep on elements of this size. Nothing with
// --check. Throws BadInput for a result without scenes, a shot that is none of this card's, a size out of range.
std::optional<StrainAtSize> strain_for_elements(const CardArguments& card, const CardMaterial& material,
                                                const Common& common);

// "erosion strain 0.52 +- 0.02 (95 %) for elements of 100 um: with it ... goes as deep (12.3 mm) as with 0.58 on 50 um"
std::string in_words(const StrainAtSize& found);

}  // namespace percal::tools
