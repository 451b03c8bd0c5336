// SPDX-License-Identifier: GPL-3.0-or-later
// A tool as points that push back as deep as they are inside, against a spring to the hand. The pose is where both
// balance, by a few steps of Newton's method an update: coupled statically, so that the result shows the method's error
// and not its oscillation.
#include <algorithm>
#include <cmath>

#include "haptics/tool/motion/TargetMotion.h"
#include "haptics/tool/solve/NearestMotion.h"
#include "testing/lab/tools/ToolMethod.h"

namespace palpate::lab
{
namespace
{

constexpr double stiffer = 20.0; // of a point that pushes than of the spring to the hand
constexpr double shared = 10.0;  // more points than that share their stiffness
constexpr int stepsAnUpdate = 2;
constexpr double longestTurn_rad = 0.2;

/// A point that is inside by so much is pushed along n.
struct Push
{
  Vec3 n_W, arm_W;
  double depth_mm;
};

class SampledTool : public ToolMethod
{
public:
  explicit SampledTool(const ToolScene& scene) : scene_(scene), pose_W_(scene.start_W) {}

  void update(const Pose& hand_W) override
  {
    for (int i = 0; i < stepsAnUpdate; ++i)
    {
      this->step(hand_W);
    }
  }
  [[nodiscard]] Pose pose_W() const override { return this->pose_W_; }

protected:
  virtual void pushes(const Mat3& turn, const Vec3& centre_W, std::vector<Push>& found) const = 0;
  const ToolScene& scene_;

private:
  void step(const Pose& hand_W)
  {
    bool cut = false;
    this->found_.clear();
    this->pushes(this->pose_W_.q.toRotationMatrix(), this->pose_W_.p, this->found_);
    const double stiffness = stiffer * std::min(1.0, shared / static_cast<double>(this->found_.size()));
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Identity();
    Vec6 pull = wishedMotion(this->pose_W_, hand_W, this->scene_.lever_mm, cut);
    for (const Push& push : this->found_)
    {
      const Vec6 row =
        whitened(push.n_W, push.arm_W.cross(push.n_W) / std::pow(this->scene_.lever_mm, 2), this->scene_.lever_mm);
      sum += stiffness * row * row.transpose();
      pull += stiffness * push.depth_mm * row;
    }
    const Vec6 y = sum.ldlt().solve(pull);
    Vec3 turn = y.tail<3>() / this->scene_.lever_mm;
    turn *= std::min(1.0, longestTurn_rad / std::max(turn.norm(), 1e-300));
    this->pose_W_ = { this->pose_W_.p + y.head<3>(), (turnBy(turn) * this->pose_W_.q).normalized() };
  }

  Pose pose_W_;
  std::vector<Push> found_;
};

/// A point on the tool's surface and the normal out of it.
struct SurfacePoint
{
  Vec3 p_B, n_B;
};

/// Where the surface passes cells of that size, one point each.
std::vector<SurfacePoint> pointsOf(const ToolBody& body, double size_mm)
{
  Eigen::AlignedBox3d bounds;
  for (const Vec3& v : body.mesh.vertices_W)
  {
    bounds.extend(v);
  }
  const Eigen::Vector3i cells = ((bounds.sizes() / size_mm).array().ceil() + 2).cast<int>();
  std::vector<SurfacePoint> points;
  for (int k = 0; k < cells.z(); ++k)
  {
    for (int j = 0; j < cells.y(); ++j)
    {
      for (int i = 0; i < cells.x(); ++i)
      {
        const Vec3 middle = bounds.min() + size_mm * Vec3(i - 0.5, j - 0.5, k - 0.5);
        const double out = body.distance_mm(middle);
        if (std::abs(out) <= 0.5 * size_mm)
        {
          const Vec3 n = outwards(body, middle);
          points.push_back({ middle - out * n, n });
        }
      }
    }
  }
  return points;
}

/// Each point in a voxel of the scene's surface is pushed to behind the plane through the voxel's middle along its own
/// normal; deeper inside no direction outwards is known.
class VoxelTool final : public SampledTool
{
public:
  VoxelTool(const ToolScene& scene, double size_mm)
    : SampledTool(scene), size_mm_(size_mm), points_(pointsOf(scene.tool_B, size_mm))
  {
  }

private:
  void pushes(const Mat3& turn, const Vec3& centre_W, std::vector<Push>& found) const override
  {
    const double surface_mm = 0.5 * std::sqrt(3.0) * this->size_mm_;
    for (const SurfacePoint& point : this->points_)
    {
      const Vec3 arm = turn * point.p_B, p = arm + centre_W;
      const Vec3 middle = ((p / this->size_mm_).array().floor() + 0.5) * this->size_mm_;
      const Vec3 inwards = -(turn * point.n_B);
      const double depth = inwards.dot(middle - p);
      if (depth > 0.0 && std::abs(this->scene_.scene_W.distance_mm(middle)) <= surface_mm)
      {
        found.push_back({ inwards, arm, depth });
      }
    }
  }

  double size_mm_;
  std::vector<SurfacePoint> points_;
};

/// Each point is pushed along its own normal, as deep as the scene's distance there says.
class PointshellTool final : public SampledTool
{
public:
  PointshellTool(const ToolScene& scene, double spacing_mm)
    : SampledTool(scene), points_(pointsOf(scene.tool_B, spacing_mm))
  {
  }

private:
  void pushes(const Mat3& turn, const Vec3& centre_W, std::vector<Push>& found) const override
  {
    for (const SurfacePoint& point : this->points_)
    {
      const Vec3 arm = turn * point.p_B;
      const double depth = -this->scene_.scene_W.distance_mm(arm + centre_W);
      if (depth > 0.0)
      {
        found.push_back({ -(turn * point.n_B), arm, depth });
      }
    }
  }

  std::vector<SurfacePoint> points_;
};

/// Corners of either body in the other, pushed along the shortest path out.
class PenaltyTool final : public SampledTool
{
public:
  using SampledTool::SampledTool;

private:
  void pushes(const Mat3& turn, const Vec3& centre_W, std::vector<Push>& found) const override
  {
    for (const Vec3& v_B : this->scene_.tool_B.mesh.vertices_W)
    {
      const Vec3 arm = turn * v_B, p = arm + centre_W;
      const double depth = -this->scene_.scene_W.distance_mm(p);
      if (depth > 0.0)
      {
        found.push_back({ outwards(this->scene_.scene_W, p), arm, depth });
      }
    }
    for (const Vec3& v_W : this->scene_.scene_W.mesh.vertices_W)
    {
      const Vec3 arm = v_W - centre_W, p_B = turn.transpose() * arm;
      const double depth = -this->scene_.tool_B.distance_mm(p_B);
      if (depth > 0.0)
      {
        found.push_back({ -(turn * outwards(this->scene_.tool_B, p_B)), arm, depth });
      }
    }
  }
};

} // namespace

std::unique_ptr<ToolMethod> voxelTool(const ToolScene& scene, double size_mm)
{
  return std::make_unique<VoxelTool>(scene, size_mm);
}

std::unique_ptr<ToolMethod> pointshellTool(const ToolScene& scene, double spacing_mm)
{
  return std::make_unique<PointshellTool>(scene, spacing_mm);
}

std::unique_ptr<ToolMethod> penaltyTool(const ToolScene& scene)
{
  return std::make_unique<PenaltyTool>(scene);
}

} // namespace palpate::lab
