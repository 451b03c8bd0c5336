// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/CameAround.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "haptics/contact/carry/Deformation.h"
#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/view/PlanFor.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{
namespace
{

/// A free path is cut off a little before its end at a surface: a ball that touches is not outside of it.
constexpr double shortOfEnd = 0.999;

/// A surface of a scene where it stands in the end.
struct Standing
{
  MovingScene scene;
  std::uint32_t index = 0;

  [[nodiscard]] const Surface& surface() const { return this->scene.scene().surfaces()[this->index]; }
  [[nodiscard]] PosedSurface posed() const { return surfaceOf(this->scene, this->index); }
};

bool bars(const Standing& s, const ContactPlan& plan, double radius_u, const Vec3& from_W, const Vec3& to_W)
{
  const PosedSurface posed = s.posed();
  SweepQuery query = straightQuery(posed.toSurface(from_W), posed.toSurface(to_W), radius_u);
  query.resolution.include(Vec3::Constant(radius_u + posed.data().coat_u));
  return askShape(
    posed, [&](const auto& shape) noexcept { return sweepSurface(shape, s.index, query, plan.workBudget).hit; });
}

bool isInBox(const Standing& s, double radius_u, const Vec3& p_W)
{
  const PosedSurface posed = s.posed();
  const Vec3 p_S = posed.toSurface(p_W);
  const double reach_u = radius_u + posed.data().coat_u;
  return (p_S.array() >= posed.data().low_W.array() - reach_u).all() &&
         (p_S.array() <= posed.data().high_W.array() + reach_u).all();
}

/// Along the axes and between them.
std::vector<Vec3> directions()
{
  std::vector<Vec3> all;
  for (int i = 0; i < 27; ++i)
  {
    const Vec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (d != Vec3::Zero())
    {
      all.push_back(d.normalized());
    }
  }
  return all;
}

/// So far from x_W that it is outside of the surface's box in every direction.
double beyond_u(const Standing& s, double radius_u, const Vec3& x_W)
{
  const PosedSurface posed = s.posed();
  const Vec3 x_S = posed.toSurface(x_W);
  const Vec3 furthest = (posed.data().low_W - x_S).cwiseAbs().cwiseMax((posed.data().high_W - x_S).cwiseAbs());
  return 2.0 * (furthest.norm() + radius_u + posed.data().coat_u);
}

/// The end of a ball's free path in that direction in the scene that was felt.
Vec3 freeEnd(const Scene* before, const ContactPlan& plan, const Vec3& x_W, const Vec3& way_W)
{
  if (before == nullptr || before->empty())
  {
    return x_W + way_W;
  }
  const SweepHit hit = sweepStraight(MovingScene(*before, 1.0), plan, plan.radius_u, x_W, x_W + way_W);
  return x_W + (hit.hit ? shortOfEnd * hit.t : hit.freeUntil) * way_W;
}

/// Where the path to x_W comes from that ends nearest to it, if the surface is around x_W as seen from the scene that
/// was felt.
std::optional<Vec3> wayOut(const Scene* before, const Standing& s, const ContactPlan& plan, const Vec3& x_W)
{
  std::optional<Vec3> out_W;
  double nearest_u = std::numeric_limits<double>::infinity();
  for (const Vec3& d : directions())
  {
    const Vec3 from_W = freeEnd(before, plan, x_W, beyond_u(s, plan.radius_u, x_W) * d);
    if (isInBox(s, plan.radius_u, from_W))
    {
      continue;
    }
    if (!bars(s, plan, plan.radius_u, from_W, x_W))
    {
      return std::nullopt;
    }
    const double left_u = (stopBefore(s.scene, plan, plan.radius_u, from_W, x_W) - x_W).norm();
    if (left_u < nearest_u)
    {
      nearest_u = left_u;
      out_W = from_W;
    }
  }
  return out_W;
}

/// The tick takes the ball along with such a surface.
bool comesFromFelt(const Scene& before, const Scene& after, std::uint32_t index)
{
  const Surface& now = after.surfaces()[index];
  for (std::uint32_t i = 0; i < before.surfaces().size(); ++i)
  {
    if (successorOf(before.surfaces(), i, after.surfaces()) == index ||
        fullContentOf(before.surfaces()[i]) == fullContentOf(now))
    {
      return true;
    }
  }
  return false;
}

/// A hand that was put into a surface on purpose stays there when that one is made anew.
bool wasWithin(const Scene& before, const std::string& name, const ContactPlan& plan, const Vec3& x_W)
{
  for (std::uint32_t i = 0; i < before.surfaces().size(); ++i)
  {
    if (before.surfaces()[i].name == name)
    {
      ContactPlan point = plan;
      point.radius_u = 0.0;
      return wayOut(nullptr, { MovingScene(before, 1.0), i }, point, x_W).has_value();
    }
  }
  return false;
}

bool isOneOf(const std::string& name, const std::vector<std::string>& names)
{
  return std::ranges::find(names, name) != names.end();
}

/// Of the surface of that name, which is there.
std::uint32_t numberOf(const Scene& scene, const std::string& name)
{
  const auto found = std::ranges::find_if(scene.surfaces(), [&](const Surface& s) { return s.name == name; });
  return static_cast<std::uint32_t>(found - scene.surfaces().begin());
}

/// A place is in all surfaces of before that are still there, and in no others.
bool isWhereItWas(const Scene& scene, const std::vector<std::string>& around, const std::vector<std::string>& before)
{
  return std::ranges::all_of(
    scene.surfaces(), [&](const Surface& s) { return isOneOf(s.name, around) == isOneOf(s.name, before); });
}

bool isSeen(const Scene* scene, const ContactPlan& plan, const Vec3& eye_W, const Vec3& x_W)
{
  return scene == nullptr || scene->empty() || !sweepStraight(MovingScene(*scene, 1.0), plan, 0.0, eye_W, x_W).hit;
}

} // namespace

