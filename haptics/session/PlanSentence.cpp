// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/PlanSentence.h"

#include <algorithm>
#include <sstream>

namespace palpate
{
namespace
{

/// All surfaces as one, with each reason once.
SurfaceChoice sumOf(const std::vector<SurfaceChoice>& choices)
{
  SurfaceChoice sum;
  for (const SurfaceChoice& choice : choices)
  {
    sum.triangles += choice.triangles;
    sum.felt += choice.felt;
    sum.bound_u = std::max(sum.bound_u, choice.bound_u);
    const std::string reason = choice.reason.empty() ? "a simpler surface is looked for meanwhile" : choice.reason;
    if (choice.felt == choice.triangles && sum.reason.find(reason) == std::string::npos)
    {
      sum.reason += (sum.reason.empty() ? "" : "; ") + reason;
    }
  }
  return sum;
}

} // namespace

std::string planSentence(const SurfaceChoice& choice)
{
  std::ostringstream text;
  text.precision(3);
  if (choice.felt < choice.triangles)
  {
    text << choice.felt << " of " << choice.triangles << " triangles are felt (proven: no point is further than "
         << choice.bound_u << " u from the data's surface, or the data's from it, and that is not noticed)";
    return text.str();
  }
  text << "all " << choice.triangles << " triangles are felt (" << choice.reason << ")";
  return text.str();
}

std::string planSentence(const std::vector<SurfaceChoice>& choices, const ContactPlan& plan)
{
  if (choices.empty())
  {
    return "there is nothing to touch";
  }
  std::ostringstream text;
  text << planSentence(sumOf(choices)) << ", by ";
  if (plan.radius_u > 0.0)
  {
    text << "a ball of " << plan.radius_u << " u";
  }
  else
  {
    text << "a point";
  }
  if (plan.friction.none())
  {
    text << " without friction";
  }
  else
  {
    text << " with friction " << plan.friction.statical << " at rest, " << plan.friction.kinetic << " sliding";
  }
  text << ", through a tree of boxes";
  return text.str();
}

} // namespace palpate
