#include "percal/base/printable.hpp"

#include <gtest/gtest.h>

namespace percal {
namespace {

TEST(Printable, WhatMovesATerminalIsShownByItsBytes) {
  EXPECT_EQ(printable("a\033[31mb\007\x7f\rc"), "a\\x1b[31mb\\x07\\x7f\\x0dc");
  EXPECT_EQ(printable("one-byte CSI \xc2\x9b 31m"), "one-byte CSI \\xc2\\x9b 31m");
  EXPECT_EQ(printable("\xff\xc2"), "\\xff\\xc2") << "broken UTF-8";
}

TEST(Printable, WordsStayAsTheyAre) {
  const std::string text = "\u00b5m, \u03b1 = 8.5\n\t\u65e5\u672c \U0001f600 \u00a0";
  EXPECT_EQ(printable(text), text);
}

}  // namespace
}  // namespace percal
