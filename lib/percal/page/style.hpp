// The style sheet of a page.
#pragma once

namespace percal::page {

// For wide and narrow screens, light and dark, and print.
extern const char* const style_sheet;

}  // namespace percal::page
