// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/MechanismTouch.h"
#include "haptics/session/path/PathKind.h"

namespace palpate
{
namespace
{

class WireAlongPath final : public PathKind
{
public:
  explicit WireAlongPath(std::unique_ptr<MechanismTouch> touch) : touch_(std::move(touch)) {}

  [[nodiscard]] std::vector<PathColumn> columns() const override
  {
    return { { "Torque", 3 }, { "Pushed", 1 }, { "Turned", 1 }, { "Tip Force", 1 }, { "Wall Force", 1 },
      { "Wall Place", 3 }, { "Residual", 1 } };
  }

  void next(const PathSample& sample, PathTick& tick) override
  {
    const MechanismResult result = this->touch_->next(sample.time_s, sample.hand_W);
    const WireReport& wire = result.wire;
    tick.proxy_W = result.pose_W[this->touch_->plan().held];
    tick.wrench_W = result.wrench_W;
    tick.contacts = wire.pressCount;
    const Vec3 &torque = tick.wrench_W.torque, &wall = wire.wall_W;
    tick.more = { torque.x(), torque.y(), torque.z(), wire.pushed_u, wire.turned_rad, wire.tip_N, wire.wall_N, wall.x(),
      wall.y(), wall.z(), result.residual_u };
    this->capped_ += result.capped ? 1 : 0;
    this->leftOut_ += wire.leftOut > 0 ? 1 : 0;
    this->crowded_ += wire.crowded > 0 ? 1 : 0;
  }

  void finish(PathReport& report) const override
  {
    noteTicks(report, this->capped_, "the wire was not at rest within a tick's steps");
    noteTicks(report, this->leftOut_, "the wire touched in more places than a tick can solve; the nearest were kept");
    noteTicks(report, this->crowded_,
      "more triangles were around a beam of the wire than are looked at; give the vessel fewer triangles");
    const std::vector<std::string>& remarks = this->touch_->check().remarks;
    report.remarks.insert(report.remarks.end(), remarks.begin(), remarks.end());
  }

private:
  std::unique_ptr<MechanismTouch> touch_;
  int capped_ = 0; ///< ticks, as those below
  int leftOut_ = 0;
  int crowded_ = 0;
};

} // namespace

std::unique_ptr<PathKind> wireAlongPath(std::unique_ptr<MechanismTouch> touch)
{
  return std::make_unique<WireAlongPath>(std::move(touch));
}

} // namespace palpate
