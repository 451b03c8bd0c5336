// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/Simplification.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "haptics/geometry/ExactPredicates.h"
#include "haptics/geometry/NearestOnTriangle.h"
#include "haptics/geometry/SheetClearance.h"
#include "haptics/geometry/SurfaceDistance.h"
#include "haptics/geometry/SurfacePatches.h"

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

Vec3 toVec(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}

/// The surface as CGAL's collapse wants it: oriented, two triangles an edge. Where it is not like that it is cut open
/// along edges whose vertices may not go, so that the cuts close again when equal vertices are welded.
struct Workpiece
{
  Mesh mesh;
  Mesh::Property_map<Vertex, bool> fixed;
};

/// All corners of triangles at edges of three or more: nothing there changes.
void fixCrowded(const SurfaceData& data, std::vector<bool>& fixed)
{
  for (const auto& corners : data.mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t i = corners[k], j = corners[(k + 1) % 3];
      int around = 0;
      data.forEachAtEdge(i, j, [&around](std::uint32_t) { ++around; });
      if (around > 2)
      {
        data.forEachAtEdge(i, j,
          [&](std::uint32_t t)
          {
            for (const std::uint32_t v : data.corners(t))
            {
              fixed[v] = true;
            }
          });
      }
    }
  }
}

/// Null when CGAL cannot hold it.
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
    for (const std::size_t v : before[f]) // one that was doubled stays for all who had it
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
  boost::optional<double> operator()(const Profile& profile, const boost::optional<Point>& placement) const
  {
    constexpr double lengthWeight = 1e-4;
    const boost::optional<double> cost = this->quadrics_(profile, placement);
    return cost
             ? boost::optional<double>(*cost + lengthWeight * (toVec(profile.p1()) - toVec(profile.p0())).squaredNorm())
             : cost;
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
  boost::optional<Point> operator()(const Profile& profile) const
  {
    const bool keep0 = this->piece_.fixed[profile.v0()], keep1 = this->piece_.fixed[profile.v1()];
    if (keep0 || keep1)
    {
      return keep0 && keep1 ? boost::optional<Point>() : boost::optional<Point>(keep0 ? profile.p0() : profile.p1());
    }
    const boost::optional<Point> ends[2] = { profile.p0(), profile.p1() };
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
  boost::optional<Point> operator()(const Profile& profile, const boost::optional<Point>& placement) const
  {
    return placement && this->ledger->allows(profile, *placement) ? placement : boost::optional<Point>();
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
void collapse(Workpiece& piece, double limit_u, const SimplifyLimits& limits)
{
  const Quadrics quadrics(piece.mesh);
  Ledger ledger(piece, limit_u);
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

Simplification refuse(std::string reason)
{
  return { nullptr, 0.0, std::move(reason) };
}

/// Which triangles of the simpler surface are the first one's as they were.
std::vector<bool> unchangedTriangles(const SurfaceTree& surface, const SurfaceTree& fewer)
{
  using Key = std::array<std::array<double, 3>, 3>;
  const auto keyOf = [](const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& corners)
  {
    Key key;
    std::transform(corners.begin(), corners.end(), key.begin(),
      [&mesh](std::uint32_t v)
      {
        const Vec3& p_W = mesh.vertices_W[v];
        return std::array{ p_W.x(), p_W.y(), p_W.z() };
      });
    std::sort(key.begin(), key.end());
    return key;
  };
  std::vector<Key> before;
  for (const auto& corners : surface.mesh().triangles)
  {
    before.push_back(keyOf(surface.mesh(), corners));
  }
  std::sort(before.begin(), before.end());
  std::vector<bool> unchanged;
  for (const auto& corners : fewer.mesh().triangles)
  {
    unchanged.push_back(std::binary_search(before.begin(), before.end(), keyOf(fewer.mesh(), corners)));
  }
  return unchanged;
}

/// Both ways within the limit, and nothing crosses that did not before.
Simplification prove(const SurfaceTree& surface, std::shared_ptr<const SurfaceTree> fewer, const SimplifyLimits& limits)
{
  const DistanceProof there = proveWithin(surface, *fewer, limits.limit_u, limits.stop);
  const DistanceProof back = there.verdict == DistanceProof::Verdict::Within
                               ? proveWithin(*fewer, surface, limits.limit_u, limits.stop)
                               : DistanceProof{};
  if (back.verdict != DistanceProof::Verdict::Within)
  {
    return refuse("it could not be proven that the simplified surface stays near enough");
  }
  if (crossingTriangles(*fewer, limits.stop) &&
      crossingTriangles(*fewer, unchangedTriangles(surface, *fewer), limits.stop))
  {
    return refuse("the simplified surface would cross itself");
  }
  return { std::move(fewer), std::max(there.bound_u, back.bound_u), {} };
}

/// What came of one try.
struct Attempt
{
  Simplification result;
  bool lessMayDo = false; ///< refused for what it changed, not for what it kept
};

/// So much of what a limit allows is used while edges collapse. What lies between the points that are watched may get
/// further; if it gets too far, less is allowed.
constexpr std::array<double, 3> shares = { 0.75, 0.4, 0.25 };

Attempt attempt(const SurfaceTree& surface, const std::vector<bool>& fixed, double share, const SimplifyLimits& limits)
{
  std::optional<Workpiece> piece = makeWorkpiece(surface.mesh(), fixed);
  if (!piece)
  {
    return { refuse("its triangles do not make a surface that edges can be collapsed on") };
  }
  collapse(*piece, share * limits.limit_u, limits);
  CleanResult clean = cleanMesh(meshOf(piece->mesh));
  if (!clean.ok() || clean.report.collinear > 0)
  {
    return { refuse("nothing would be left of it"), true };
  }
  if (2 * clean.mesh.triangles.size() > surface.mesh().triangles.size())
  {
    return { refuse("fewer than half of its triangles could go without being missed") };
  }
  return { prove(surface, std::make_shared<const SurfaceTree>(std::move(clean.mesh)), limits), true };
}

/// Parts of a surface, on which a share of the limit is tried before it is tried on all.
class Sample
{
public:
  enum class Verdict
  {
    Promising,
    KeepsTooMuch, ///< far more than half; a smaller share keeps more
    Unproven,     ///< and so will be the whole surface
  };

  Sample(const SurfaceTree& surface, const SimplifyLimits& limits)
    : limits_{ limits.limit_u, limits.stop, {} }, patches_(patchesOf(surface, count, size))
  {
    const std::vector<bool> near =
      verticesNearOtherSheets(surface, 2 * limits.limit_u, this->patches_.triangles, limits.stop);
    this->fixed_ = this->patches_.rim;
    for (std::size_t v = 0; v < this->fixed_.size(); ++v)
    {
      this->fixed_[v] = this->fixed_[v] || near[this->patches_.vertices[v]];
    }
  }

  [[nodiscard]] static bool pays(const SurfaceTree& surface)
  {
    return surface.mesh().triangles.size() >= 4 * count * size;
  }

  [[nodiscard]] Verdict judge(double share) const
  {
    std::optional<Workpiece> piece = makeWorkpiece(this->patches_.mesh, this->fixed_);
    if (!piece)
    {
      return Verdict::Promising; // the whole surface says why not
    }
    const auto before = static_cast<double>(piece->mesh.number_of_vertices());
    collapse(*piece, share * this->limits_.limit_u, this->limits_);
    const double gone = before - static_cast<double>(piece->mesh.number_of_vertices());
    // Those that have all of their triangles in a part stand for the surface.
    const auto inner = static_cast<double>(std::count(this->patches_.rim.begin(), this->patches_.rim.end(), false));
    if (gone < (1.0 - mostThatStays) * inner)
    {
      return Verdict::KeepsTooMuch;
    }
    return this->proven(meshOf(piece->mesh)) ? Verdict::Promising : Verdict::Unproven;
  }

private:
  static constexpr std::size_t count = 16, size = 512;
  static constexpr double mostThatStays = 0.6; // half, and what a sample may be wrong by
  static constexpr double ofLimit = 0.8;       // the worst place of all is worse than that of a sample

  [[nodiscard]] bool proven(const TriangleMesh& simpler) const
  {
    CleanResult full = cleanMesh(this->patches_.mesh), fewer = cleanMesh(simpler);
    if (!full.ok() || !fewer.ok())
    {
      return false;
    }
    const SurfaceTree from(std::move(full.mesh)), to(std::move(fewer.mesh));
    const auto within = [this](const SurfaceTree& a, const SurfaceTree& b)
    {
      return proveWithin(a, b, ofLimit * this->limits_.limit_u, this->limits_.stop).verdict ==
             DistanceProof::Verdict::Within;
    };
    return within(from, to) && within(to, from);
  }

  SimplifyLimits limits_;
  SurfacePatches patches_;
  std::vector<bool> fixed_;
};

/// No further than what looking for other sheets can afford: its work grows with the square of the distance.
double affordable_u(const SurfaceTree& surface, double limit_u)
{
  constexpr std::size_t samples = 64;
  constexpr double mostLookedAt = 256.0;
  const double lookedAt = trianglesWithin(surface, 2 * limit_u, samples);
  return limit_u * std::sqrt(std::min(1.0, mostLookedAt / lookedAt));
}

std::vector<bool> whatStays(const SurfaceTree& surface, const SimplifyLimits& limits)
{
  std::vector<bool> fixed = verticesNearOtherSheets(surface, 2 * limits.limit_u, limits.stop);
  fixCrowded(surface.data(), fixed);
  return fixed;
}

/// Where a sample can be tried first, all of it is tried once: the sample has chosen the share.
Simplification search(const SurfaceTree& surface, const SimplifyLimits& limits)
{
  const std::optional<Sample> sample =
    Sample::pays(surface) ? std::optional<Sample>(std::in_place, surface, limits) : std::nullopt;
  const std::size_t mostAttempts = sample ? 1 : shares.size();
  std::vector<bool> fixed;
  std::size_t attempts = 0;
  Simplification last = refuse("in a sample of it no simpler surface could be proven to stay near enough");
  for (const double share : shares)
  {
    const Sample::Verdict verdict = sample ? sample->judge(share) : Sample::Verdict::Promising;
    if (verdict == Sample::Verdict::KeepsTooMuch)
    {
      return refuse("in a sample of it fewer than half of the triangles could go without being missed");
    }
    if (verdict == Sample::Verdict::Unproven)
    {
      continue;
    }
    fixed = fixed.empty() ? whatStays(surface, limits) : std::move(fixed);
    Attempt tried = attempt(surface, fixed, share, limits);
    last = std::move(tried.result);
    if (last.tree || !tried.lessMayDo || ++attempts == mostAttempts || limits.stop.stop_requested())
    {
      break;
    }
  }
  return last;
}

} // namespace

Simplification simplifyWithin(const SurfaceTree& surface, const SimplifyLimits& limits)
{
  if (!(limits.limit_u > 0.0) || !std::isfinite(limits.limit_u))
  {
    return refuse("a surface is simplified within a distance above zero");
  }
  if (surface.coat_u() > 0.0)
  {
    return refuse("curves are touched as they are");
  }
  SimplifyLimits afforded = limits;
  afforded.limit_u = affordable_u(surface, limits.limit_u);
  const Simplification result = search(surface, afforded);
  return limits.stop.stop_requested() ? refuse("it was stopped") : result;
}

} // namespace palpate
