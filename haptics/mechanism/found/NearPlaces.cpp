// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/TreeWalk.h"
#include "haptics/mechanism/found/ContactFinder.h"
#include "haptics/mechanism/found/NearestFace.h"
#include "haptics/mechanism/found/SoftAsMesh.h"

namespace palpate
{
namespace
{

/// Cosine from which on two normals count as turned to one another.
constexpr double facing = 0.1;
/// The same for two that are apart: places that are aside of one another meet when an answer comes that is later.
constexpr double facingApart = 0.5;
/// A direction that a sharp edge presses in lies between its triangles' normals, but for this cosine.
constexpr double aside = 0.05;
/// The same of the soft body's edges, which a dent bends the other way.
constexpr double asideInDent = 0.35;
/// Of an edge: so near to its ends, rigid edges meet as vertices. No more than `flush`, so that one of both is seen.
constexpr double nearEnd = 1e-5;
/// Of a mesh's size: a rigid vertex that is beside a face by no more is over it, as where boxes of one size are
/// stacked.
constexpr double flush = 1e-5;
/// Likewise no further below or above it, and so far beside it one of two soft bodies, which widen under pressure.
constexpr double shallow = 0.01;
/// Of the shorter edge: edges that have gone further past one another have crossed, and vertices are met instead.
constexpr double crossed = 0.3;

enum class Features : std::uint64_t
{
  OtherVertex,
  MeshVertex,
  Edges,
};

/// Three numbers of 19 bits.
std::uint64_t nameOf(Features features, int pair, std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0)
{
  constexpr std::uint64_t mask = (1u << 19) - 1;
  constexpr std::uint64_t mostPairs = 42; // of eight bodies 28 at most
  return ((static_cast<std::uint64_t>(features) * mostPairs + static_cast<std::uint64_t>(pair)) << 57) |
         ((a & mask) << 38) | ((b & mask) << 19) | (c & mask);
}

const std::vector<Vec3>& freeOf(const SidedSurface& surface, const PressedBody* soft)
{
  return soft ? soft->snapshot->free_W : surface.tree->mesh().vertices_W;
}

/// A mesh, which is rigid or a soft body's, and one other body, which is soft or stands.
class Meeting
{
public:
  explicit Meeting(const PairView& view)
    : view_(view), mesh_{ view.mesh, freeOf(view.mesh, view.softMesh), {}, {}, 0.0, {}, Box::empty() }, other_{
        view.other, freeOf(view.other, view.soft), {}, {}, 0.0, {}, Box::empty()
      }
  {
    const BentBy ofOther(view.soft, view.soft_i, view.mesh_i, view.presses);
    this->placeMesh(ofOther.most_u());
    this->other_.without_W = this->other_.bent_W = this->other_.free_W;
    this->other_.bend(ofOther, widened(this->mesh_.around, ofOther.most_u() + view.reach_u));
  }

  std::vector<NearPlace> places()
  {
    if (this->other_.near.empty())
    {
      return {};
    }
    for (const std::uint32_t v : this->other_.near)
    {
      this->lookFromOther(v);
    }
    for (const std::uint32_t v : this->mesh_.near)
    {
      this->lookFromMesh(v);
    }
    this->lookAlongEdges();
    return std::move(this->places_);
  }

private:
  /// A place of the mesh.
  struct OnMesh
  {
    Vec3 at_W = Vec3::Zero();
    SurfacePoint place; ///< of a soft one
  };

  /// `other_u`: no place of the other body is bent further.
  void placeMesh(double other_u)
  {
    const PairView& view = this->view_;
    if (view.softMesh)
    {
      const BentBy bending(view.softMesh, view.softMesh_i, view.other_i, view.presses);
      const SurfaceData& data = view.other.tree->data();
      this->mesh_.without_W = this->mesh_.bent_W = this->mesh_.free_W;
      this->mesh_.bend(bending, widened({ data.low_W, data.high_W }, other_u + bending.most_u() + view.reach_u));
      return;
    }
    this->mesh_.bent_W.reserve(this->mesh_.free_W.size());
    for (const Vec3& p : this->mesh_.free_W)
    {
      this->mesh_.bent_W.push_back(view.mesh_W * p);
      this->mesh_.around.include(this->mesh_.bent_W.back());
    }
    this->mesh_.near.resize(this->mesh_.bent_W.size());
    std::iota(this->mesh_.near.begin(), this->mesh_.near.end(), 0u);
  }

  /// Vertices of the mesh in its frame, which is W for a soft one.
  [[nodiscard]] const std::vector<Vec3>& meshVertices() const
  {
    return this->view_.softMesh ? this->mesh_.bent_W : this->mesh_.free_W;
  }

