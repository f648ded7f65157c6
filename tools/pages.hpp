// Results as they are read and delivered.
#pragma once
#include <optional>
#include <string>

#include "commands.hpp"
#include "page_of_result.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/page/comparison.hpp"
#include "percal/page/text.hpp"
#include "percal/scene/scene.hpp"

namespace percal::tools {

// Of such a file. Throws BadInput where it is no result of this percal.
struct NamedResult {
  std::string file;
  page::Json json;
};
NamedResult read_json_result(const std::string& path);

// The same with its page. Throws BadInput as page_of_result() does.
page::ReadResult read_result(const std::string& path);

// What every command ends with: result.json in the folder (nowhere where that is empty), then on standard output the result as JSON
// (--json), or its page as text, the answer alone or all of it (--details), or nothing (--quiet). Throws IoFailure.
void deliver(const page::Json& result, const std::string& folder, const Common& common);

// The page's figures in the folder, with a word where gnuplot could not draw them; nothing where there is no folder. Throws IoFailure.
void write_page_figures(const page::Page& page, const std::string& folder, const Common& common);

// FOLDER/scenes/NAME.toml, to be run by percal impact; nothing where there is no folder. Throws IoFailure.
void write_scene(const Scene& scene, const std::string& comment, const std::string& name, const std::string& folder);

// What --check ends with: the words ("job.toml: a job that can be run"), or as JSON `answer`, that it is valid, and the size of the
// largest run.
Exit say_valid(const std::string& words, page::Json answer, const Common& common,
               const std::optional<RunSize>& largest = {});

// Standard output as it is: the terminal's columns and colours.
page::TextStyle terminal_style(page::Detail detail);

}  // namespace percal::tools
