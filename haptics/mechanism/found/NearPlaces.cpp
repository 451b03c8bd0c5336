// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "haptics/compliance/snapshot/PointCompliance.h"
#include "haptics/core/PoseMath.h"
#include "haptics/geometry/mesh/TriangleWeights.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/TreeWalk.h"
#include "haptics/mechanism/found/ContactFinder.h"
#include "haptics/mechanism/found/NearestFace.h"

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
/// Likewise no further below or above it.
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
  constexpr std::uint64_t mostPairs = 42; // of eight bodies 19 at most: one held, four soft, three that stand
  return ((static_cast<std::uint64_t>(features) * mostPairs + static_cast<std::uint64_t>(pair)) << 57) |
         ((a & mask) << 38) | ((b & mask) << 19) | (c & mask);
}

/// One mesh and one other body, which is soft or stands.
class Meeting
{
public:
  explicit Meeting(const PairView& view)
    : view_(view), mesh_(view.mesh), other_(view.other),
      free_W_(view.soft ? view.soft->snapshot->free_W : view.other.tree->mesh().vertices_W), without_W_(free_W_),
      bent_W_(free_W_)
  {
    const SurfaceData& data = this->mesh_.tree->data();
    this->mesh_W_.reserve(data.mesh.vertices_W.size());
    this->around_ = Box::empty();
    for (const Vec3& p : data.mesh.vertices_W)
    {
      this->mesh_W_.push_back(view.mesh_W * p);
      this->around_.include(this->mesh_W_.back());
    }
    this->bend();
  }

  std::vector<NearPlace> places()
  {
    if (this->vertices_.empty())
    {
      return {};
    }
    for (const std::uint32_t v : this->vertices_)
    {
      this->lookFromOther(v);
    }
    for (std::uint32_t v = 0; v < this->mesh_W_.size(); ++v)
    {
      this->lookFromMesh(v);
    }
    this->lookAlongEdges();
    return std::move(this->places_);
  }

private:
  [[nodiscard]] static SurfacePoint placeAt(std::uint32_t v, const std::vector<Vec3>& free_W)
  {
    return { { v, v, v }, Vec3(1.0, 0.0, 0.0), free_W[v] };
  }

  /// Where the vertices near the mesh are under the forces, by the same compliance as in the tick.
  void bend()
  {
    struct Force
    {
      CompliantPoint at;
      Vec3 force_N;
      bool isOwn; ///< one of those without which places are judged
    };
    std::vector<Force> forces;
    for (const MechanismPress& press : this->view_.presses)
    {
      if (this->view_.soft && press.soft == this->view_.soft_i && press.force_N != Vec3::Zero())
      {
        forces.push_back({ compliantPoint(*this->view_.soft->snapshot, press.at), press.force_N,
          this->view_.mesh_i < 0 || press.from == this->view_.mesh_i });
      }
    }
    const auto bentBy = [&](const CompliantPoint& at, bool own)
    {
      Vec3 sum = Vec3::Zero();
      for (const Force& force : forces)
      {
        sum += force.isOwn == own ? Vec3(complianceBetween(*this->view_.soft->snapshot, at, force.at) * force.force_N)
                                  : Vec3(Vec3::Zero());
      }
      return sum;
    };
    for (const Force& force : forces)
    {
      this->bent_u_ = std::max(this->bent_u_, (bentBy(force.at, true) + bentBy(force.at, false)).norm());
    }
    this->bent_u_ *= 1.5; // a vertex beside the forces may go a little further
    const double slack_u = this->bent_u_ + this->view_.reach_u;
    Box reached{ this->around_.low_W.array() - slack_u, this->around_.high_W.array() + slack_u };
    std::vector<char> is(this->bent_W_.size(), 0);
    forEachMeeting(
      this->other_.tree->data(), [&](const Box& box) { return overlap(box, reached); },
      [&](std::uint32_t t)
      {
        for (const std::uint32_t v : this->other_.tree->data().corners(t))
        {
          is[v] = 1;
        }
      });
    for (std::uint32_t v = 0; v < is.size(); ++v)
    {
      if (is[v])
      {
        this->vertices_.push_back(v);
        if (!forces.empty())
        {
          const CompliantPoint at = compliantPoint(*this->view_.soft->snapshot, placeAt(v, this->free_W_));
          this->without_W_[v] += bentBy(at, false);
          this->bent_W_[v] = this->without_W_[v] + bentBy(at, true);
        }
        this->bent_u_ = std::max(this->bent_u_, (this->bent_W_[v] - this->free_W_[v]).norm());
        this->bentAround_.include(this->bent_W_[v]);
      }
    }
  }

