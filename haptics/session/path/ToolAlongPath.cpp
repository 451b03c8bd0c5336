// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "haptics/session/path/PathKind.h"
#include "haptics/session/path/ToolHold.h"
#include "haptics/session/tool/NoWayOut.h"
#include "haptics/tool/move/ToolMove.h"

namespace palpate
{
namespace
{

constexpr double degreesPerRadian = 180.0 / std::numbers::pi;
constexpr std::uint64_t workOfUpdate = 10'000'000; // so much that an update ends by its steps
constexpr int mostUpdates = 50;                    // a path across a scene takes a few

/// A tool feels surfaces as they are: any other input would be lost.
std::string lostBesideTool(const PathInputs& inputs)
{
  const std::string lost = setBeside(inputs.settings,
    { "Stiffness", "Scale", "FrictionStatic", "FrictionKinetic", "ToolLever", "ToolCoupling", "MechanismTurning" });
  return !lost.empty()             ? lost + " has no effect on a tool; omit this option or the tool"
         : inputs.field            ? inputs.field->name + ": a tool cannot touch a field; omit the field or the tool"
         : inputs.surfaces.empty() ? "a tool needs surfaces, and there are none"
                                   : "";
}

/// Each tick is as far as the tool comes in unlimited time. Poses are those of the frame in which the tool's mesh was
/// given, whose origin is in the hand.
class ToolAlongPath final : public PathKind
{
public:
  ToolAlongPath(const ToolMesh& tool, std::shared_ptr<const BoxedMesh> scene_W, const ToolHold& hold)
    : hold_(hold), move_(tool, std::move(scene_W), hold.characteristic_u.value_or(tool.gyration_u))
  {
    this->move_.rub(hold.friction);
  }

  /// "", or why the tool cannot begin there.
  [[nodiscard]] std::string place(const Pose& first_W) { return this->move_.place(first_W); }

  [[nodiscard]] std::vector<PathColumn> columns() const override
  {
    return { { "Turn", 4 }, { "Torque", 3 }, { "Angle", 1 } };
  }

  /// A pose that is none (ToolMesh.h) leaves the tool where it was, not settled.
  void next(const PathSample& sample, PathTick& tick) override
  {
    const Pose& hand_W = sample.hand_W;
    ToolUpdate done;
    ToolPush push;
    if (refusePose(this->move_.tool(), hand_W).empty())
    {
      for (int i = 0; i < mostUpdates && !done.converged; ++i)
      {
        done = this->move_.update(hand_W, workOfUpdate);
      }
      // A tool at rest is pushed by its spring, also where friction holds it.
      const bool bySpring = done.converged && this->hold_.friction > 0.0;
      push = toolPush(this->move_.contacts(), hand_W, this->hold_.stiffness_N_per_m / this->hold_.scale_u_per_m,
        bySpring ? ToolCoupling::Virtual : this->hold_.coupling);
    }
    tick.proxy_W = this->move_.pose_W();
    tick.contacts = push.active;
    // The torque of the metric is in N u.
    tick.wrench_W = { push.wrench_W.force, push.wrench_W.torque / this->hold_.scale_u_per_m };
    const Quat& q = tick.proxy_W.q;
    const Vec3& torque = tick.wrench_W.torque;
    tick.more = { q.w(), q.x(), q.y(), q.z(), torque.x(), torque.y(), torque.z(),
      degreesPerRadian * hand_W.q.angularDistance(q) };
    this->unsettled_ += done.converged ? 0 : 1;
    this->leadCut_ += done.leadCut ? 1 : 0;
  }

  void finish(PathReport& report) const override
  {
    noteTicks(report, this->unsettled_, "the tool had not come to rest");
    noteTicks(report, this->leadCut_,
      "the hand was rotated so far ahead of the tool that the tool followed only a part of the rotation");
  }

private:
  ToolHold hold_;
  ToolMove move_;
  int unsettled_ = 0; ///< ticks
  int leadCut_ = 0;   ///< ticks
};

/// Null with a refusal: of the tool, of a scene without triangles or too far away, of a place where the tool would meet
/// the scene.
std::unique_ptr<PathKind> makeToolAlongPath(const PathInputs& inputs, const ToolHold& hold, PathReport& report)
{
  TriangleMesh scene_W;
  for (const PathSurface& surface : inputs.surfaces)
  {
    append(scene_W, *surface.mesh);
  }
  const Outcome<ToolMesh> held = makeTool(*inputs.tool->mesh, Vec3(Vec3::Zero()));
  CleanResult scene = held.ok() ? cleanMesh(scene_W) : CleanResult{};
  report.refusal = !held.ok() ? held.problem : scene.ok() ? "" : "the scene cannot be touched: " + scene.refusal;
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  const auto boxes = makeToolScene(std::move(scene.mesh), held.value);
  report.refusal = refuseScene(held.value, *boxes);
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  const Pose& first_W = inputs.path.front().hand_W;
  auto tool = std::make_unique<ToolAlongPath>(held.value, boxes, hold);
  report.refusal = tool->place(first_W);
  const std::string stuck =
    report.refusal.empty() ? noWayOut(SurfaceTree(boxes->mesh()), Pose{}, held.value, first_W) : "";
  if (!stuck.empty())
  {
    report.notes.push_back("the tool " + stuck);
  }
  return report.refusal.empty() ? std::move(tool) : nullptr;
}

} // namespace

std::unique_ptr<PathKind> toolAlongPath(const PathInputs& inputs, PathReport& report)
{
  report.refusal = lostBesideTool(inputs);
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  const ToolHold hold = toolHoldOf(inputs.settings);
  report.refusal = refuseHold(hold);
  auto tool = report.refusal.empty() ? makeToolAlongPath(inputs, hold, report) : nullptr;
  report.refusal = tool ? "" : inputs.tool->name + ": cannot be held: " + report.refusal;
  return tool;
}

} // namespace palpate
