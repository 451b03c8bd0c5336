// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/path/ToolTouch.h"

#include <cmath>
#include <utility>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "haptics/session/tool/NoWayOut.h"
#include "haptics/tool/servo/RubbedWish.h"

namespace palpate
{
namespace
{

constexpr std::uint64_t workOfUpdate = 10'000'000; // so much that an update ends by its steps
constexpr int mostUpdates = 50;                    // a way across a scene takes a few

std::string refuseHold(const ToolHold& hold)
{
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (!positive(hold.stiffness_N_per_m) || !positive(hold.scale_u_per_m))
  {
    return "stiffness and scale of a tool must be finite numbers above 0";
  }
  if (!(hold.friction >= 0.0 && hold.friction <= largestToolFriction))
  {
    return "the friction of a tool must be a number from 0 to 1: where contacts wedge, more has no one answer";
  }
  return positive(hold.lever_u.value_or(1.0)) ? "" : "the lever of a tool must be a finite number above 0";
}

} // namespace

ToolTouch::ToolTouch(const ToolMesh& tool, std::shared_ptr<const BoxedMesh> scene_W, const ToolHold& hold)
  : hold_(hold), move_(tool, std::move(scene_W), hold.lever_u.value_or(tool.gyration_u))
{
  this->move_.rub(hold.friction);
}

std::unique_ptr<ToolTouch> ToolTouch::make(const TriangleMesh& tool, const TriangleMesh& scene_W, const ToolHold& hold,
  const Pose& first_W, std::string& refusal)
{
  refusal = refuseHold(hold);
  if (!refusal.empty())
  {
    return nullptr;
  }
  const Outcome<ToolMesh> held = makeTool(tool, Vec3(Vec3::Zero()));
  CleanResult scene = held.ok() ? cleanMesh(scene_W) : CleanResult{};
  refusal = !held.ok() ? held.problem : scene.ok() ? "" : "the scene cannot be touched: " + scene.refusal;
  if (!refusal.empty())
  {
    return nullptr;
  }
  auto boxes = makeToolScene(std::move(scene.mesh), held.value);
  refusal = refuseScene(held.value, *boxes);
  if (!refusal.empty())
  {
    return nullptr;
  }
  std::unique_ptr<ToolTouch> touch(new ToolTouch(held.value, boxes, hold));
  refusal = touch->move_.place(first_W);
  if (!refusal.empty())
  {
    return nullptr;
  }
  touch->noWayOut_ = palpate::noWayOut(SurfaceTree(boxes->mesh()), Pose{}, held.value, first_W);
  return touch;
}

ToolTouched ToolTouch::next(const Pose& hand_W)
{
  ToolTouched touched;
  if (refusePose(this->move_.tool(), hand_W).empty())
  {
    for (int i = 0; i < mostUpdates && !touched.settled; ++i)
    {
      const ToolUpdate done = this->move_.update(hand_W, workOfUpdate);
      touched.settled = done.converged;
      touched.leadCut = done.leadCut;
    }
    // A tool at rest is pushed by its spring, also where friction holds it.
    const bool bySpring = touched.settled && this->hold_.friction > 0.0;
    const ToolPush push =
      toolPush(this->move_.contacts(), hand_W, this->hold_.stiffness_N_per_m / this->hold_.scale_u_per_m,
        bySpring ? ToolCoupling::Virtual : this->hold_.coupling);
    touched.contacts = push.active;
    // The torque of the metric is in N u.
    touched.wrench_W = { push.wrench_W.force, push.wrench_W.torque / this->hold_.scale_u_per_m };
  }
  touched.pose_W = this->move_.pose_W();
  return touched;
}

} // namespace palpate