  void add(std::uint64_t name, const Vec3& onMesh_W, const SurfacePoint& place, const Vec3& normal_W, double gap_u)
  {
    NearPlace near;
    near.contact.name = name;
    near.contact.point_A = into(this->view_.mesh_W, onMesh_W);
    near.contact.place_B = place;
    near.contact.normal_B = normal_W;
    near.gap_u = gap_u;
    for (std::size_t c = 0; c < 3; ++c)
    {
      near.without_W += place.weights[static_cast<Eigen::Index>(c)] * this->without_W_[place.vertices[c]];
    }
    near.free_u = normal_W.dot(onMesh_W - near.without_W);
    this->places_.push_back(near);
  }

  /// A vertex of the other body outside of the mesh is met by the nearest place of the mesh; one that has come into the
  /// mesh, or lies on it, by the nearest of the mesh's sides that are turned to the body: so a thin plate has two
  /// sides.
  void lookFromOther(std::uint32_t v)
  {
    const Vec3& x_W = this->bent_W_[v];
    if (outsideOf(this->around_, x_W) > this->view_.reach_u)
    {
      return;
    }
    const Vec3 out_W = this->other_.normalAt(v, this->bent_W_);
    const auto any = [](const Vec3&) { return true; };
    const Vec3 x = into(this->view_.mesh_W, x_W);
    const std::vector<Vec3>& vertices = this->mesh_.tree->mesh().vertices_W;
    const NearestFace nearest = nearestFace(this->mesh_, vertices, x, this->view_.reach_u, 0.0, any);
    if (nearest.triangle == SurfaceData::none)
    {
      return;
    }
    const std::uint64_t name = nameOf(Features::OtherVertex, this->view_.index, v);
    const SurfacePoint place = placeAt(v, this->free_W_);
    const bool apart = nearest.above > 0.0 && nearest.away_u > NearestFace::rounding * this->mesh_.diagonal_u;
    const Vec3 way_W = apart ? Vec3(this->view_.mesh_W.q * Vec3((nearest.p - x) / nearest.away_u)) : out_W;
    if (apart && way_W.dot(out_W) > facingApart)
    {
      this->add(name, this->view_.mesh_W * nearest.p, place, way_W, nearest.away_u);
    }
    if (apart && (!this->view_.rigid || way_W.dot(out_W) > facingApart))
    {
      return;
    }
    const Vec3 out = this->view_.mesh_W.q.conjugate() * out_W;
    const NearestFace side = nearestFace(this->mesh_, vertices, x, this->view_.reach_u, 0.0,
      [&out](const Vec3& normal) { return normal.dot(out) < -facing; });
    if (side.triangle != SurfaceData::none && (!apart || this->isOver(side, x)))
    {
      const Vec3 normal_W = this->view_.mesh_W.q * Vec3(-side.normal);
      this->add(name, this->view_.mesh_W * side.p, place, normal_W, side.above);
    }
  }

  [[nodiscard]] bool isOver(const NearestFace& side, const Vec3& x) const
  {
    const double beside_u = (x - side.p - side.above * side.normal).norm();
    return beside_u <= flush * this->mesh_.diagonal_u && std::abs(side.above) <= shallow * this->mesh_.diagonal_u;
  }

  /// Whether a triangle of the mesh at its vertex is turned to the body.
  [[nodiscard]] bool facesAt(std::uint32_t v, const Vec3& normal_W) const
  {
    bool turned = false;
    this->mesh_.tree->data().forEachAround(v, [&](std::uint32_t t)
      { turned = turned || this->mesh_.areaOf(t, this->mesh_W_).normalized().dot(normal_W) < -facing; });
    return turned;
  }

