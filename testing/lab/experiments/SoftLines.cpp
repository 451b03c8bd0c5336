// SPDX-License-Identifier: GPL-3.0-or-later
// Row 90: lines that push back with K times the depth while the foot of the handle lies on them, beside the virtual
// location. In the inside corner of x = 0 (y < 0) and y = 0 (x < 0) both feet leave their lines at the corner.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/tick/ForceRenderer.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Meshes.h"

namespace palpate::lab
{
namespace soft_lines_experiment
{

using Vec2 = Eigen::Vector2d;

constexpr double K = 200.0, long_m = 0.02, rounding = 1e-9;
constexpr const char* soft = "soft lines";
constexpr const char* ours = "virtual location";

/// A line with a free side.
struct SoftLine
{
  Vec2 from_m, to_m, free;
};

const std::vector<SoftLine>& corner()
{
  static const std::vector<SoftLine> lines = { { { 0, -long_m }, { 0, 0 }, { -1, 0 } },
    { { -long_m, 0 }, { 0, 0 }, { 0, -1 } } };
  return lines;
}

/// The model that is tried: no memory of where the handle came from.
Vec2 softForce(const Vec2& p_m)
{
  Vec2 force = Vec2::Zero();
  for (const SoftLine& line : corner())
  {
    const Vec2 along = line.to_m - line.from_m;
    const double foot = along.dot(p_m - line.from_m) / along.squaredNorm();
    const double depth_m = line.free.dot(line.from_m - p_m);
    if (foot >= 0.0 && foot <= 1.0 && depth_m > 0.0)
    {
      force += K * depth_m * line.free;
    }
  }
  return force;
}

/// The product's contact on the same two lines, a point that is led.
class VirtualLocation
{
public:
  VirtualLocation()
  {
    CurveSet curves;
    for (const SoftLine& line : corner())
    {
      const auto first = static_cast<std::uint32_t>(curves.points_W.size());
      curves.points_W.insert(curves.points_W.end(), { line.from_m, line.to_m });
      curves.segments.push_back({ first, first + 1 });
    }
    this->scene_ = test::sceneOf(raiseWalls(curves, 0.01));
    this->parameters_.stiffness_N_per_m = K;
    this->parameters_.safety = SafetyLimits::none();
  }

  Vec2 force(const Vec2& p_m)
  {
    TickInput input;
    input.scene = this->scene_.get();
    input.sample.pose_D.p = { p_m.x(), p_m.y(), 0.0 };
    const HapticState state = renderTick(input, this->parameters_, this->state_).state;
    this->location_m_ = state.proxy_W.p.head<2>();
    return state.force_D.head<2>();
  }

  [[nodiscard]] const Vec2& location_m() const { return this->location_m_; }

private:
  std::shared_ptr<const Scene> scene_;
  HapticParameters parameters_;
  RendererState state_;
  Vec2 location_m_ = Vec2::Zero();
};

/// A path to the handle's last place, from within the box.
struct Way
{
  const char* name;
  std::vector<Vec2> points_m;
  double softPeak_N; ///< truth
};

/// How deep the handle is in one line when a straight segment takes its foot off the end of it.
double straightDepth_m(const Vec2& from_m, const Vec2& to_m)
{
  const Vec2 way = to_m - from_m;
  const Vec2 share(-from_m.x() / way.x(), -from_m.y() / way.y()); // of the displacement to x = 0 and to y = 0
  return std::max(from_m.x() + share.y() * way.x(), from_m.y() + share.x() * way.y());
}

std::vector<Way> waysTo(const Vec2& to_m)
{
  const Vec2 from_m(-2e-3, -2e-3);
  return { { "x-first", { from_m, { to_m.x(), from_m.y() }, to_m }, K * to_m.x() },
    { "y-first", { from_m, { from_m.x(), to_m.y() }, to_m }, K * to_m.y() },
    { "straight", { from_m, to_m }, K * straightDepth_m(from_m, to_m) } };
}

Vec2 along(const Way& way, double share)
{
  const double at = share * static_cast<double>(way.points_m.size() - 1);
  const auto leg = std::min(static_cast<std::size_t>(at), way.points_m.size() - 2);
  return way.points_m[leg] + (at - static_cast<double>(leg)) * (way.points_m[leg + 1] - way.points_m[leg]);
}

/// Where the virtual location is: the nearest place of the box.
Vec2 heldAt(const Vec2& p_m)
{
  return p_m.cwiseMin(0.0);
}

void judgeWay(const Way& way, const Vec2& to_m, int steps, Table& table)
{
  const std::string name = std::string("way=") + way.name + " " + caseName({ { "x", to_m.x() }, { "y", to_m.y() } });
  VirtualLocation location;
  double softPeak_N = 0.0, error_N = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    const double share = static_cast<double>(i) / steps;
    const Vec2 p_m = along(way, share), held_N = K * (heldAt(p_m) - p_m), felt_N = location.force(p_m);
    const double soft_N = softForce(p_m).norm();
    softPeak_N = std::max(softPeak_N, soft_N);
    error_N = std::max(error_N, (felt_N - held_N).norm());
    if (i % (steps / 40) == 0)
    {
      const std::string at = name + " " + caseName({ { "share", share } });
      table.within({ at, ours, "force", "N" }, felt_N.norm(), held_N.norm(), rounding);
      table.within({ at, soft, "force", "N" }, soft_N,
        p_m.maxCoeff() > 0.0 && p_m.minCoeff() <= 0.0 ? K * p_m.maxCoeff() : 0.0, rounding);
    }
  }
  const double step_N = K * (to_m.norm() + 4e-3) * 2.0 / steps; // of the force from look to look
  table.within({ name, soft, "largest force on the way", "N" }, softPeak_N, way.softPeak_N, step_N);
  table.within({ name, soft, "force at the end", "N" }, softForce(to_m).norm(), 0.0, rounding);
  table.within(
    { name, ours, "force at the end", "N" }, K * (location.location_m() - to_m).norm(), K * to_m.norm(), rounding);
  table.atMost({ name, ours, "largest error on the way", "N" }, error_N, rounding);
  table.atMost({ name, ours, "location beyond the corner", "m" }, location.location_m().norm(), 1e-12);
}

} // namespace soft_lines_experiment

void runSoftLines(const Conditions& conditions, Table& table)
{
  using namespace soft_lines_experiment;
  const int steps = conditions.pick(4000, 40000, 400000);
  const Vec2 ends_m[] = { { 2e-3, 2e-3 }, { 4e-3, 1e-3 }, { 1e-3, 5e-3 } };
  for (const Vec2& to_m : ends_m)
  {
    for (const Way& way : waysTo(to_m))
    {
      judgeWay(way, to_m, steps, table);
    }
  }
  conditions.progress(1.0);
}

} // namespace palpate::lab
