#include "impact_views.hpp"

#include <filesystem>

#include "percal/base/error.hpp"
#include "percal/plot/gnuplot.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {

void check_views(const ImpactArguments& arguments, const Common& common) {
  if (!arguments.fields.empty()) parse_field_interval(arguments.fields, "--fields");
  if (!arguments.fields.empty() && common.out == "none")
    throw BadInput(Place{.file = "", .line = 0, .key = "--fields"}, "no folder for them (--out none)",
                   "--out FOLDER, or none of --out");
  if (!arguments.picture.empty()) picture_format(arguments.picture, "--picture");
}

void ensure_views_can_be_made(const ImpactArguments& arguments) {
  if (arguments.picture.empty()) return;
  ensure_writable_file(arguments.picture);
  if (!gnuplot("set print '-'\nprint 'here'\n"))
    throw IoFailure("--picture: gnuplot, which draws it, cannot be run; on Debian it is the package gnuplot-nox");
}

ImpactViews::ImpactViews(const ImpactArguments& arguments, const std::string& folder, const Reduction& reduction)
    : reduction_(reduction), picture_(arguments.picture) {
  if (arguments.fields.empty()) return;
  series_.emplace((std::filesystem::path(folder) / "fields").string(),
                  std::filesystem::path(arguments.scene).stem().string(),
                  parse_field_interval(arguments.fields, "--fields"), reduction.problem, reduction.scales);
}

std::optional<WrittenFields> ImpactViews::fields() const {
  return series_ ? std::optional(WrittenFields{series_->list(), series_->frames()}) : std::nullopt;
}

void ImpactViews::see(const Frame& frame) {
  if (series_) series_->see(frame);
  if (frame.is_last && !picture_.empty()) last_ = frame;
}

void ImpactViews::draw(const std::string& title) const {
  if (picture_.empty()) return;
  const auto picture = gnuplot(
      picture_script(*last_, reduction_.problem, reduction_.scales, picture_format(picture_, "--picture"), title));
  if (!picture) throw IoFailure(picture_ + ": gnuplot could not draw the picture");
  write_file(picture_, *picture);
}

}  // namespace percal::tools
