// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/check/BodiesOverlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/simplify/SurfaceDistance.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/mechanism/check/InnerVertices.h"
#include "haptics/mechanism/check/MechanismFaults.h"
#include "haptics/mechanism/sided/SidedSurface.h"

namespace palpate
{
namespace
{

/// Of an edge, of a box: by less they touch.
constexpr double touches = 1e-6;

struct Edge
{
  Vec3 from_W;
  Vec3 to_W;
};

/// A little inside of the box, so that edges of boxes that stand in line with each other are not on their faces.
Vec3 cornerOf(const MechanismBody& box, int corner)
{
  const Vec3 signs(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
  const Vec3 half_u = (1.0 - 2.0 * touches) * box.halfSize_u;
  return box.pose_W.p + box.pose_W.q.normalized() * half_u.cwiseProduct(signs);
}

std::vector<Edge> edgesOf(const MechanismBody& box)
{
  std::vector<Edge> edges;
  for (int corner = 0; corner < 8; ++corner)
  {
    for (const int along : { 1, 2, 4 })
    {
      if ((corner & along) == 0)
      {
        edges.push_back({ cornerOf(box, corner), cornerOf(box, corner | along) });
      }
    }
  }
  return edges;
}

const SurfaceTree& surfaceOf(const PressedBody& body)
{
  return *body.scene->surfaces()[body.touch.surface].tree;
}

/// The surface of a soft body, which encloses a part of space where it is closed.
struct SoftSurface
{
  const SurfaceTree& tree;
  bool closed = false;
};

std::vector<Edge> edgesOf(const SoftSurface& body)
{
  const TriangleMesh& mesh = body.tree.mesh();
  const std::vector<Vec3> at_W = body.closed ? verticesInside(mesh, touches) : mesh.vertices_W;
  std::vector<Edge> edges;
  for (const auto& [low, high] : edgesOf(mesh))
  {
    edges.push_back({ at_W[low], at_W[high] });
  }
  return edges;
}

/// Whether a part of the edge lies in the box (of its three slabs).
bool passes(const MechanismBody& box, const Edge& edge)
{
  const Quat back = box.pose_W.q.normalized().conjugate();
  const Vec3 from = back * (edge.from_W - box.pose_W.p);
  const Vec3 way = back * (edge.to_W - edge.from_W);
  double first = 0.0, last = 1.0;
  for (int k = 0; k < 3; ++k)
  {
    const double half = (1.0 - touches) * box.halfSize_u[k];
    if (way[k] == 0.0)
    {
      last = std::abs(from[k]) < half ? last : -1.0;
      continue;
    }
    const double a = (-half - from[k]) / way[k], b = (half - from[k]) / way[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first < last;
}

/// Whether a part of the edge lies inside of the surface where that is closed: the middle between two points at which
/// the edge meets the surface is looked at, so it does not matter whether these are on edges or vertices. Where the
/// surface is open: whether the edge passes through it, and not only ends there.
bool passes(const SoftSurface& body, const Edge& edge)
{
  const Vec3 way_W = edge.to_W - edge.from_W;
  const double length_u = way_W.norm();
  if (!(length_u > 0.0))
  {
    return false;
  }
  const Vec3 along_W = way_W / length_u;
  if (!body.closed)
  {
    const auto hit = firstHit(body.tree, edge.from_W, along_W, touches * length_u);
    return hit && hit->way_u < (1.0 - touches) * length_u;
  }
  for (double from_u = 0.0, to_u = 0.0; from_u < length_u; from_u = to_u)
  {
    const auto hit = firstHit(body.tree, edge.from_W, along_W, from_u);
    to_u = hit ? std::min(hit->way_u, length_u) : length_u;
    const Vec3 middle_W = edge.from_W + 0.5 * (from_u + to_u) * along_W;
    if (to_u - from_u > touches * length_u && sideOf(body.tree, middle_W) == PointSide::Inside)
    {
      return true;
    }
  }
  return false;
}

/// A held rod, from the hand to its tip.
struct Rod
{
  Edge line;
};

std::vector<Edge> edgesOf(const Rod& rod)
{
  return { rod.line };
}
bool passes(const Rod&, const Edge&)
{
  return false; // a line has no inside
}

/// A held mesh where it stands.
struct StandingMesh
{
  std::shared_ptr<const SurfaceTree> tree; ///< null: rounding has left a triangle without area
};

StandingMesh standing(const SidedSurface& mesh, const Pose& pose_W)
{
  std::vector<Vec3> at_W = mesh.tree->mesh().vertices_W;
  std::ranges::transform(at_W, at_W.begin(), [&pose_W](const Vec3& p) { return pose_W * p; });
  return { mesh.tree->refitted(std::move(at_W)).tree };
}

using Bounds = Eigen::AlignedBox3d;

Bounds boundsOf(const MechanismBody& box)
{
  Bounds bounds;
  for (int corner = 0; corner < 8; ++corner)
  {
    bounds.extend(cornerOf(box, corner));
  }
  return bounds;
}
Bounds boundsOf(const PressedBody& body)
{
  return { surfaceOf(body).data().low_W, surfaceOf(body).data().high_W };
}
Bounds boundsOf(const StandingMesh& mesh)
{
  return mesh.tree ? Bounds(mesh.tree->data().low_W, mesh.tree->data().high_W) : Bounds();
}
Bounds boundsOf(const Rod& rod)
{
  return Bounds(rod.line.from_W).extend(rod.line.to_W);
}

SoftSurface shapeOf(const PressedBody& body)
{
  return { surfaceOf(body), isClosed(surfaceOf(body)) };
}
SoftSurface shapeOf(const StandingMesh& mesh)
{
  return { *mesh.tree, true };
}
const MechanismBody& shapeOf(const MechanismBody& box)
{
  return box;
}
const Rod& shapeOf(const Rod& rod)
{
  return rod;
}

/// Two bodies that overlap have surfaces that meet, and then an edge of one is in the other at the point, or one lies
/// in the other with all of its edges.
template<class A, class B>
bool overlap(const A& a, const B& b)
{
  const Bounds common = boundsOf(a).intersection(boundsOf(b));
  if (common.isEmpty())
  {
    return false;
  }
  const auto through = [&common](const auto& edges, const auto& other)
  {
    return std::ranges::any_of(edges, [&](const Edge& edge)
      { return common.intersects(Bounds(edge.from_W).extend(edge.to_W)) && passes(other, edge); });
  };
  const auto& shapeA = shapeOf(a);
  const auto& shapeB = shapeOf(b);
  return through(edgesOf(shapeA), shapeB) || through(edgesOf(shapeB), shapeA);
}

/// Bodies as they are looked at: each where it is, and of those that a rod or a box does not stand for their surface.
class Looked
{
public:
  Looked(const Mechanism& mechanism, std::span<const MechanismSoft> soft) : mechanism_(mechanism), soft_(soft) {}

  /// Calls `with` for each two of them whose kinds are wanted; where it says that they overlap they are a pair.
  template<class Wanted>
  [[nodiscard]] std::vector<BodyPair> pairs(const Wanted& wanted) const
  {
    std::vector<BodyPair> pairs;
    const auto& bodies = this->mechanism_.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (wanted(j, i) &&
            this->visit(j, [&](const auto& a) { return this->visit(i, [&](const auto& b) { return overlap(a, b); }); }))
        {
          pairs.emplace_back(bodies[j].name, bodies[i].name);
        }
      }
    }
    return pairs;
  }

  std::span<const Pose> pose_W; ///< none: bodies are as they stand, and nothing is held
  bool meshes = false;          ///< a held mesh is looked at as well
  bool worlds = false;          ///< so is one that stands
  bool watched = false;         ///< in each tick: loose ones are left out, whose contacts are found

private:
  template<class With>
  [[nodiscard]] bool visit(std::size_t b, const With& with) const
  {
    MechanismBody body = this->mechanism_.bodies[b];
    const bool moved = b < this->pose_W.size();
    body.pose_W = moved ? this->pose_W[b] : body.pose_W;
    const MechanismSoft* soft = softNamed(this->soft_, body.name);
    switch (body.kind)
    {
      case MechanismBodyKind::Rigid:
        return isLoose(body) && body.mesh ? !this->watched && with(standing(*body.mesh, body.pose_W)) : with(body);
      case MechanismBodyKind::Soft:
        return soft && soft->body && with(*soft->body);
      case MechanismBodyKind::Held:
        return body.mesh
                 ? this->meshes && moved && with(standing(*body.mesh, body.pose_W))
                 : moved &&
                     with(Rod{ { body.pose_W.p, body.pose_W.p + body.length_u * (body.pose_W.q * Vec3::UnitZ()) } });
      case MechanismBodyKind::World:
        return this->worlds && body.mesh && with(standing(*body.mesh, body.pose_W));
      case MechanismBodyKind::Wire:
        return false; // alone
    }
    return false;
  }

  const Mechanism& mechanism_;
  std::span<const MechanismSoft> soft_;
};

/// Of vertices of a mesh, and of their mean, in another one.
double deepestIn(const SurfaceTree& other, const SurfaceTree& mesh)
{
  std::vector<Vec3> inner_W = verticesInside(mesh.mesh(), touches);
  Vec3 mean_W = Vec3::Zero();
  for (const Vec3& p_W : inner_W)
  {
    mean_W += p_W / static_cast<double>(inner_W.size());
  }
  inner_W.push_back(mean_W);
  const Bounds bounds(other.data().low_W, other.data().high_W);
  double deepest_u = 0.0;
  for (const Vec3& p_W : inner_W)
  {
    if (bounds.contains(p_W) && sideOf(other, p_W) == PointSide::Inside)
    {
      deepest_u = std::max(deepest_u, nearestOn(other.data(), p_W).distance_u);
    }
  }
  return deepest_u;
}

/// Constraints that join points hold with any force, and with none.
bool holds(ConstraintKind kind, ConstraintPhase phase)
{
  const bool joins = kind == ConstraintKind::Attachment || kind == ConstraintKind::Hinge ||
                     kind == ConstraintKind::Slider || kind == ConstraintKind::Break;
  return phase != ConstraintPhase::Gone && (joins || phase != ConstraintPhase::Open);
}

bool isBetween(const MechanismConstraint& law, const BodyPair& pair)
{
  return BodyPair(law.a, law.b) == pair || BodyPair(law.b, law.a) == pair;
}

} // namespace

std::vector<BodyPair> overlapsOf(const Mechanism& mechanism, std::span<const MechanismSoft> soft)
{
  Looked looked(mechanism, soft);
  looked.worlds = true;
  const auto moves = [&mechanism](std::size_t b) { return mechanism.bodies[b].kind != MechanismBodyKind::World; };
  return looked.pairs([&moves](std::size_t a, std::size_t b) { return moves(a) || moves(b); });
}

double overlapDepth(const Mechanism& mechanism, const BodyPair& pair)
{
  const auto standingAt = [&mechanism](const std::string& name)
  {
    const MechanismBody& body = mechanism.bodies[static_cast<std::size_t>(bodyNamed(mechanism, name))];
    return standing(*body.mesh, { body.pose_W.p, body.pose_W.q.normalized() });
  };
  const StandingMesh a = standingAt(pair.first), b = standingAt(pair.second);
  return a.tree && b.tree ? std::max(deepestIn(*a.tree, *b.tree), deepestIn(*b.tree, *a.tree)) : 0.0;
}

std::vector<BodyPair> overlapsOfHeld(
  const Mechanism& mechanism, std::span<const MechanismSoft> soft, const Pose& hand_W)
{
  const auto isHeld = [&mechanism](std::size_t b) { return mechanism.bodies[b].kind == MechanismBodyKind::Held; };
  std::vector<Pose> pose_W;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b)
  {
    const Pose& rest_W = mechanism.bodies[b].pose_W;
    pose_W.push_back(
      isHeld(b) ? Pose{ hand_W.p, hand_W.q * rest_W.q.normalized() } : Pose{ rest_W.p, rest_W.q.normalized() });
  }
  Looked looked(mechanism, soft);
  looked.pose_W = pose_W;
  looked.meshes = looked.worlds = true;
  std::vector<BodyPair> pairs = looked.pairs([&](std::size_t a, std::size_t b) { return isHeld(a) || isHeld(b); });
  std::erase_if(pairs,
    [&](const BodyPair& pair) {
      return std::ranges::any_of(mechanism.laws, [&](const MechanismConstraint& law) { return isBetween(law, pair); });
    });
  return pairs;
}

std::string looseInHand(const Mechanism& mechanism, const Pose& held_W)
{
  Mechanism both = mechanism; // of the others no one comes back
  std::erase_if(both.bodies,
    [](const MechanismBody& body) { return body.kind != MechanismBodyKind::Held && !(isLoose(body) && body.mesh); });
  const auto held = std::ranges::find(both.bodies, MechanismBodyKind::Held, &MechanismBody::kind);
  if (held == both.bodies.end())
  {
    return "";
  }
  const Pose hand_W{ held_W.p, held_W.q * held->pose_W.q.normalized().conjugate() };
  const std::vector<BodyPair> pairs = overlapsOfHeld(both, {}, hand_W);
  return pairs.empty() ? "" : pairs.front().first == held->name ? pairs.front().second : pairs.front().first;
}

const std::vector<BodyPair>& OverlapWatch::look(const Mechanism& mechanism, std::span<const MechanismSoft> soft,
  std::span<const Pose> pose_W, std::span<const ConstraintPhase> phases)
{
  Looked looked(mechanism, soft);
  looked.pose_W = pose_W;
  looked.watched = true;
  const auto isSoft = [&mechanism](std::size_t b) { return mechanism.bodies[b].kind == MechanismBodyKind::Soft; };
  std::vector<std::uint64_t> computed;
  for (const MechanismSoft& body : soft)
  {
    computed.push_back(body.body ? body.body->revision : 0);
  }
  if (mechanism.findsContacts)
  {
    this->computed_.clear();
    this->soft_.clear();
  }
  else if (computed != this->computed_)
  {
    this->computed_ = std::move(computed);
    this->soft_ = looked.pairs([&](std::size_t a, std::size_t b) { return isSoft(a) && isSoft(b); });
  }
  this->seen_ = looked.pairs([&](std::size_t a, std::size_t b) { return !isSoft(a) || !isSoft(b); });
  this->seen_.insert(this->seen_.end(), this->soft_.begin(), this->soft_.end());
  std::erase_if(this->seen_,
    [&](const BodyPair& pair)
    {
      for (std::size_t l = 0; l < mechanism.laws.size() && l < phases.size(); ++l)
      {
        const MechanismConstraint& law = mechanism.laws[l];
        if (isBetween(law, pair) && holds(law.kind, phases[l]))
        {
          return true;
        }
      }
      return false;
    });
  return this->seen_;
}

std::string overlapText(const BodyPair& pair)
{
  return "bodies \"" + pair.first + "\" and \"" + pair.second + "\" overlap: no active constraint joins them";
}

} // namespace palpate