  /// `area_u2`: of the surface of a vertex.
  void add(std::uint64_t name, const OnMesh& on, const SurfacePoint& place, const Vec3& normal_W, double gap_u,
    double area_u2 = 0.0)
  {
    const bool soft = this->view_.softMesh != nullptr;
    NearPlace near;
    near.contact.name = name;
    near.contact.point_A = soft ? on.place.x_W : into(this->view_.mesh_W, on.at_W);
    near.contact.place_A = on.place;
    near.contact.place_B = place;
    near.contact.normal_B = normal_W;
    near.gap_u = gap_u;
    near.without_W = this->other_.withoutAt(place);
    near.area_u2 = 0.5 * area_u2; // the other surface has as much
    near.free_u = normal_W.dot((soft ? this->mesh_.withoutAt(on.place) : on.at_W) - near.without_W);
    this->places_.push_back(near);
  }

  /// `p`: in the frame of the mesh.
  [[nodiscard]] OnMesh onFace(const NearestFace& face) const
  {
    return { this->view_.mesh_W * face.p,
      this->view_.softMesh ? this->mesh_.placeOn(face.triangle, face.p) : SurfacePoint() };
  }

  /// A vertex of the other body outside of the mesh is met by the nearest place of the mesh; one that has come into the
  /// mesh, or lies on it, by the nearest of the mesh's sides that are turned to the body: so a thin plate has two
  /// sides.
  void lookFromOther(std::uint32_t v)
  {
    const Vec3& x_W = this->other_.bent_W[v];
    if (outsideOf(this->mesh_.around, x_W) > this->view_.reach_u)
    {
      return;
    }
    const Vec3 out_W = this->other_.surface.normalAt(v, this->other_.bent_W);
    const auto any = [](const Vec3&) { return true; };
    const Vec3 x = into(this->view_.mesh_W, x_W);
    const SidedSurface& mesh = this->mesh_.surface;
    const std::vector<Vec3>& vertices = this->meshVertices();
    const NearestFace nearest = nearestFace(mesh, vertices, x, this->view_.reach_u, this->mesh_.bent_u, any);
    if (nearest.triangle == SurfaceData::none)
    {
      return;
    }
    const std::uint64_t name = nameOf(Features::OtherVertex, this->view_.index, v);
    const SurfacePoint place = placeAt(v, this->other_.free_W);
    const bool apart = nearest.above > 0.0 && nearest.away_u > NearestFace::rounding * mesh.diagonal_u;
    const Vec3 way_W = apart ? Vec3(this->view_.mesh_W.q * Vec3((nearest.p - x) / nearest.away_u)) : out_W;
    if (apart && way_W.dot(out_W) > facingApart)
    {
      this->add(name, this->onFace(nearest), place, way_W, nearest.away_u, this->other_.areaAround(v, way_W));
    }
    if (apart && (!this->mayLieFlush() || way_W.dot(out_W) > facingApart))
    {
      return;
    }
    const Vec3 out = this->view_.mesh_W.q.conjugate() * out_W;
    const NearestFace side = nearestFace(mesh, vertices, x, this->view_.reach_u, this->mesh_.bent_u,
      [&out](const Vec3& normal) { return normal.dot(out) < -facing; });
    if (side.triangle != SurfaceData::none && (!apart || this->isOver(side, x)))
    {
      const Vec3 normal = this->pressedNormal(this->view_.softMesh, this->mesh_, side);
      const Vec3 normal_W = this->view_.mesh_W.q * Vec3(-normal);
      this->add(
        name, this->onFace(side), place, normal_W, normal.dot(x - side.p), this->other_.areaAround(v, normal_W));
    }
  }

  /// In a dent the surface is as steep as its triangles happen to be: pressed, it is taken as it is without forces.
  [[nodiscard]] static Vec3 pressedNormal(const PressedBody* soft, const SoftAsMesh& of, const NearestFace& face)
  {
    return soft ? Vec3(of.surface.areaOf(face.triangle, of.free_W).normalized()) : face.normal;
  }

  [[nodiscard]] bool isOver(const NearestFace& side, const Vec3& x) const
  {
    const double beside_u = (x - side.p - side.above * side.normal).norm();
    const double size_u = this->mesh_.surface.diagonal_u;
    return beside_u <= (this->view_.softMesh ? shallow : flush) * size_u && std::abs(side.above) <= shallow * size_u;
  }

  /// Whether a triangle of the mesh at its vertex is turned to the body.
  [[nodiscard]] bool facesAt(std::uint32_t v, const Vec3& normal_W) const
  {
    const SidedSurface& mesh = this->mesh_.surface;
    bool turned = false;
    mesh.tree->data().forEachAround(v, [&](std::uint32_t t)
      { turned = turned || mesh.areaOf(t, this->mesh_.bent_W).normalized().dot(normal_W) < -facing; });
    return turned;
  }

