// Impact in three dimensions: blocks of bricks under rigid bodies.
#pragma once
#include "percal/solid/march/march.hpp"
