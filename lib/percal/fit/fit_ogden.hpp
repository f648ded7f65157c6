// mu and alpha of the one-term Ogden solid: fit_ogden.
#pragma once
#include "percal/fit/fit_curves.hpp"
