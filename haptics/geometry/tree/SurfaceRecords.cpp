// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/tree/SurfaceRecords.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "haptics/core/WordHash.h"
#include "haptics/geometry/mesh/ExactPredicates.h"

namespace palpate
{
namespace
{

/// The next larger float of one that is not negative: std::nextafter is a call and tests the sign.
float nextAbove(float number)
{
  return number < std::numeric_limits<float>::infinity()
           ? std::bit_cast<float>(std::bit_cast<std::uint32_t>(number) + 1)
           : number;
}

/// Centre and radius of a disc or a ball. `local`: its centre from the leaf's origin, in the leaf's unit, as is its
/// radius.
template<class Quad>
void writeBall(Quad& quad, int lane, const Vec3& local, double radius)
{
  quad.cx[lane] = static_cast<float>(local.x());
  quad.cy[lane] = static_cast<float>(local.y());
  quad.cz[lane] = static_cast<float>(local.z());
  const double roundOff = 4e-7 * (local.cwiseAbs().sum() + radius);
  quad.radius[lane] = nextAbove(static_cast<float>(radius + roundOff));
}

void setDisc(DiscQuad& quad, int lane, const FaceRecord& face, const Leaf& leaf)
{
  const Disc disc = discOf(face.corner_W);
  writeBall(quad, lane, leaf.perUnit * (disc.centre_W - leaf.origin_W), leaf.perUnit * disc.radius_u);
  quad.nx[lane] = static_cast<float>(face.normal_W.x());
  quad.ny[lane] = static_cast<float>(face.normal_W.y());
  quad.nz[lane] = static_cast<float>(face.normal_W.z());
}

/// The exact normal of a sliver so thin that rounding of its sides decides its normal.
void setNeedleNormal(FaceRecord& face) noexcept
{
  const auto& [a, b, c] = face.corner_W;
  const Vec3 cross = exactCross(a, b, c);
  const double most = cross.cwiseAbs().maxCoeff();
  if (most > 0.0)
  {
    face.normal_W = (cross / most).normalized();
    face.sliver = 1.0F;
  }
}

/// The box around both children of a node.
Box around(const NodeBoxes& node) noexcept
{
  Box box = boxOf(node, 0);
  box.include(boxOf(node, 1));
  return box;
}

/// A parent stands before its children: from the last node to the first, every child's box is made before it is read.
template<class Boxes>
Box layUpwards(const std::vector<TreeNode>& nodes, const std::vector<Box>& leafBoxes, std::vector<Boxes>& to) noexcept
{
  for (std::size_t i = nodes.size(); i-- > 0;)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      const std::uint32_t child = nodes[i].child[k];
      const bool leaf = (child & TreeNode::leafBit) != 0;
      setBox(to[i], k, leaf ? leafBoxes[child & ~TreeNode::leafBit] : around(to[child]));
    }
  }
  return nodes.empty() ? leafBoxes[0] : around(to[0]);
}

} // namespace

Disc discOf(const std::array<Vec3, 3>& corners_W) noexcept
{
  const auto& [a, b, c] = corners_W;
  const auto reach2 = [&](const Vec3& from) __attribute__((always_inline))
  {
    return std::max({ (a - from).squaredNorm(), (b - from).squaredNorm(), (c - from).squaredNorm() });
  };
  Vec3 centre = (a + b + c) / 3.0;
  double radius2 = reach2(centre);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 middle = 0.5 * (corners_W[k] + corners_W[(k + 1) % 3]);
    const double fromMiddle2 = reach2(middle);
    if (fromMiddle2 < radius2)
    {
      radius2 = fromMiddle2;
      centre = middle;
    }
  }
  return { centre, std::sqrt(radius2) };
}

FaceRecord makeFace(const SurfaceData& data, std::uint32_t triangle, std::uint32_t owned) noexcept
{
  const auto& t = data.mesh.triangles[triangle];
  return makeFace(data.cornersOf(triangle), isSegment(t), owned);
}

FaceRecord makeFace(const std::array<Vec3, 3>& corners_W, bool segment, std::uint32_t owned) noexcept
{
  FaceRecord face;
  face.corner_W = corners_W;
  face.owned = owned;
  if (segment)
  {
    face.normal_W = Vec3::Zero();
    face.sliver = 1.0F;
    return face;
  }
  const Vec3 e = face.corner_W[1] - face.corner_W[0];
  const Vec3 f = face.corner_W[2] - face.corner_W[0];
  const double scaleE = e.cwiseAbs().maxCoeff(), scaleF = f.cwiseAbs().maxCoeff(); // no under- or overflow
  const Vec3 eScaled = e / scaleE, fScaled = f / scaleF;
  const Vec3 cross = eScaled.cross(fScaled);
  const double area = cross.norm();
  face.normal_W = cross * (1.0 / area);
  const double sine = area / std::sqrt(eScaled.squaredNorm() * fScaled.squaredNorm());
  face.sliver = static_cast<float>(1.0 / std::max(sine, 1e-30));
  if (face.sliver > needleSliver)
  {
    setNeedleNormal(face);
  }
  return face;
}

Leaf makeLeaf(const Box& box, std::uint32_t first, std::uint32_t count) noexcept
{
  const Vec3 sides = box.high_W - box.low_W;
  return { box.low_W + 0.5 * sides, 1.0 / sides.maxCoeff(), first, count };
}

void layDiscs(SurfaceData& data, std::size_t leafIndex) noexcept
{
  const Leaf& leaf = data.leaves[leafIndex];
  for (std::uint32_t k = 0; k < leaf.count; ++k)
  {
    DiscQuad& quad = data.discs[2 * leafIndex + k / 4];
    setDisc(quad, static_cast<int>(k % 4), data.face(leaf.first + k), leaf);
  }
}

void layBall(BallQuad& quad, int lane, const Leaf& leaf, const std::array<Vec3, 3>& corners_W) noexcept
{
  const auto& [a, b, c] = corners_W;
  const Vec3 centre_W = (a + b + c) / 3.0;
  const double radius2 =
    std::max({ (a - centre_W).squaredNorm(), (b - centre_W).squaredNorm(), (c - centre_W).squaredNorm() });
  writeBall(quad, lane, leaf.perUnit * (centre_W - leaf.origin_W), leaf.perUnit * std::sqrt(radius2));
}

Box layBoxes(const std::vector<TreeNode>& nodes, const std::vector<Box>& leafBoxes, std::vector<TreeNode>& to) noexcept
{
  return layUpwards(nodes, leafBoxes, to);
}

Box layBoxes(const std::vector<TreeNode>& nodes, const std::vector<Box>& leafBoxes, std::vector<NodeBoxes>& to) noexcept
{
  return layUpwards(nodes, leafBoxes, to);
}

std::uint64_t hashTopology(const TriangleMesh& mesh) noexcept
{
  WordHash hash;
  for (const auto& t : mesh.triangles)
  {
    hash.add(std::uint64_t{ t[0] } << 32 | t[1]);
    hash.add(std::uint64_t{ t[2] });
  }
  return hash.value();
}

std::uint64_t hashContent(const SurfaceData& data) noexcept
{
  WordHash hash;
  hash.add(data.topologyHash);
  if (data.coat_u > 0.0)
  {
    hash.add(data.coat_u);
  }
  for (const Vec3& v : data.mesh.vertices_W)
  {
    hash.add(v.x());
    hash.add(v.y());
    hash.add(v.z());
  }
  return hash.value();
}

} // namespace palpate