std::optional<CameAround> cameAround(
  const Scene* before, const Scene& after, const ContactPlan& asked, const Vec3& x_W, const std::optional<Vec3>& eye_W)
{
  const ContactPlan plan = planFor(after, asked);
  const auto found = [&](const std::string& surface, const Vec3& from_W) {
    return CameAround{ surface, from_W, stopBefore(MovingScene(after, 1.0), plan, plan.radius_u, from_W, x_W) };
  };
  const bool seen = eye_W && isSeen(before, plan, *eye_W, x_W);
  for (std::uint32_t i = 0; i < after.surfaces().size(); ++i)
  {
    const Standing s{ MovingScene(after, 1.0), i };
    if (before != nullptr && comesFromFelt(*before, after, i))
    {
      continue;
    }
    if (seen)
    {
      if (bars(s, plan, plan.radius_u, *eye_W, x_W))
      {
        return found(s.surface().name, *eye_W);
      }
      continue;
    }
    const std::optional<Vec3> from_W = wayOut(before, s, plan, x_W);
    if (from_W && !(before != nullptr && wasWithin(*before, s.surface().name, plan, x_W)))
    {
      return found(s.surface().name, *from_W);
    }
  }
  return std::nullopt;
}

std::optional<CameAround> movedInto(const Scene& scene, const ContactPlan& asked, const Vec3& felt_W, const Vec3& x_W)
{
  const ContactPlan plan = planFor(scene, asked);
  ContactPlan point = plan;
  point.radius_u = 0.0;
  for (std::uint32_t i = 0; i < scene.surfaces().size(); ++i)
  {
    const Standing s{ MovingScene(scene, 1.0), i };
    const std::optional<Vec3> from_W = wayOut(nullptr, s, plan, x_W);
    if (from_W && !wayOut(nullptr, s, point, felt_W))
    {
      return CameAround{ s.surface().name, *from_W, stopBefore(s.scene, plan, plan.radius_u, *from_W, x_W) };
    }
  }
  return std::nullopt;
}

std::vector<std::string> surfacesAround(const Scene& scene, const ContactPlan& asked, const Vec3& x_W)
{
  ContactPlan point = planFor(scene, asked);
  point.radius_u = 0.0;
  std::vector<std::string> around;
  for (std::uint32_t i = 0; i < scene.surfaces().size(); ++i)
  {
    const Standing s{ MovingScene(scene, 1.0), i };
    if (isInBox(s, 0.0, x_W) && wayOut(nullptr, s, point, x_W))
    {
      around.push_back(s.surface().name);
    }
  }
  return around;
}

std::optional<CameAround> squeezedInto(
  const Scene& scene, const ContactPlan& asked, const std::vector<std::string>& before, const Vec3& x_W)
{
  const std::vector<std::string> now = surfacesAround(scene, asked, x_W);
  const auto into = std::ranges::find_if(now, [&](const std::string& name) { return !isOneOf(name, before); });
  if (into == now.end())
  {
    return std::nullopt;
  }
  const ContactPlan plan = planFor(scene, asked);
  const MovingScene rests(scene, 1.0);
  const double way_u = beyond_u({ rests, numberOf(scene, *into) }, plan.radius_u, x_W);
  std::optional<CameAround> nearest;
  for (const Vec3& d : directions())
  {
    for (const double share : { 0.25, 0.5, 1.0 }) // inside of a hollow surface the furthest place may be outside of it
    {
      const Vec3 from_W = x_W + share * way_u * d;
      const Vec3 ball_W = stopBefore(rests, plan, plan.radius_u, from_W, x_W);
      if (isWhereItWas(scene, surfacesAround(scene, asked, from_W), before) &&
          (!nearest || (ball_W - x_W).norm() < (nearest->ball_W - x_W).norm()))
      {
        nearest = CameAround{ *into, from_W, ball_W };
      }
    }
  }
  return nearest;
}

StayOutside stayOutside(
  const CameAround& around, HandHolder holder, const Vec3& device_W, const HapticParameters& parameters)
{
  const double depth_m = (around.ball_W - device_W).norm() / parameters.map.scale_u_per_m;
  const bool tooHard = parameters.stiffness_N_per_m * depth_m > parameters.safety.maxForce_N;
  StayOutside verdict;
  verdict.letGo = holder == HandHolder::Device && tooHard;
  verdict.sentence = around.surface + " now covers the hand, which stays outside: " +
                     (holder == HandHolder::Mouse ? "contact restarts in front of the surface"
                       : verdict.letGo            ? "move out of the surface, then the force returns"
                                                  : "contact continues from there");
  return verdict;
}

} // namespace palpate
