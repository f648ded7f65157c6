// study: error against run time, omissions, extremes.
//
// A ladder of meshes and what it converges to; everything left out switched back on, one at a time; 122 extreme
// impacts.
//
// See docs/theory/errors.md, docs/formats/study.md.
#pragma once
#include "percal/study/advised_setting.hpp"
#include "percal/study/error_vs_time.hpp"
#include "percal/study/extremes.hpp"
#include "percal/study/kept_ladder.hpp"
#include "percal/study/ladder.hpp"
#include "percal/study/omissions.hpp"
#include "percal/study/page/error_vs_time.hpp"
#include "percal/study/page/extremes.hpp"
#include "percal/study/page/omissions.hpp"
