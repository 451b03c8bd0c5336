// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/simplify/SheetClearance.h"

#include <algorithm>
#include <numeric>

#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/tree/SegmentTriangle.h"
#include "haptics/geometry/tree/TreeWalk.h"

namespace palpate
{
namespace
{

using Corners = std::array<std::uint32_t, 3>;

Box grownBox(const std::array<Vec3, 3>& corners_W, double grown_u)
{
  const Box box = boxOf(corners_W);
  const Vec3 grown = Vec3::Constant(grown_u);
  return { box.low_W - grown, box.high_W + grown };
}

/// Calls visit(triangle) for each triangle whose box meets `box`.
template<class Visit>
void forEachInBox(const SurfaceData& data, const Box& box, Visit visit)
{
  const auto visitIfNear = [&](std::uint32_t t)
  {
    if (overlap(box, boxOf(data.cornersOf(t))))
    {
      visit(t);
    }
  };
  forEachMeeting(
    data, [&box](const Box& other) { return overlap(box, other); }, visitIfNear);
}

/// A closed segment and a closed triangle.
bool meets(const Vec3& p, const Vec3& q, const FaceRecord& face)
{
  const auto& [a, b, c] = face.corner_W;
  const int above = orientation(a, b, c, p), below = orientation(a, b, c, q);
  if (above == 0 && below == 0)
  {
    return meetsInPlane(p, q, face);
  }
  return above != below && linePassesThrough(p, q, face);
}

/// Whether an edge of triangle s that shares no vertex with triangle t meets it, or a corner next to an edge they share
/// lies folded upon it.
bool edgesMeet(const SurfaceData& data, std::uint32_t s, std::uint32_t t)
{
  const Corners& corners = data.corners(s);
  int shared = 0;
  for (const std::uint32_t v : corners)
  {
    shared += data.hasCorner(t, v);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::uint32_t i = corners[k], j = corners[(k + 1) % 3];
    const bool apart = !data.hasCorner(t, i) && !data.hasCorner(t, j);
    if (apart && meets(data.vertex(i), data.vertex(j), data.face(t)))
    {
      return true;
    }
    if (shared == 2 && data.hasCorner(t, i) && data.hasCorner(t, j))
    {
      const Vec3& tip = data.vertex(data.opposite(s, i, j));
      const Vec3& other = data.vertex(data.opposite(t, i, j));
      const Vec3 edge = data.vertex(j) - data.vertex(i);
      const auto& [a, b, c] = data.face(t).corner_W;
      const bool flat = orientation(a, b, c, tip) == 0;
      return flat && edge.cross(tip - data.vertex(i)).dot(edge.cross(other - data.vertex(i))) > 0.0;
    }
  }
  return false;
}

/// The connected part of a triangle's surroundings.
class Surroundings
{
public:
  explicit Surroundings(const SurfaceData& data) : data_(data), seen_(data.faces.size(), 0) {}

  /// True if a triangle within the distance of this one cannot be reached over others that are.
  bool holdOtherSheet(std::uint32_t triangle, double distance_u)
  {
    this->gather(grownBox(this->data_.cornersOf(triangle), distance_u));
    std::size_t reached = 1;
    this->seen_[triangle] = this->round_ + 1;
    this->front_.assign(1, triangle);
    while (!this->front_.empty())
    {
      const std::uint32_t at = this->front_.back();
      this->front_.pop_back();
      for (const std::uint32_t v : this->data_.corners(at))
      {
        this->data_.forEachAround(v, [&](std::uint32_t t) { reached += this->reach(t); });
      }
    }
    return reached < this->near_;
  }

private:
  bool reach(std::uint32_t triangle)
  {
    const bool fresh = this->seen_[triangle] == this->round_;
    if (fresh)
    {
      this->seen_[triangle] = this->round_ + 1;
      this->front_.push_back(triangle);
    }
    return fresh;
  }

  void gather(const Box& box)
  {
    this->round_ += 2;
    this->near_ = 0;
    forEachInBox(this->data_, box,
      [this](std::uint32_t t)
      {
        this->seen_[t] = this->round_;
        ++this->near_;
      });
  }

  const SurfaceData& data_;
  std::vector<std::uint32_t> seen_; ///< the round in which a triangle was near, and one more if it was reached
  std::uint32_t round_ = 0;
  std::size_t near_ = 0;
  std::vector<std::uint32_t> front_;
};

} // namespace

std::vector<bool> verticesNearOtherSheets(const SurfaceTree& surface, double distance_u, const std::stop_token& stop)
{
  std::vector<std::uint32_t> all(surface.data().faces.size());
  std::iota(all.begin(), all.end(), 0u);
  return verticesNearOtherSheets(surface, distance_u, all, stop);
}

std::vector<bool> verticesNearOtherSheets(const SurfaceTree& surface, double distance_u,
  const std::vector<std::uint32_t>& triangles, const std::stop_token& stop)
{
  const SurfaceData& data = surface.data();
  std::vector<bool> near(data.mesh.vertices_W.size(), false);
  Surroundings surroundings(data);
  for (std::size_t i = 0; i < triangles.size() && !stop.stop_requested(); ++i)
  {
    if (surroundings.holdOtherSheet(triangles[i], distance_u))
    {
      for (const std::uint32_t v : data.corners(triangles[i]))
      {
        near[v] = true;
      }
    }
  }
  return near;
}

double trianglesWithin(const SurfaceTree& surface, double distance_u, std::size_t samples)
{
  const SurfaceData& data = surface.data();
  const std::size_t count = std::min(samples, data.faces.size());
  std::size_t within = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto triangle = static_cast<std::uint32_t>(i * data.faces.size() / count);
    forEachInBox(data, grownBox(data.cornersOf(triangle), distance_u), [&within](std::uint32_t) { ++within; });
  }
  return static_cast<double>(within) / static_cast<double>(std::max<std::size_t>(1, count));
}

std::optional<std::array<std::uint32_t, 2>> crossingTriangles(const SurfaceTree& surface, const std::stop_token& stop)
{
  return crossingTriangles(surface, std::vector<bool>(surface.data().faces.size(), false), stop);
}

std::optional<std::array<std::uint32_t, 2>> crossingTriangles(
  const SurfaceTree& surface, const std::vector<bool>& ignored, const std::stop_token& stop)
{
  const SurfaceData& data = surface.data();
  std::optional<std::array<std::uint32_t, 2>> found;
  for (std::uint32_t s = 0; s < data.faces.size() && !found && !stop.stop_requested(); ++s)
  {
    forEachInBox(data, boxOf(data.cornersOf(s)),
      [&](std::uint32_t t)
      {
        if (t > s && !(ignored[s] && ignored[t]) && (edgesMeet(data, s, t) || edgesMeet(data, t, s)))
        {
          found = { s, t };
        }
      });
  }
  return found;
}

} // namespace palpate
