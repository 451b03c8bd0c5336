// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/feel/Shading.h"

#include <algorithm>
#include <cmath>

#include "haptics/contact/feel/Friction.h"
#include "haptics/contact/planes/ContactSet.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{
namespace
{

constexpr double smoothCosine = 0.8660254037844386; // of 30 degrees: sharper edges are meant to be felt
constexpr double trustCosine = 0.7071067811865476;  // of 45 degrees: further off the true normal no smooth one is used
constexpr int mostFaces = 128;                      // bounds a walk round a vertex; one of more faces is not smooth

/// A face on the way round a vertex, and by which side it continues the first one.
struct Step
{
  std::uint32_t triangle = SurfaceData::none;
  double side = 1.0;
};

/// The face across edge (v, w), if the surface goes on smoothly there.
template<class View>
Step across(const View& s, const Step& from, std::uint32_t v, std::uint32_t w) noexcept
{
  const std::uint32_t i = std::min(v, w), j = std::max(v, w);
  const std::uint32_t next = s.neighbour(from.triangle, i, j);
  if (next == SurfaceData::none)
  {
    return {};
  }
  const bool opposite = runsAlong(s.corners(from.triangle), i, j) != runsAlong(s.corners(next), i, j);
  const double side = opposite ? from.side : -from.side;
  const double cosine = from.side * side * s.face(from.triangle).normal_W.dot(s.face(next).normal_W);
  return cosine >= smoothCosine ? Step{ next, side } : Step{};
}

/// Normal of the triangle, times Max's weight for its corner v.
template<class View>
Vec3 weighted(const View& s, const Step& step, std::uint32_t v) noexcept
{
  const auto& t = s.corners(step.triangle);
  const std::size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
  const FaceRecord& face = s.face(step.triangle);
  const Vec3 e = face.corner_W[(k + 1) % 3] - face.corner_W[k], f = face.corner_W[(k + 2) % 3] - face.corner_W[k];
  return step.side * e.cross(f).norm() / (e.squaredNorm() * f.squaredNorm()) * face.normal_W;
}

/// Walks round v, first over the edge to `over`; adds each face that it passes. True if it came round to where it
/// began.
template<class View>
bool walkRound(
  const View& s, std::uint32_t triangle, std::uint32_t v, std::uint32_t over, Vec3& sum, int& faces) noexcept
{
  Step step{ triangle, 1.0 };
  while (faces < mostFaces)
  {
    const Step next = across(s, step, v, over);
    if (next.triangle == SurfaceData::none)
    {
      return false;
    }
    if (next.triangle == triangle)
    {
      return true;
    }
    sum += weighted(s, next, v);
    ++faces;
    over = s.opposite(next.triangle, v, over);
    step = next;
  }
  return true;
}

/// Unit normal of the smooth surface at corner v of the triangle, on the side of the triangle's own; zero where too
/// many faces meet.
template<class View>
Vec3 cornerNormal(const View& s, std::uint32_t triangle, std::uint32_t v) noexcept
{
  const auto& t = s.corners(triangle);
  const std::uint32_t first = t[0] == v ? t[1] : t[0];
  Vec3 sum = weighted(s, { triangle, 1.0 }, v);
  int faces = 1;
  if (!walkRound(s, triangle, v, first, sum, faces))
  {
    walkRound(s, triangle, v, s.opposite(triangle, v, first), sum, faces);
  }
  return faces < mostFaces ? Vec3(sum.normalized()) : Vec3(Vec3::Zero());
}

/// Unnormalised; zero where nothing smooth is known.
template<class View>
Vec3 normalOnFace(const View& s, std::uint32_t triangle, const Vec3& foot_W) noexcept
{
  const FaceRecord& face = s.face(triangle);
  const auto& t = s.corners(triangle);
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3& from = face.corner_W[(k + 1) % 3];
    const Vec3 inward = face.normal_W.cross(face.corner_W[(k + 2) % 3] - from);
    const double weight = inward.dot(foot_W - from) / inward.dot(face.corner_W[k] - from);
    sum += std::clamp(weight, 0.0, 1.0) * cornerNormal(s, triangle, t[k]);
  }
  return sum;
}

/// Between the ends' normals, as both faces of the edge have them; zero unless it is smooth.
template<class View>
Vec3 normalOnEdge(const View& s, std::uint32_t a, std::uint32_t b, const Vec3& foot_W) noexcept
{
  std::uint32_t triangle = SurfaceData::none;
  s.forEachAtEdge(a, b, [&triangle](std::uint32_t t) { triangle = std::min(triangle, t); });
  if (across(s, { triangle, 1.0 }, a, b).triangle == SurfaceData::none)
  {
    return Vec3::Zero();
  }
  const EdgeLine line = edgeLine(s, a, b);
  const double along = std::clamp((foot_W - s.vertex(a)).dot(line.unit) / line.length, 0.0, 1.0);
  return (1.0 - along) * cornerNormal(s, triangle, a) + along * cornerNormal(s, triangle, b);
}

