// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/wire/WirePlan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "haptics/core/Across.h"
#include "haptics/core/PoseMath.h"
#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

constexpr double mostFriction = 10.0;

bool isPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

std::string faultOf(const WireDescription& d)
{
  if (!isPositive(d.diameter_u) || d.diameter_u >= d.shape.length_u)
  {
    return "the diameter of the wire must be above 0 and below its length";
  }
  if (!isPositive(d.young_N_per_u2) || (d.tipYoung_N_per_u2 != 0.0 && !isPositive(d.tipYoung_N_per_u2)))
  {
    return "the stiffness of the wire must be a modulus [Pa] above 0";
  }
  if (!(d.poisson >= 0.0 && d.poisson < 0.5))
  {
    return "Poisson's ratio of the wire must be from 0 to below 0.5";
  }
  if (!(d.friction >= 0.0 && d.friction <= mostFriction))
  {
    return "the friction of the wire must be a number from 0 to 10";
  }
  return !d.mouth_W.allFinite()                                          ? "the mouth of the sheath must be a point"
         : d.direction_W.allFinite() && isPositive(d.direction_W.norm()) ? ""
                                                                         : "the direction of the sheath has no length";
}

/// Each beam has the section that its middle has.
std::vector<BeamSection> sectionsOf(const WireDescription& d)
{
  std::vector<BeamSection> sections;
  for (int i = 0; i < d.shape.beams; ++i)
  {
    const bool tip = (i + 0.5) * d.beam_u() > d.shape.length_u - d.shape.tip_u;
    const double young = tip && d.tipYoung_N_per_u2 > 0.0 ? d.tipYoung_N_per_u2 : d.young_N_per_u2;
    sections.push_back(roundSection(0.5 * d.diameter_u, young, d.poisson));
  }
  return sections;
}

/// Turns the frame of each node halfway between the beams at it: a sheath then holds the bend of a wire that is
/// straight in it evenly, from one node to the next.
void turnNodesHalfway(const std::vector<Vec3>& points_W, Wire& wire)
{
  const WirePlaces rest = placesAlong(points_W);
  for (int i = 1; i < wire.count; ++i)
  {
    const Quat &before = rest[i - 1].q, &after = rest[i].q;
    const double sign = before.dot(after) < 0.0 ? -1.0 : 1.0;
    const Quat half = Quat(before.coeffs() + sign * after.coeffs()).normalized();
    wire.beams[i - 1].second = half.conjugate() * before;
    wire.beams[i].first = half.conjugate() * after;
  }
}

Pose mouthOf(const WireDescription& d)
{
  const Vec3 x = d.direction_W.normalized();
  const auto [y, z] = tangentsOf(x);
  return { d.mouth_W, Quat((Mat3() << x, y, z).finished()).normalized() };
}

double awayFrom(const SurfaceData& vessel, const Vec3& p)
{
  double away_u = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < vessel.mesh.triangles.size(); ++t)
  {
    const auto [a, b, c] = vessel.cornersOf(t);
    away_u = std::min(away_u, (nearestOnTriangle(p, a, b, c) - p).norm());
  }
  return away_u;
}

void judgeMouth(const WirePlan& plan, WireCheck& check)
{
  std::ostringstream text;
  check.clearance_u = plan.mouthAway_u - plan.radius_u;
  if (!(check.clearance_u > 0.0))
  {
    text << "the wire is thicker than the vessel at the mouth: its radius is " << plan.radius_u << ", the wall is "
         << plan.mouthAway_u << " from the mouth";
    check.faults.push_back(text.str());
  }
  if (!isClosed(*plan.vessel))
  {
    check.remarks.emplace_back(
      "the vessel is open: the wire may leave it there, and stays on the side of the mouth elsewhere");
  }
  else if (sideOf(*plan.vessel, Vec3::Zero()) != PointSide::Inside)
  {
    check.faults.emplace_back("the mouth lies outside of the vessel: move it in, or turn the sheath");
  }
}

} // namespace

double WirePlan::length_u() const noexcept
{
  double length_u = 0.0;
  for (int i = 0; i < this->wire.count; ++i)
  {
    length_u += this->wire.beams[i].length_u;
  }
  return length_u;
}

WirePlaces placesInSheath(const WirePlan& plan) noexcept
{
  WirePlaces places;
  double x_u = 0.0;
  for (int i = plan.wire.count; i >= 0; --i)
  {
    places[i] = { Vec3(x_u, 0.0, 0.0), Quat::Identity() };
    x_u -= i > 0 ? plan.wire.beams[i - 1].length_u : 0.0;
  }
  return places;
}

PlannedWire planWire(const WireDescription& description, const TriangleMesh& vessel_W, std::uint64_t revision)
{
  PlannedWire planned;
  const auto refuse = [&planned](const std::string& fault)
  {
    planned.check.faults.push_back(fault);
    return planned;
  };
  const Outcome<std::vector<Vec3>> points = pointsOf(description.shape);
  const std::string fault = points.ok() ? faultOf(description) : points.problem;
  if (!fault.empty())
  {
    return refuse(fault);
  }
  const Outcome<Wire> wire = makeWire(points.value, sectionsOf(description));
  if (!wire.ok())
  {
    return refuse(wire.problem);
  }
  auto plan = std::make_shared<WirePlan>();
  plan->revision = revision;
  plan->wire = wire.value;
  turnNodesHalfway(points.value, plan->wire);
  plan->radius_u = 0.5 * description.diameter_u;
  plan->friction = description.friction;
  plan->mouth_W = mouthOf(description);
  TriangleMesh vessel_M = vessel_W;
  for (Vec3& p : vessel_M.vertices_W)
  {
    p = into(plan->mouth_W, p);
  }
  CleanResult clean = cleanMesh(vessel_M);
  if (!clean.ok())
  {
    return refuse("the vessel cannot be touched: " + clean.refusal);
  }
  plan->vessel = std::make_shared<SurfaceTree>(std::move(clean.mesh));
  plan->mouthAway_u = awayFrom(plan->vessel->data(), Vec3::Zero());
  WireCheck& check = planned.check;
  check.beams = plan->wire.count;
  check.contacts = std::min(WireTouch::most, 2 * check.beams);
  check.tightest_u = 3.0 * description.beam_u();
  check.work = newtonWork(plan->wire.nodes(), 1) + touchWork(check.contacts);
  judgeMouth(*plan, check);
  planned.plan = check.faults.empty() ? plan : nullptr;
  return planned;
}

} // namespace palpate
