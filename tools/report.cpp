// percal report RESULT: a result as a page; two results side by side.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "percal/plot/gnuplot.hpp"
#include "percal/report/html.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

using Json = nlohmann::json;

Json read_result(const std::string& file) {
  try {
    return Json::parse(read_file(file));
  } catch (const Json::parse_error& error) {
    throw BadInput({file, 0, ""}, "no JSON (byte " + std::to_string(error.byte) + ")",
                   "the result.json of a command of percal");
  }
}

Page page_of(const std::vector<std::string>& files) {
  const Json first = read_result(files[0]);
  if (files.size() == 1) return page_of_result(first, files[0]);
  return page_of_comparison(first, files[0], read_result(files[1]), files[1]);
}

std::string page_file(const ReportArguments& arguments) {
  if (!arguments.file.empty()) return arguments.file;
  return std::filesystem::path(arguments.results[0]).replace_filename("report.html").string();
}

// NAME.csv, NAME.svg and NAME.png of every figure.
void write_plots(const Page& page, const std::string& folder) {
  for (const PageSection& section : page.sections)
    for (const PageBlock& block : section.blocks) {
      const auto* figure = std::get_if<PageFigure>(&block);
      if (!figure) continue;
      const Plot plot = plot_of(figure->name, figure->chart);
      const std::string file = (std::filesystem::path(folder) / plot.name).string();
      write_file(file + ".csv", plot.csv);
      if (const auto svg = draw_svg(plot)) write_file(file + ".svg", *svg);
      if (const auto png = draw_png(plot)) write_file(file + ".png", *png);
    }
}

int figures_of(const Page& page) {
  int count = 0;
  for (const PageSection& section : page.sections)
    for (const PageBlock& block : section.blocks) count += std::holds_alternative<PageFigure>(block);
  return count;
}

}  // namespace

Exit run_report(const ReportArguments& arguments, const Common& common) {
  const Page page = page_of(arguments.results);
  if (common.check) {
    if (!common.quiet) fmt::print("{}: {}\n", fmt::join(arguments.results, ", "), page.title);
    return Exit::done;
  }
  const std::string file = page_file(arguments);
  const DrawnFigures figures = draw_figures(page);
  write_file(file, html(page, figures));
  if (!arguments.plots.empty()) write_plots(page, arguments.plots);
  if (common.quiet) return Exit::done;
  const int missing = figures_of(page) - static_cast<int>(figures.size());
  fmt::print("{}: {}\n", file, page.title);
  if (missing > 0)
    fmt::print("{} plots were not drawn, since gnuplot is not there or failed: their points are in tables\n", missing);
  if (!arguments.plots.empty()) fmt::print("plots: {}\n", arguments.plots);
  return Exit::done;
}

}  // namespace percal::tools
