// SPDX-License-Identifier: GPL-3.0-or-later
// Constraint-based motion by conservative advancement: the tool goes on by distance over largest speed, whatever the
// direction, and the features that it then touches become constraints. In contact the distance is small, and so is
// every step.
#include <algorithm>
#include <limits>

#include "haptics/tool/mesh/ToolMesh.h"
#include "haptics/tool/motion/ScrewStep.h"
#include "haptics/tool/move/TouchFeature.h"
#include "haptics/tool/pairs/PairFront.h"
#include "haptics/tool/solve/NearestMotion.h"
#include "testing/lab/tools/ToolMethod.h"

namespace palpate::lab
{
namespace
{

constexpr double kept = 1e-5;  // the gap that it keeps, of the tool's size
constexpr int mostPasses = 40; // of an update
constexpr double share = 0.9;  // of the distance that a pass goes
constexpr double longestStep_rad = 0.2;

class AdvancedTool final : public ToolMethod
{
public:
  explicit AdvancedTool(const ToolScene& scene)
    : tool_(makeTool(scene.tool_B.mesh, Vec3(Vec3::Zero())).value),
      scene_W_(makeToolScene(cleanMesh(scene.scene_W.mesh).mesh, tool_)), lever_mm_(scene.lever_mm),
      gap_mm_(kept * tool_.diagonal_u), pose_W_(scene.start_W)
  {
  }

  void update(const Pose& hand_W) override
  {
    int passes = 0;
    double before_mm = std::numeric_limits<double>::infinity();
    while (passes < mostPasses)
    {
      bool cut = false;
      const Vec6 wish = wishedMotion(this->pose_W_, hand_W, this->lever_mm_, cut);
      if (before_mm - wish.norm() < 1e-3 * this->gap_mm_)
      {
        break;
      }
      before_mm = wish.norm();
      this->goOn(wish, passes);
    }
  }
  [[nodiscard]] Pose pose_W() const override { return this->pose_W_; }

private:
  /// Along the motion that the contacts allow, pass by pass, until it touches something more.
  void goOn(const Vec6& wish, int& passes)
  {
    std::vector<MotionRow> rows;
    this->nearest(3.0 * this->gap_mm_, &rows);
    const NearestMotion motion = nearestMotion(rows, wish);
    if (!motion.feasible)
    {
      passes = mostPasses;
      return;
    }
    ScrewStep step{ this->pose_W_, motion.y.head<3>(), motion.y.tail<3>() / this->lever_mm_ };
    const double cut = std::min(1.0, longestStep_rad / std::max(step.w_W.norm(), 1e-300));
    const double way_mm = cut * step.displacement_u(this->tool_.reach_u);
    double gone = 0.0, part = 1.0;
    while (gone < 1.0 && part > 1e-3 && passes < mostPasses)
    {
      ++passes;
      const double free_mm = this->nearest(way_mm + this->gap_mm_, nullptr) - 0.5 * this->gap_mm_;
      part = way_mm > 0.0 ? std::min(1.0 - gone, share * std::max(0.0, free_mm) / way_mm) : 1.0 - gone;
      gone += part;
      this->pose_W_ = step.end_W(cut * gone);
    }
  }

  /// The distance to the scene, at most that far; each nearer feature becomes a row.
  double nearest(double within_mm, std::vector<MotionRow>* rows) const
  {
    PairFront front(*this->tool_.shape_B, *this->scene_W_, this->tool_.restGap_u());
    WorkBudget unlimited(std::numeric_limits<std::uint64_t>::max());
    static_cast<void>(front.gather(this->pose_W_, within_mm, unlimited));
    const Mat3 turn = this->pose_W_.q.toRotationMatrix();
    double least_mm = within_mm;
    for (const BoxPair& pair : front.near())
    {
      const BoxedMesh::Node& tool = this->tool_.shape_B->nodes()[pair.tool];
      const BoxedMesh::Node& scene = this->scene_W_->nodes()[pair.scene];
      for (std::uint32_t t = tool.second; t < tool.second + tool.count; ++t)
      {
        Corners corners = this->tool_.shape_B->corners(t);
        for (Vec3& corner : corners)
        {
          corner = turn * corner + this->pose_W_.p;
        }
        for (std::uint32_t s = scene.second; s < scene.second + scene.count; ++s)
        {
          const NearestPair found = nearestPair(corners, this->scene_W_->corners(s));
          if (rows != nullptr && found.distance_u < within_mm)
          {
            rows->push_back(motionRow(found.n, found.onTool_W - this->pose_W_.p,
              std::min(0.0, this->gap_mm_ - found.distance_u), this->lever_mm_));
          }
          least_mm = std::min(least_mm, found.distance_u);
        }
      }
    }
    return least_mm;
  }

  ToolMesh tool_;
  std::shared_ptr<const BoxedMesh> scene_W_;
  double lever_mm_, gap_mm_;
  Pose pose_W_;
};

} // namespace

std::unique_ptr<ToolMethod> advancedTool(const ToolScene& scene)
{
  return std::make_unique<AdvancedTool>(scene);
}

} // namespace palpate::lab
