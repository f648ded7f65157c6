// A page as Markdown: sections, tables and lists; figures as links to NAME.svg in a folder.
#pragma once
#include <string>

#include "percal/page/page.hpp"

namespace percal::page {

// Sections of the wanted detail. `figures`: the folder of the figures' files, as the document will see it.
std::string markdown(const Page& page, Detail detail, const std::string& figures);

}  // namespace percal::page
