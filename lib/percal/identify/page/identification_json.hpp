// An identification as its result.json: docs/formats/identify.md.
#pragma once
#include "percal/identify/identification.hpp"
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal {

page::Json identification_to_json(const IdentifyJob& job, const Identification& found, const page::Cost& cost);

page::Json comparison_to_json(const IdentifyJob& job, const ComparedNumbers& comparison);

// A comparison of a result, to be shown: page.cpp.
page::Table comparison_table(const page::Json& comparison);

}  // namespace percal
