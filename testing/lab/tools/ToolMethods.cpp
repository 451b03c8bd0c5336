// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "haptics/tool/move/ToolMove.h"
#include "haptics/tool/worker/ToolFollower.h"
#include "testing/lab/tools/ToolMethod.h"

namespace palpate::lab
{
namespace
{

/// The product's, held where the body's frame has its origin.
class ProvenTool final : public ToolMethod
{
public:
  explicit ProvenTool(const ToolScene& scene)
    : tool_(makeTool(scene.tool_B.mesh, Vec3(Vec3::Zero())).value),
      move_(tool_, makeToolScene(cleanMesh(scene.scene_W.mesh).mesh, tool_), scene.lever_mm)
  {
    const std::string refusal = this->move_.place(scene.start_W);
    if (!refusal.empty())
    {
      throw std::runtime_error(scene.name + ": " + refusal);
    }
  }

  void update(const Pose& hand_W) override { this->move_.update(hand_W, ToolFollower::usualWork); }
  [[nodiscard]] Pose pose_W() const override { return this->move_.pose_W(); }

private:
  ToolMesh tool_;
  ToolMove move_;
};

} // namespace

std::vector<ToolMethodKind> toolMethods()
{
  return {
    { "ours: planes", [](const ToolScene& scene) { return std::make_unique<ProvenTool>(scene); } },
    { "advancement", advancedTool },
    { "penalty", penaltyTool },
    { "pointshell 0.5mm", [](const ToolScene& scene) { return pointshellTool(scene, 0.5); } },
    { "voxels 0.5mm", [](const ToolScene& scene) { return voxelTool(scene, 0.5); } },
    { "voxels 1mm", [](const ToolScene& scene) { return voxelTool(scene, 1.0); } },
  };
}

} // namespace palpate::lab
