// Frames of a run as a series that ParaView opens: NAME.pvd, target_0000.vtu, particle_0000.vtu, ... in SI.
// docs/formats/fields.md.
#pragma once
#include <string>
#include <vector>

#include "percal/impact/frame.hpp"
#include "percal/observe/schedule.hpp"
#include "percal/observe/vtu.hpp"

namespace percal {

// m, s, m/s, Pa, J/m3; z = 0. Of a block: its cut.
VtuMesh target_fields(const Frame& frame, const Problem& problem, const Scales& scales);
VtuMesh particle_fields(const Frame& frame, const Scales& scales);

// Writes each frame as it comes, of a block in space; memory holds one at a time. The list names only frames that are whole on the disk.
class FieldSeries : public FrameObserver {
 public:
  // Takes away what an earlier series left in `folder` under the same names. Throws IoFailure where files cannot be written there.
  FieldSeries(std::string folder, const std::string& name, const FieldInterval& interval, const Problem& problem,
              const Scales& scales);

  bool is_due(const Moment& now) override { return schedule_.is_due(now); }
  // Throws IoFailure.
  void see(const Frame& frame) override;

  const std::string& list() const { return list_; }  // path of NAME.pvd
  std::size_t frames() const { return written_.size(); }

 private:
  std::string folder_, list_;
  Problem problem_;
  Scales scales_;
  FieldSchedule schedule_;
  std::vector<PvdEntry> written_;
};

}  // namespace percal
