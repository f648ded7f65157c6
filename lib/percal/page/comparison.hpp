// Two results of the same command side by side.
#pragma once
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal::page {

struct ReadResult {
  std::string file;
  Json json;
  Page page;
};

// What was asked differently, what came out differently beside both errors, the figures of both in one. Throws BadInput where they
// are of different commands.
Page compared(const ReadResult& first, const ReadResult& second);

}  // namespace percal::page