  void lookFromMesh(std::uint32_t v)
  {
    const Vec3& y_W = this->mesh_W_[v];
    if (outsideOf(this->bentAround_, y_W) > this->view_.reach_u)
    {
      return;
    }
    const auto any = [](const Vec3&) { return true; };
    const NearestFace nearest = nearestFace(this->other_, this->bent_W_, y_W, this->view_.reach_u, this->bent_u_, any);
    if (nearest.triangle == SurfaceData::none)
    {
      return;
    }
    const bool apart = nearest.above > 0.0 && nearest.away_u > NearestFace::rounding * this->mesh_.diagonal_u;
    // In a dent the surface is as steep as its triangles happen to be: pressed, it is taken as it is without forces.
    const Vec3 free_W = this->other_.areaOf(nearest.triangle, this->free_W_).normalized();
    const Vec3 normal_W = apart ? Vec3((y_W - nearest.p) / nearest.away_u) : free_W;
    const bool faces = this->facesAt(v, normal_W) && (!apart || normal_W.dot(nearest.normal) > facingApart);
    if (this->view_.rigid && !(apart && faces))
    {
      this->lookFlush(v, apart);
    }
    else if (faces)
    {
      this->add(nameOf(Features::MeshVertex, this->view_.index, v), y_W, this->placeOn(nearest.triangle, nearest.p),
        normal_W, normal_W.dot(y_W - nearest.p));
    }
  }

  /// A vertex that lies on a rigid body, or in it, has the nearest face that is turned to the vertex.
  void lookFlush(std::uint32_t v, bool apart)
  {
    const Vec3& y_W = this->mesh_W_[v];
    const Vec3 out_W = this->mesh_.normalAt(v, this->mesh_W_);
    const NearestFace side = nearestFace(this->other_, this->bent_W_, y_W, this->view_.reach_u, 0.0,
      [&out_W](const Vec3& normal) { return normal.dot(out_W) < -facing; });
    if (side.triangle != SurfaceData::none && (!apart || this->isOver(side, y_W)))
    {
      this->add(nameOf(Features::MeshVertex, this->view_.index, v), y_W, this->placeOn(side.triangle, side.p),
        side.normal, side.above);
    }
  }

  /// A place of the bent surface, as a place of the free one.
  [[nodiscard]] SurfacePoint placeOn(std::uint32_t triangle, const Vec3& bent_W) const
  {
    const auto& corners = this->other_.tree->data().corners(triangle);
    const std::vector<Vec3>& free_W = this->free_W_;
    const Vec3 weights =
      weightsOnTriangle(this->bent_W_[corners[0]], this->bent_W_[corners[1]], this->bent_W_[corners[2]], bent_W);
    return { corners, weights,
      weights[0] * free_W[corners[0]] + weights[1] * free_W[corners[1]] + weights[2] * free_W[corners[2]] };
  }

  void lookAlongEdges()
  {
    for (const std::uint32_t e : this->mesh_.sharp)
    {
      this->lookAlong(e);
    }
  }

  void lookAlong(std::uint32_t e)
  {
    const auto [i, j] = this->mesh_.edges[e].ends;
    const double slack_u = this->bent_u_ + this->view_.reach_u;
    Box reached = Box::empty();
    reached.include(this->mesh_W_[i]);
    reached.include(this->mesh_W_[j]);
    reached = { reached.low_W.array() - slack_u, reached.high_W.array() + slack_u };
    if (!overlap(this->bentAround_, reached))
    {
      return;
    }
    const auto& edge = this->mesh_.edges[e];
    const Vec3 other_W = this->mesh_.areaOf(edge.triangles[1], this->mesh_W_).normalized();
    const Vec3 inOne_W = inward(this->mesh_, this->mesh_W_, edge.triangles[0], i, j);
    const Vec3 inOther_W = inward(this->mesh_, this->mesh_W_, edge.triangles[1], i, j);
    if (inOne_W.dot(other_W) > 0.0) // a groove: no body but a sharper one reaches its bottom
    {
      return;
    }
    forEachMeeting(
      this->other_.tree->data(), [&](const Box& box) { return overlap(box, reached); },
      [&](std::uint32_t t)
      {
        const auto& corners = this->other_.tree->data().corners(t);
        for (std::size_t k = 0; k < 3; ++k)
        {
          const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
          const std::uint32_t across = this->other_.tree->data().across[t][k];
          if (t < across && (!this->view_.rigid || this->isSharp(t, across))) // each edge once
          {
            this->cross(e, t, a, b, { inOne_W, inOther_W });
          }
        }
      });
  }