/// Zero unless every edge at the vertex is smooth: the walk comes round and passes all faces.
template<class View>
Vec3 normalAtVertex(const View& s, std::uint32_t v) noexcept
{
  std::uint32_t triangle = SurfaceData::none;
  int all = 0;
  s.forEachAround(v,
    [&](std::uint32_t t)
    {
      triangle = std::min(triangle, t);
      ++all;
    });
  const auto& t = s.corners(triangle);
  Vec3 sum = weighted(s, { triangle, 1.0 }, v);
  int faces = 1;
  const bool round = walkRound(s, triangle, v, t[0] == v ? t[1] : t[0], sum, faces);
  return round && faces == all && faces < mostFaces ? sum : Vec3(Vec3::Zero());
}

} // namespace

template<class View>
Vec3 smoothNormal(const View& s, const ActiveFeature& f, const FeaturePlane& plane) noexcept
{
  Vec3 n = Vec3::Zero();
  switch (f.kind)
  {
    case FeatureKind::Face:
      n = normalOnFace(s, f.a, plane.foot_W);
      break;
    case FeatureKind::Edge:
      n = normalOnEdge(s, f.a, f.b, plane.foot_W);
      break;
    case FeatureKind::Vertex:
      n = normalAtVertex(s, f.a);
      break;
  }
  const double length = n.norm();
  if (length == 0.0)
  {
    return plane.n;
  }
  n *= (n.dot(plane.n) < 0.0 ? -1.0 : 1.0) / length;
  return n.dot(plane.n) >= trustCosine ? n : plane.n;
}

namespace
{

/// The frictionless goal, as a displacement from x within the touched planes.
template<SceneView AnyScene>
Vec3 shadedGoal(ContactSet<AnyScene>& contacts, const ProjectionResult& held, const Vec3& q) noexcept
{
  std::array<PlaneRow, 3> rows;
  for (int k = 0; k < held.count; ++k)
  {
    const auto at = static_cast<std::size_t>(k);
    const ActiveFeature& f = contacts.feature(held.active[at]);
    rows[at] = contacts.row(held.active[at], contacts.lift());
    rows[at].n = smoothNormal(contacts.surface(f), f, contacts.plane(f));
  }
  const std::span<const PlaneRow> smooth(rows.data(), static_cast<std::size_t>(held.count));
  const ProjectionResult shaded = projectOntoPlanes(smooth, q, contacts.resolution().tol());
  const Vec3 press = q - held.y; // keeps the planes touched
  const ProjectionResult goal = contacts.solve(shaded.y + press, contacts.lift());
  return shaded.feasible && goal.feasible ? goal.y : held.y;
}

} // namespace

template<SceneView AnyScene>
ShadedStep judgeShading(
  const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, bool slipping, GodObjectState& state) noexcept
{
  ContactSet<AnyScene> contacts(scene, plan.radius_u, state);
  contacts.include(p_W);
  contacts.relinearise();
  const Vec3 q = p_W - state.x_W;
  const ProjectionResult held = contacts.solve(q, contacts.lift());
  ShadedStep step;
  if (held.count == 0 || !held.feasible)
  {
    return step;
  }
  step.touches = true;
  const Vec3 goal = shadedGoal(contacts, held, q);
  const double behind = goal.norm();
  double trail = 0.0;
  if (frictionMatters(scene, plan))
  {
    const FrictionReach reach = reachOf(scene, plan, contacts, held);
    state.slips = slipping || behind > (state.slips ? reach.kinetic : reach.statical);
    step.motion = state.slips ? FrictionState::Slips : FrictionState::Sticks;
    trail = reach.kinetic;
  }
  const double way = behind - trail;
  if (step.motion == FrictionState::Sticks || way <= contacts.resolution().tol())
  {
    return step;
  }
  step.rests = false;
  const Vec3 press = q - held.y;
  const double depth = press.norm();
  step.target_W = state.x_W + (way / behind) * goal + (std::min(0.5 * way, depth) / depth) * press;
  return step;
}

template Vec3 smoothNormal(const SurfaceData&, const ActiveFeature&, const FeaturePlane&) noexcept;
template Vec3 smoothNormal(const PosedSurface&, const ActiveFeature&, const FeaturePlane&) noexcept;
template ShadedStep judgeShading(const Scene&, const ContactPlan&, const Vec3&, bool, GodObjectState&) noexcept;
template ShadedStep judgeShading(const MovingScene&, const ContactPlan&, const Vec3&, bool, GodObjectState&) noexcept;

} // namespace palpate
