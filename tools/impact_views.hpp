// Fields and picture of the middle replicate, where they were asked for.
#pragma once
#include <optional>
#include <string>

#include "commands.hpp"
#include "percal/observe/fields.hpp"
#include "percal/observe/page/impact_json.hpp"
#include "percal/observe/picture.hpp"

namespace percal::tools {

// Throws BadInput for what cannot be meant.
void check_views(const ImpactArguments& arguments, const Common& common);

// Before anything is computed. Throws IoFailure where the picture could not be written, or gnuplot is not there to draw it.
void ensure_views_can_be_made(const ImpactArguments& arguments);

class ImpactViews : public FrameObserver {
 public:
  // Fields go to `folder`/fields. Throws IoFailure where that cannot be written to.
  ImpactViews(const ImpactArguments& arguments, const std::string& folder, const Reduction& reduction);

  FrameObserver* observer() { return series_ || !picture_.empty() ? this : nullptr; }
  bool is_due(const Moment& now) override { return series_ && series_->is_due(now); }
  void see(const Frame& frame) override;

  // After the run. Throws IoFailure.
  void draw(const std::string& title) const;

  std::optional<WrittenFields> fields() const;

 private:
  const Reduction& reduction_;
  std::string picture_;
  std::optional<FieldSeries> series_;
  std::optional<Frame> last_;
};

}  // namespace percal::tools