  /// From an edge into one of its triangles, across the edge.
  [[nodiscard]] static Vec3 inward(const SidedSurface& surface, const std::vector<Vec3>& vertices,
    std::uint32_t triangle, std::uint32_t i, std::uint32_t j)
  {
    const Vec3 along = (vertices[j] - vertices[i]).normalized();
    const Vec3 way = vertices[surface.tree->data().opposite(triangle, i, j)] - vertices[i];
    return (way - along.dot(way) * along).normalized();
  }

  /// Whether both triangles at an edge of the soft body go away from a direction, or nearly.
  [[nodiscard]] bool standsOut(std::uint32_t t, std::uint32_t a, std::uint32_t b, const Vec3& normal_W) const
  {
    const std::uint32_t other = this->other_.tree->data().neighbour(t, a, b);
    const auto goesAway = [&](std::uint32_t of)
    { return inward(this->other_, this->bent_W_, of, a, b).dot(normal_W) < asideInDent; };
    return goesAway(t) && goesAway(other);
  }

  [[nodiscard]] bool isSharp(std::uint32_t t, std::uint32_t across) const
  {
    return across != SurfaceData::none &&
           this->other_.areaOf(t, this->bent_W_)
               .normalized()
               .dot(this->other_.areaOf(across, this->bent_W_).normalized()) < SidedSurface::sharpBelow;
  }

  /// Two edges that cross: one line stands on both.
  void cross(std::uint32_t e, std::uint32_t t, std::uint32_t a, std::uint32_t b, const std::array<Vec3, 2>& inward_W)
  {
    const auto [i, j] = this->mesh_.edges[e].ends;
    const Vec3 u = this->mesh_W_[j] - this->mesh_W_[i];
    const Vec3 v = this->bent_W_[b] - this->bent_W_[a];
    Vec3 normal_W = u.cross(v);
    const double size = normal_W.norm();
    if (size < facing * u.norm() * v.norm()) // nearly parallel: their ends are looked at
    {
      return;
    }
    normal_W /= size;
    const Vec3 out_W = this->other_.areaOf(t, this->bent_W_).normalized();
    normal_W = normal_W.dot(out_W) < 0.0 ? Vec3(-normal_W) : normal_W;
    const Vec3 from_W = this->bent_W_[a] - this->mesh_W_[i];
    const double s = from_W.cross(v).dot(u.cross(v)) / (size * size);
    const double r = from_W.cross(u).dot(u.cross(v)) / (size * size);
    const double end = this->view_.rigid ? nearEnd : 0.0;
    const bool inside = s > end && s < 1.0 - end && r > end && r < 1.0 - end;
    const bool presses = inward_W[0].dot(normal_W) > -aside && inward_W[1].dot(normal_W) > -aside;
    if (!inside || !presses || !this->standsOut(t, a, b, normal_W))
    {
      return;
    }
    const Vec3 onMesh_W = this->mesh_W_[i] + s * u;
    const Vec3 onSoft_W = this->bent_W_[a] + r * v;
    const double gap_u = normal_W.dot(onMesh_W - onSoft_W);
    if (gap_u <= this->view_.reach_u && gap_u > -crossed * std::min(u.norm(), v.norm()))
    {
      const std::vector<Vec3>& free_W = this->free_W_;
      const SurfacePoint place{ { a, b, b }, Vec3(1.0 - r, r, 0.0), (1.0 - r) * free_W[a] + r * free_W[b] };
      this->add(nameOf(Features::Edges, this->view_.index, e, a, b), onMesh_W, place, normal_W, gap_u);
    }
  }

  const PairView& view_;
  const SidedSurface& mesh_;
  const SidedSurface& other_;
  const std::vector<Vec3>& free_W_;     ///< vertices of the other body without forces
  std::vector<Vec3> mesh_W_;            ///< vertices of the mesh
  Box around_;                          ///< them
  std::vector<Vec3> without_W_;         ///< near the mesh as the forces bend them that are not the mesh's
  std::vector<Vec3> bent_W_;            ///< near the mesh as all forces bend them
  Box bentAround_ = Box::empty();       ///< of these
  double bent_u_ = 0.0;                 ///< none of them is further from where it is free
  std::vector<std::uint32_t> vertices_; ///< of the soft body, near the mesh
  std::vector<NearPlace> places_;
};

} // namespace

std::vector<SurfacePoint> nearestPlaces(const std::vector<NearPlace>& near, std::size_t most)
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
    order, std::back_inserter(places), [&near](const auto& one) { return near[one.second].contact.place_B; });
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
