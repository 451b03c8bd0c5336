// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/PlanText.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

std::string reasonOf(const SurfaceChoice& choice)
{
  const char* const meanwhile =
    choice.curves ? "coarser lines are looked for meanwhile" : "a simpler surface is looked for meanwhile";
  return choice.reason.empty() ? meanwhile : choice.reason;
}

/// All surfaces as one, with each reason once.
SurfaceChoice sumOf(const std::vector<SurfaceChoice>& choices)
{
  SurfaceChoice sum;
  for (const SurfaceChoice& choice : choices)
  {
    sum.triangles += choice.triangles;
    sum.felt += choice.felt;
    sum.bound_u = std::max(sum.bound_u, choice.bound_u);
    const std::string reason = reasonOf(choice);
    if (choice.felt == choice.triangles && sum.reason.find(reason) == std::string::npos)
    {
      sum.reason += (sum.reason.empty() ? "" : "; ") + reason;
    }
  }
  return sum;
}

/// Why a ball is as large as it was asked for.
std::string reasonForBall(const TouchChoice& touch)
{
  std::ostringstream text;
  text.precision(3);
  if (std::isinf(touch.largest_u))
  {
    text << "as set; any size can be computed within a tick";
  }
  else if (touch.asked_u <= touch.largest_u)
  {
    text << "as set; up to " << touch.largest_u << " u can be computed within a tick";
  }
  else
  {
    text << "as set and forced; above " << touch.largest_u
         << " u the work of a tick may be exceeded, and then the sphere moves only as far as is proven free";
  }
  return text.str();
}

std::string ballOf(const TouchChoice& touch)
{
  std::ostringstream text;
  text.precision(3);
  const double used_u = touch.plan.radius_u;
  const bool smaller = used_u < touch.asked_u;
  text << (used_u > 0.0 ? "a sphere of " : "a point");
  if (used_u > 0.0)
  {
    text << used_u << " u";
  }
  text << " (";
  if (smaller)
  {
    text << touch.asked_u << " u is set, but may exceed the work of a tick on triangles of this size";
  }
  else if (used_u > touch.asked_u)
  {
    text << "curves need a small sphere in place of a point";
  }
  else
  {
    text << (used_u > 0.0 ? reasonForBall(touch) : "no radius is set");
  }
  text << ")";
  return text.str();
}

std::string frictionOf(const TouchChoice& touch)
{
  std::ostringstream text;
  const FrictionPlan& friction = touch.plan.friction;
  if (!friction.none())
  {
    text << " with friction " << friction.statical << " at rest, " << friction.kinetic << " sliding (as set"
         << (touch.frictionFromData ? "; data with their own friction keep it)" : ")");
    return text.str();
  }
  return touch.frictionFromData ? " with friction from the data" : " without friction (none is set)";
}

std::string searchOf(std::size_t surfaces, std::size_t triangles)
{
  const std::string capacity = std::to_string(Leaf::capacity);
  if (surfaces == 1 && triangles <= Leaf::capacity)
  {
    return "a list (up to " + capacity + " triangles)";
  }
  return "a tree of boxes (lists of more than " + capacity + " triangles are slower)";
}

/// "9000 of 79600 triangles are felt (...)".
std::string partsOf(const SurfaceChoice& choice, const std::string& unit)
{
  std::ostringstream text;
  text.precision(3);
  if (choice.felt < choice.triangles)
  {
    text << choice.felt << " of " << choice.triangles << " " << unit << " are used (proven: no point is further than "
         << choice.bound_u << " u from the data's " << (unit == "segments" ? "lines" : "surface")
         << ", or vice versa, which is not perceptible)";
    return text.str();
  }
  text << "all " << choice.triangles << " " << unit << " are used (" << choice.reason << ")";
  return text.str();
}

std::string unitOf(const std::vector<SurfaceChoice>& choices)
{
  const auto curves =
    std::count_if(choices.begin(), choices.end(), [](const SurfaceChoice& choice) { return choice.curves; });
  const bool all = curves == static_cast<std::ptrdiff_t>(choices.size());
  return curves == 0 ? "triangles" : (all ? "segments" : "triangles and segments");
}

/// As the tree has them: a wall is two.
std::size_t feltTriangles(const std::vector<SurfaceChoice>& choices)
{
  std::size_t sum = 0;
  for (const SurfaceChoice& choice : choices)
  {
    sum += choice.felt * (choice.wall_WP ? 2 : 1);
  }
  return sum;
}

} // namespace

bool hasOwnFriction(const Scene& scene) noexcept
{
  return std::any_of(scene.surfaces().begin(), scene.surfaces().end(),
    [](const Surface& surface)
    { return surface.material.frictionStatic >= 0.0 || (surface.fields && !surface.fields->frictionStatic.empty()); });
}

double chosenRadius_u(double asked_u, double largest_u, bool keepLimit) noexcept
{
  // a radius that is not finite stays so, to be refused
  return keepLimit && std::isfinite(asked_u) ? std::min(asked_u, largest_u) : asked_u;
}

std::string planText(const SurfaceChoice& choice)
{
  return partsOf(choice, choice.curves ? "segments" : "triangles");
}

std::string planText(const std::vector<SurfaceChoice>& choices, const TouchChoice& touch)
{
  if (choices.empty())
  {
    return "no rigid surface is touched";
  }
  return partsOf(sumOf(choices), unitOf(choices)) + ", by " + ballOf(touch) + frictionOf(touch) + ", through " +
         searchOf(choices.size(), feltTriangles(choices));
}

} // namespace palpate