  /// A vertex of the mesh.
  [[nodiscard]] OnMesh onVertex(std::uint32_t v) const
  {
    return { this->mesh_.bent_W[v], this->view_.softMesh ? placeAt(v, this->mesh_.free_W) : SurfacePoint() };
  }

  void lookFromMesh(std::uint32_t v)
  {
    const Vec3& y_W = this->mesh_.bent_W[v];
    const SoftAsMesh& other = this->other_;
    if (outsideOf(other.around, y_W) > this->view_.reach_u)
    {
      return;
    }
    const auto any = [](const Vec3&) { return true; };
    const NearestFace nearest = nearestFace(other.surface, other.bent_W, y_W, this->view_.reach_u, other.bent_u, any);
    if (nearest.triangle == SurfaceData::none)
    {
      return;
    }
    const bool apart = nearest.above > 0.0 && nearest.away_u > NearestFace::rounding * this->mesh_.surface.diagonal_u;
    const Vec3 free_W = other.surface.areaOf(nearest.triangle, other.free_W).normalized();
    const Vec3 normal_W = apart ? Vec3((y_W - nearest.p) / nearest.away_u) : free_W;
    const bool faces = this->facesAt(v, normal_W) && (!apart || normal_W.dot(nearest.normal) > facingApart);
    if (this->mayLieFlush() && !(apart && faces))
    {
      this->lookFlush(v, apart);
    }
    else if (faces)
    {
      this->add(nameOf(Features::MeshVertex, this->view_.index, v), this->onVertex(v),
        other.placeOn(nearest.triangle, nearest.p), normal_W, normal_W.dot(y_W - nearest.p),
        this->mesh_.areaAround(v, -normal_W));
    }
  }

  /// Sides of bodies of one size are in line, so that the nearest face of a vertex need not be the one that it presses.
  [[nodiscard]] bool mayLieFlush() const { return this->view_.rigid || this->view_.softMesh; }

  /// A vertex that lies on such a body, or in it, has the nearest face that is turned to the vertex.
  void lookFlush(std::uint32_t v, bool apart)
  {
    const Vec3& y_W = this->mesh_.bent_W[v];
    const Vec3 out_W = this->mesh_.surface.normalAt(v, this->mesh_.bent_W);
    const SoftAsMesh& other = this->other_;
    const NearestFace side = nearestFace(other.surface, other.bent_W, y_W, this->view_.reach_u, other.bent_u,
      [&out_W](const Vec3& normal) { return normal.dot(out_W) < -facing; });
    if (side.triangle != SurfaceData::none && (!apart || this->isOver(side, y_W)))
    {
      const Vec3 normal_W = pressedNormal(this->view_.soft, other, side);
      this->add(nameOf(Features::MeshVertex, this->view_.index, v), this->onVertex(v),
        other.placeOn(side.triangle, side.p), normal_W, normal_W.dot(y_W - side.p),
        this->mesh_.areaAround(v, -normal_W));
    }
  }

  void lookAlongEdges()
  {
    for (const std::uint32_t e : this->mesh_.surface.sharp)
    {
      this->lookAlong(e);
    }
  }

  void lookAlong(std::uint32_t e)
  {
    const SidedSurface& mesh = this->mesh_.surface;
    const std::vector<Vec3>& mesh_W = this->mesh_.bent_W;
    const auto [i, j] = mesh.edges[e].ends;
    Box reached = Box::empty();
    reached.include(mesh_W[i]);
    reached.include(mesh_W[j]);
    reached = widened(reached, this->other_.bent_u + this->view_.reach_u);
    if (!overlap(this->other_.around, reached))
    {
      return;
    }
    const auto& edge = mesh.edges[e];
    const Vec3 other_W = mesh.areaOf(edge.triangles[1], mesh_W).normalized();
    const Vec3 inOne_W = inward(this->mesh_, edge.triangles[0], i, j);
    const Vec3 inOther_W = inward(this->mesh_, edge.triangles[1], i, j);
    if (inOne_W.dot(other_W) > 0.0) // a groove: no body but a sharper one reaches its bottom
    {
      return;
    }
    const SurfaceData& data = this->other_.surface.tree->data();
    forEachMeeting(
      data, [&](const Box& box) { return overlap(box, reached); },
      [&](std::uint32_t t)
      {
        const auto& corners = data.corners(t);
        for (std::size_t k = 0; k < 3; ++k)
        {
          const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
          const std::uint32_t across = data.across[t][k];
          if (t < across && (!this->view_.rigid || this->isSharp(t, across))) // each edge once
          {
            this->cross(e, t, a, b, { inOne_W, inOther_W });
          }
        }
      });
  }

