// percal report RESULT: a result as a page; two results side by side.
#include <fmt/format.h>

#include <filesystem>

#include "colour.hpp"
#include "commands.hpp"
#include "pages.hpp"
#include "percal/page/html.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

std::string page_file(const ReportArguments& arguments) {
  if (!arguments.file.empty()) return arguments.file;
  return std::filesystem::path(arguments.results[0]).replace_filename("report.html").string();
}

}  // namespace

Exit run_report(const ReportArguments& arguments, const Common& common) {
  const page::ReadResult first = read_result(arguments.results[0]);
  const page::Page page =
      arguments.results.size() == 1 ? first.page : page::compared(first, read_result(arguments.results[1]));
  if (common.check) {
    if (!common.quiet) print(fmt::format("{}: {}\n", fmt::join(arguments.results, ", "), page.title));
    return Exit::done;
  }
  const std::string file = page_file(arguments);
  ensure_writable_file(file);
  const page::DrawnFigures figures = page::draw_figures(page);
  write_file(file, page::html(page, figures));
  if (!arguments.plots.empty()) page::write_figures(page, arguments.plots, page::Pictures::svg_and_png);
  if (common.quiet) return Exit::done;
  const auto missing = page::figures_of(page).size() - figures.size();
  print(fmt::format("{}: {}\n", file, page.title));
  if (missing > 0)
    fmt::print("{} plots were not drawn, since gnuplot is not there or failed: their points are in tables\n", missing);
  if (!arguments.plots.empty()) print("plots: " + arguments.plots + "\n");
  return Exit::done;
}

}  // namespace percal::tools
