// percal report RESULT: a result as a page; two results side by side; a calibration as a page to play with.
#include <fmt/format.h>

#include <filesystem>

#include "colour.hpp"
#include "commands.hpp"
#include "pages.hpp"
#include "percal/base/child_process.hpp"
#include "percal/page/html.hpp"
#include "percal/predict/explore/explorer.hpp"
#include "percal/predict/shot_words.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

// Beside the result, unless the arguments say where.
std::string page_file(const ReportArguments& arguments, const std::string& result) {
  if (!arguments.file.empty()) return arguments.file;
  return std::filesystem::path(result).replace_filename(arguments.explore ? "explore.html" : "report.html").string();
}

// Shows the page in the user's browser. Throws IoFailure where xdg-open is not there or fails.
void open_page(const std::string& file) {
  std::string program = "xdg-open", page = std::filesystem::absolute(file).string();
  char* words[] = {program.data(), page.data(), nullptr};
  const auto child = start_program(words);
  if (!child) throw IoFailure("--open: there is no xdg-open here: open " + file + " in a browser");
  if (!ends_well(*child)) throw IoFailure("--open: xdg-open failed: open " + file + " in a browser");
}

void say_written(const ReportArguments& arguments, const std::string& file, const page::Page& page,
                 const page::DrawnFigures& figures) {
  const auto missing = page::figures_of(page).size() - figures.size();
  print(fmt::format("{}: {}\n", file, page.title));
  if (missing > 0)
    fmt::print("{} plots were not drawn, since gnuplot is not there or failed: their points are in tables\n", missing);
  if (!arguments.plots.empty()) print("plots: " + arguments.plots + "\n");
}

Exit run_explore(const ReportArguments& arguments, const Common& common) {
  if (arguments.results.size() != 1) refuse_option("--explore", "two results", "one, of percal calibrate");
  if (!arguments.plots.empty()) refuse_option("--plots", "this beside --explore", "one of the two");
  const NamedResult read = read_json_result(arguments.results.front());
  const ShotModel model = of_spheres(kept_shot_model(read.json, read.file), read.file);
  const std::string file = page_file(arguments, read.file);
  if (!common.check) ensure_writable_file(file);
  const std::string page = explorer_page(model, read.file);
  if (!common.check) write_file(file, page);
  if (!common.quiet) print(fmt::format("{}: a page to play with\n", common.check ? read.file : file));
  if (arguments.open && !common.check) open_page(file);
  return Exit::done;
}

}  // namespace

Exit run_report(const ReportArguments& arguments, const Common& common) {
  if (arguments.explore) return run_explore(arguments, common);
  const page::ReadResult first = read_result(arguments.results[0]);
  const page::Page page =
      arguments.results.size() == 1 ? first.page : page::compared(first, read_result(arguments.results[1]));
  if (common.check) {
    if (!common.quiet) print(fmt::format("{}: {}\n", fmt::join(arguments.results, ", "), page.title));
    return Exit::done;
  }
  const std::string file = page_file(arguments, first.file);
  ensure_writable_file(file);
  const page::DrawnFigures figures = page::draw_figures(page);
  write_file(file, page::html(page, figures));
  if (!arguments.plots.empty()) page::write_figures(page, arguments.plots, page::Pictures::svg_and_png);
  if (!common.quiet) say_written(arguments, file, page, figures);
  if (arguments.open) open_page(file);
  return Exit::done;
}

}  // namespace percal::tools