  /// From an edge into one of its triangles, across the edge.
  [[nodiscard]] static Vec3 inward(const SoftAsMesh& of, std::uint32_t triangle, std::uint32_t i, std::uint32_t j)
  {
    const std::vector<Vec3>& at_W = of.bent_W;
    const Vec3 along = (at_W[j] - at_W[i]).normalized();
    const Vec3 way = at_W[of.surface.tree->data().opposite(triangle, i, j)] - at_W[i];
    return (way - along.dot(way) * along).normalized();
  }

  /// Whether both triangles at an edge of the soft body go away from a direction, or nearly.
  [[nodiscard]] bool standsOut(std::uint32_t t, std::uint32_t a, std::uint32_t b, const Vec3& normal_W) const
  {
    const std::uint32_t other = this->other_.surface.tree->data().neighbour(t, a, b);
    const auto goesAway = [&](std::uint32_t of) { return inward(this->other_, of, a, b).dot(normal_W) < asideInDent; };
    return goesAway(t) && goesAway(other);
  }

  [[nodiscard]] bool isSharp(std::uint32_t t, std::uint32_t across) const
  {
    const SoftAsMesh& other = this->other_;
    return across != SurfaceData::none &&
           other.surface.areaOf(t, other.bent_W)
               .normalized()
               .dot(other.surface.areaOf(across, other.bent_W).normalized()) < SidedSurface::sharpBelow;
  }

  /// Two edges that cross: one line stands on both.
  void cross(std::uint32_t e, std::uint32_t t, std::uint32_t a, std::uint32_t b, const std::array<Vec3, 2>& inward_W)
  {
    const std::vector<Vec3>&mesh_W = this->mesh_.bent_W, &bent_W = this->other_.bent_W;
    const auto [i, j] = this->mesh_.surface.edges[e].ends;
    const Vec3 u = mesh_W[j] - mesh_W[i];
    const Vec3 v = bent_W[b] - bent_W[a];
    Vec3 normal_W = u.cross(v);
    const double size = normal_W.norm();
    if (size < facing * u.norm() * v.norm()) // nearly parallel: their ends are looked at
    {
      return;
    }
    normal_W /= size;
    const Vec3 out_W = this->other_.surface.areaOf(t, bent_W).normalized();
    normal_W = normal_W.dot(out_W) < 0.0 ? Vec3(-normal_W) : normal_W;
    const Vec3 from_W = bent_W[a] - mesh_W[i];
    const double s = from_W.cross(v).dot(u.cross(v)) / (size * size);
    const double r = from_W.cross(u).dot(u.cross(v)) / (size * size);
    const double end = this->view_.rigid ? nearEnd : 0.0;
    const bool inside = s > end && s < 1.0 - end && r > end && r < 1.0 - end;
    const bool presses = inward_W[0].dot(normal_W) > -aside && inward_W[1].dot(normal_W) > -aside;
    if (!inside || !presses || !this->standsOut(t, a, b, normal_W))
    {
      return;
    }
    const OnMesh on{ mesh_W[i] + s * u, this->view_.softMesh ? this->mesh_.placeAlong(i, j, s) : SurfacePoint() };
    const double gap_u = normal_W.dot(on.at_W - (bent_W[a] + r * v));
    if (gap_u <= this->view_.reach_u && gap_u > -crossed * std::min(u.norm(), v.norm()))
    {
      this->add(
        nameOf(Features::Edges, this->view_.index, e, a, b), on, this->other_.placeAlong(a, b, r), normal_W, gap_u);
    }
  }

  const PairView& view_;
  SoftAsMesh mesh_;
  SoftAsMesh other_;
  std::vector<NearPlace> places_;
};

} // namespace

std::vector<SurfacePoint> nearestPlaces(
  const std::vector<NearPlace>& near, std::size_t most, SurfacePoint FoundContact::*place)
{
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    order.emplace_back(near[i].gap_u, i);
  }
  std::ranges::sort(order);
  order.resize(std::min(order.size(), most));
  std::vector<SurfacePoint> places;
  std::ranges::transform(
    order, std::back_inserter(places), [&](const auto& one) { return near[one.second].contact.*place; });
  return places;
}

double edgeAround(const SidedSurface& surface, const SurfacePoint& place)
{
  const SurfaceData& data = surface.tree->data();
  double edge_u = std::numeric_limits<double>::infinity();
  data.forEachAround(place.vertices[0],
    [&](std::uint32_t t)
    {
      const auto corner = data.cornersOf(t);
      edge_u = std::min(
        { edge_u, (corner[1] - corner[0]).norm(), (corner[2] - corner[1]).norm(), (corner[0] - corner[2]).norm() });
    });
  return edge_u;
}

std::vector<NearPlace> nearPlaces(const PairView& view)
{
  return Meeting(view).places();
}

} // namespace palpate
