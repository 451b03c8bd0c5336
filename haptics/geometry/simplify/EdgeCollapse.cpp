// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/simplify/EdgeCollapse.h"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <utility>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"

namespace palpate
{
namespace
{

namespace sms = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Quadrics = sms::GarlandHeckbert_plane_policies<Mesh, Kernel>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
/// CGAL's optional values are Boost's up to CGAL 5, and the standard library's from 6 on.
template<class Profile>
using MaybePoint = std::invoke_result_t<const sms::Midpoint_placement<Mesh>&, const Profile&>;
template<class Profile>
using MaybeCost = std::invoke_result_t<const Quadrics&, const Profile&, const MaybePoint<Profile>&>;

Vec3 toVec(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}

/// The surface as CGAL's collapse wants surfaces: oriented, two triangles an edge. Where the surface is not like that,
/// it is cut open along edges whose vertices may not go, so that the cuts close again when equal vertices are welded.
struct Workpiece
{
  Mesh mesh;
  Mesh::Property_map<Vertex, bool> fixed;
};

/// Null when CGAL cannot hold the surface.
std::optional<Workpiece> makeWorkpiece(const TriangleMesh& surface, std::vector<bool> fixed)
{
  std::vector<Point> points;
  for (const Vec3& v : surface.vertices_W)
  {
    points.emplace_back(v.x(), v.y(), v.z());
  }
  std::vector<std::array<std::size_t, 3>> faces;
  for (const auto& t : surface.triangles)
  {
    faces.push_back({ t[0], t[1], t[2] });
  }
  const std::vector<std::array<std::size_t, 3>> before = faces;
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces);
  fixed.resize(points.size(), true);
  Workpiece piece;
  for (const Point& p : points)
  {
    piece.mesh.add_vertex(p);
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const auto& [a, b, c] = faces[f];
    if (piece.mesh.add_face(Vertex(a), Vertex(b), Vertex(c)) == Mesh::null_face())
    {
      return std::nullopt;
    }
    for (const std::size_t v : before[f]) // a vertex that was doubled stays for all faces that had it
    {
      fixed[v] = fixed[v] || std::find(faces[f].begin(), faces[f].end(), v) == faces[f].end();
    }
  }
  piece.fixed = piece.mesh.add_property_map<Vertex, bool>("v:fixed", false).first;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    piece.fixed[Vertex(v)] = fixed[v];
  }
  return piece;
}

/// The quadric's cost, and a little of the length so that flat parts lose short edges first.
class Cost
{
public:
  using Update_tag = CGAL::Tag_true;

  explicit Cost(const Quadrics& quadrics) : quadrics_(quadrics) {}
  template<class PointMap>
  void initialize(const Mesh& mesh, const PointMap& points, const Kernel& kernel) const
  {
    this->quadrics_.initialize(mesh, points, kernel);
  }
  template<class Profile>
  void update_after_collapse(const Profile& profile, Vertex kept) const
  {
    this->quadrics_.update_after_collapse(profile, kept);
  }
  template<class Profile>
  MaybeCost<Profile> operator()(const Profile& profile, const MaybePoint<Profile>& placement) const
  {
    constexpr double lengthWeight = 1e-4;
    MaybeCost<Profile> cost = this->quadrics_(profile, placement);
    if (cost)
    {
      *cost += lengthWeight * (toVec(profile.p1()) - toVec(profile.p0())).squaredNorm();
    }
    return cost;
  }

private:
  const Quadrics& quadrics_;
};

/// The better one of an edge's two ends, unless that removes a vertex that stays.
class EndOfEdge
{
public:
  EndOfEdge(const Quadrics& quadrics, const Workpiece& piece) : quadrics_(quadrics), piece_(piece) {}
  template<class Profile>
  MaybePoint<Profile> operator()(const Profile& profile) const
  {
    const bool keep0 = this->piece_.fixed[profile.v0()], keep1 = this->piece_.fixed[profile.v1()];
    if (keep0 || keep1)
    {
      return keep0 && keep1 ? MaybePoint<Profile>() : MaybePoint<Profile>(keep0 ? profile.p0() : profile.p1());
    }
    const MaybePoint<Profile> ends[2] = { profile.p0(), profile.p1() };
    return *this->quadrics_(profile, ends[0]) <= *this->quadrics_(profile, ends[1]) ? ends[0] : ends[1];
  }

private:
  const Quadrics& quadrics_;
  const Workpiece& piece_;
};

/// Which points have gone, and by which face each of them is represented now.
class Ledger
{
public:
  /// Middles of faces are watched too: with vertices alone a surface folds up between them.
  Ledger(Workpiece& piece, double limit_u) : piece_(piece), limit_u_(limit_u), gone_(piece.mesh.number_of_faces())
  {
    for (const Face f : piece.mesh.faces())
    {
      Vec3 sum_W = Vec3::Zero();
      for (const Vertex v : CGAL::vertices_around_face(piece.mesh.halfedge(f), piece.mesh))
      {
        sum_W += toVec(piece.mesh.point(v));
      }
      this->gone_[f].push_back(sum_W / 3);
    }
  }

  /// Whether everything that went near this edge, and the end that goes now, stays within the limit.
  template<class Profile>
  bool allows(const Profile& profile, const Point& placement)
  {
    this->placed_.clear();
    this->changes_.clear();
    const Vec3 target_W = toVec(placement);
    const bool to0 = placement == profile.p0();
    std::vector<Vec3>& moving = this->moving_;
    moving.assign(1, toVec(to0 ? profile.p1() : profile.p0()));
    for (const Vertex v : { profile.v0(), profile.v1() })
    {
      for (const Face f : CGAL::faces_around_target(this->piece_.mesh.halfedge(v), this->piece_.mesh))
      {
        if (f != Mesh::null_face() && !this->enter(profile, f, v, target_W))
        {
          return false;
        }
      }
    }
    return std::all_of(moving.begin(), moving.end(), [this](const Vec3& x_W) { return this->place(x_W); });
  }

  /// The collapse that was allowed last has been made.
  void commit()
  {
    for (const Change& change : this->changes_)
    {
      this->gone_[change.face].clear();
    }
    for (const auto& [face, x_W] : this->placed_)
    {
      this->gone_[face].push_back(x_W);
    }
  }

private:
  struct Change
  {
    Face face;
    bool stays = false; ///< with the corners it will have
    std::array<Vec3, 3> corner_W = {};
  };

  /// Takes note of a face around one end. False if it would turn over or lose its area.
  template<class Profile>
  bool enter(const Profile& profile, Face f, Vertex v, const Vec3& target_W)
  {
    const Mesh& mesh = this->piece_.mesh;
    const bool vanishes = f == mesh.face(profile.v0_v1()) || f == mesh.face(profile.v1_v0());
    if (vanishes && v == profile.v1())
    {
      return true; // it was met around the other end
    }
    this->moving_.insert(this->moving_.end(), this->gone_[f].begin(), this->gone_[f].end());
    Change change{ f, !vanishes };
    std::array<Vec3, 3> before;
    std::size_t k = 0;
    for (const Vertex corner : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      before[k] = toVec(mesh.point(corner));
      change.corner_W[k] = corner == v ? target_W : before[k];
      ++k;
    }
    this->changes_.push_back(change);
    return vanishes || keepsSide(before, change.corner_W);
  }

  static bool keepsSide(const std::array<Vec3, 3>& before, const std::array<Vec3, 3>& after)
  {
    const auto normal = [](const std::array<Vec3, 3>& t) { return (t[1] - t[0]).cross(t[2] - t[0]); };
    return normal(before).dot(normal(after)) > 0.0 && !exactlyCollinear(after[0], after[1], after[2]);
  }

  /// Onto the nearest of the new faces.
  bool place(const Vec3& x_W)
  {
    double nearest = std::numeric_limits<double>::infinity();
    Face at = Mesh::null_face();
    for (const Change& change : this->changes_)
    {
      const double distance =
        change.stays
          ? (nearestOnTriangle(x_W, change.corner_W[0], change.corner_W[1], change.corner_W[2]) - x_W).squaredNorm()
          : nearest;
      if (distance < nearest)
      {
        nearest = distance;
        at = change.face;
      }
    }
    this->placed_.emplace_back(at, x_W);
    return nearest <= this->limit_u_ * this->limit_u_;
  }

  Workpiece& piece_;
  double limit_u_;
  std::vector<std::vector<Vec3>> gone_;
  std::vector<Change> changes_;
  std::vector<std::pair<Face, Vec3>> placed_;
  std::vector<Vec3> moving_;
};

struct Allowed
{
  Ledger* ledger;

  template<class Profile>
  MaybePoint<Profile> operator()(const Profile& profile, const MaybePoint<Profile>& placement) const
  {
    return placement && this->ledger->allows(profile, *placement) ? placement : MaybePoint<Profile>();
  }
};

struct Bookkeeper : sms::internal::Dummy_visitor
{
  Ledger* ledger = nullptr;
  Workpiece* piece = nullptr;

  template<class Profile, class Kept>
  void OnCollapsed(const Profile& profile, Kept kept) const
  {
    this->ledger->commit();
    // which of the two is left is CGAL's choice; where it stands now is where the one stood that may not go
    this->piece->fixed[kept] = this->piece->fixed[profile.v0()] || this->piece->fixed[profile.v1()];
  }
};

struct StopWhenAsked
{
  const SimplifyLimits& limits;

  template<class Profile>
  bool operator()(double, const Profile&, std::size_t first, std::size_t now) const
  {
    constexpr std::size_t every = 4096;
    if (this->limits.progress && now % every == 0)
    {
      this->limits.progress(1.0 - static_cast<double>(now) / static_cast<double>(first));
    }
    return this->limits.stop.stop_requested();
  }
};

/// Collapses all edges that may go.
void collapse(Workpiece& piece, const SimplifyLimits& limits)
{
  const Quadrics quadrics(piece.mesh);
  Ledger ledger(piece, limits.limit_u);
  Bookkeeper bookkeeper;
  bookkeeper.ledger = &ledger;
  bookkeeper.piece = &piece;
  sms::edge_collapse(piece.mesh, StopWhenAsked{ limits },
    CGAL::parameters::get_cost(Cost(quadrics))
      .get_placement(EndOfEdge(quadrics, piece))
      .filter(Allowed{ &ledger })
      .visitor(bookkeeper));
}

TriangleMesh meshOf(const Mesh& mesh)
{
  TriangleMesh result;
  for (std::size_t v = 0; v < mesh.num_vertices(); ++v) // those that went are of no triangle
  {
    result.vertices_W.push_back(toVec(mesh.point(Vertex(v))));
  }
  for (const Face f : mesh.faces())
  {
    std::array<std::uint32_t, 3> triangle;
    std::size_t k = 0;
    for (const Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      triangle[k++] = v;
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

} // namespace

std::optional<CollapsedMesh> collapseEdges(
  const TriangleMesh& surface, std::vector<bool> fixed, const SimplifyLimits& limits)
{
  std::optional<Workpiece> piece = makeWorkpiece(surface, std::move(fixed));
  if (!piece)
  {
    return std::nullopt;
  }
  const std::size_t before = piece->mesh.number_of_vertices();
  collapse(*piece, limits);
  return CollapsedMesh{ meshOf(piece->mesh), before - piece->mesh.number_of_vertices() };
}

} // namespace palpate
