// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/pairs/NearPairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{

constexpr std::size_t mostKnown = 1u << 14;      // four times the leaves that a list usually has
constexpr std::uint32_t spreading = 2654435761u; // multiplicative hashing (Knuth 1973)

constexpr std::size_t mostTriangles = 1u << 16;

std::size_t slotOf(std::uint32_t tool, std::uint32_t scene, std::size_t slots) noexcept
{
  const std::uint32_t hash = (tool * spreading ^ scene) * spreading;
  return (hash >> 16) % slots;
}

} // namespace

NearPairs::NearPairs(const BoxedMesh& tool_B, const BoxedMesh& scene_W)
  : tool_B_(tool_B), scene_W_(scene_W), leafRange_(tool_B.nodes().size()), local_(tool_B.mesh().vertices_W.size()),
    localStamp_(tool_B.mesh().vertices_W.size()), knownLeaves_(mostKnown), knownTriangles_(mostTriangles)
{
}

void NearPairs::rebuild(const std::vector<BoxPair>& near, double way_u, double margin_u)
{
  ++this->stamp_;
  this->way_u_ = way_u;
  this->listed_u_ = way_u + margin_u;
  this->remember();
  this->leaves_.clear();
  this->triangles_.clear();
  this->leafVertices_.clear();
  this->corners_.clear();
  for (const BoxPair& pair : near)
  {
    const LeafRange range = this->verticesOf(pair.tool);
    LeafPair leaf;
    leaf.toolNode = pair.tool;
    leaf.sceneNode = pair.scene;
    leaf.firstVertex = range.first;
    leaf.vertexCount = range.count;
    leaf.key_u = pair.key_u;
    leaf.featureless = this->isFeatureless(leaf);
    this->recall(leaf);
    this->leaves_.push_back(leaf);
  }
}

void NearPairs::forget()
{
  this->leaves_.clear();
  this->triangles_.clear();
  if (!this->knows_) // called in each update while the hand has no pose
  {
    return;
  }
  this->knows_ = false;
  std::fill(this->knownLeaves_.begin(), this->knownLeaves_.end(), KnownLeaf());
  std::fill(this->knownTriangles_.begin(), this->knownTriangles_.end(), KnownTriangles());
}

NearPairs::KnownLeaf& NearPairs::known(const LeafPair& pair) noexcept
{
  return this->knownLeaves_[slotOf(pair.toolNode, pair.sceneNode, mostKnown)];
}

NearPairs::KnownTriangles& NearPairs::known(const NearTriangles& pair) noexcept
{
  return this->knownTriangles_[slotOf(pair.toolTriangle, pair.sceneTriangle, mostTriangles)];
}

void NearPairs::remember()
{
  this->knows_ = this->knows_ || !this->leaves_.empty();
  for (const LeafPair& pair : this->leaves_)
  {
    this->known(pair) = { pair.toolNode, pair.sceneNode, pair.n_W, pair.below_u, pair.key_u };
  }
  for (const NearTriangles& pair : this->triangles_)
  {
    this->known(pair) = { pair.toolTriangle, pair.sceneTriangle, pair.plane, pair.key_u };
  }
}

void NearPairs::recall(LeafPair& pair) noexcept
{
  const KnownLeaf& known = this->known(pair);
  if (known.toolNode == pair.toolNode && known.sceneNode == pair.sceneNode)
  {
    pair.n_W = known.n_W;
    pair.below_u = known.below_u;
    pair.key_u = std::max(pair.key_u, known.key_u);
  }
}

void NearPairs::recall(NearTriangles& pair) noexcept
{
  const KnownTriangles& known = this->known(pair);
  if (known.toolTriangle == pair.toolTriangle && known.sceneTriangle == pair.sceneTriangle)
  {
    pair.plane = known.plane;
    pair.key_u = std::max(pair.key_u, known.key_u);
  }
}

bool NearPairs::isFeatureless(const LeafPair& pair) const noexcept
{
  const auto flat = [](const BoxedMesh& mesh, std::uint32_t node)
  {
    const std::uint32_t first = mesh.nodes()[node].second, last = first + mesh.nodes()[node].count;
    bool all = true;
    for (std::uint32_t t = first; t < last; ++t)
    {
      all = all && mesh.flat(t).all();
    }
    return all;
  };
  return flat(this->tool_B_, pair.toolNode) && flat(this->scene_W_, pair.sceneNode);
}

NearPairs::LeafRange NearPairs::verticesOf(std::uint32_t toolNode)
{
  LeafRange& range = this->leafRange_[toolNode];
  if (range.stamp == this->stamp_)
  {
    return range;
  }
  range = { this->stamp_, static_cast<std::uint32_t>(this->leafVertices_.size()), 0 };
  const BoxedMesh::Node& node = this->tool_B_.nodes()[toolNode];
  for (std::uint32_t t = node.second; t < node.second + node.count; ++t)
  {
    for (const std::uint32_t v : this->tool_B_.mesh().triangles[t])
    {
      if (this->localStamp_[v] != this->stamp_)
      {
        this->localStamp_[v] = this->stamp_;
        this->local_[v] = static_cast<std::uint32_t>(this->corners_.size());
        this->corners_.emplace_back().body_B = this->tool_B_.mesh().vertices_W[v];
      }
      const auto first = this->leafVertices_.begin() + range.first;
      if (std::find(first, this->leafVertices_.end(), this->local_[v]) == this->leafVertices_.end())
      {
        this->leafVertices_.push_back(this->local_[v]);
      }
    }
  }
  range.count = static_cast<std::uint32_t>(this->leafVertices_.size()) - range.first;
  return range;
}

/// Several steps are tried from one pose, for which the corners are rotated once.
void NearPairs::setStep(const ScrewStep& step, double way_u)
{
  if (this->step_.from_W.q.coeffs() != step.from_W.q.coeffs())
  {
    ++this->poses_;
    this->start_ = step.from_W.q.toRotationMatrix();
  }
  ++this->steps_;
  this->step_ = step;
  this->end_ = step.turn(1.0);
  this->way_u_ = way_u;
}

void NearPairs::made(double share, double way_u) noexcept
{
  this->way_u_ = way_u;
  const auto keep = [&](auto& pair)
  {
    if (pair.stepped.step == this->steps_)
    {
      this->learn(pair, pair.stepped.gap.at(share));
    }
  };
  std::for_each(this->leaves_.begin(), this->leaves_.end(), keep);
  std::for_each(this->triangles_.begin(), this->triangles_.end(), keep);
}

const NearPairs::UsedCorner& NearPairs::at(std::uint32_t corner) noexcept
{
  UsedCorner& used = this->corners_[corner];
  if (used.step != this->steps_)
  {
    if (used.pose != this->poses_)
    {
      used.pose = this->poses_;
      used.arm_W = this->start_ * used.body_B;
    }
    used.step = this->steps_;
    used.end_W = this->end_ * used.arm_W;
    used.along = this->step_.w_W.dot(used.arm_W);
  }
  return used;
}

SpanGap NearPairs::gapOver(std::span<const std::uint32_t> vertices, const Vec3& n_W, double below_u) noexcept
{
  const Vec3& w = this->step_.w_W;
  const double nw = n_W.dot(w), w2 = w.squaredNorm();
  double from = std::numeric_limits<double>::infinity(), to = from, bend = 0.0, reach2 = 0.0;
  for (const std::uint32_t v : vertices)
  {
    const UsedCorner& corner = this->at(v);
    const double height = n_W.dot(corner.arm_W);
    from = std::min(from, height);
    to = std::min(to, n_W.dot(corner.end_W));
    bend = std::max(bend, nw * corner.along - w2 * height); // n . (w x (w x arm))
    reach2 = std::max(reach2, corner.arm_W.squaredNorm());
  }
  bend += w2 * std::sqrt(w2 * reach2);
  const double centre = n_W.dot(this->step_.from_W.p) - below_u;
  return { from + centre, to + centre + n_W.dot(this->step_.v_W), 0.125 * bend };
}

SpanGap NearPairs::gapOf(const NearTriangles& pair, const Vec3& n_W) noexcept
{
  const Corners scene_W = this->scene_W_.corners(pair.sceneTriangle);
  const double below_u = std::max({ n_W.dot(scene_W[0]), n_W.dot(scene_W[1]), n_W.dot(scene_W[2]) });
  return this->gapOver(pair.vertices, n_W, below_u);
}

NearPairs::Extent NearPairs::extentOf(const LeafPair& pair, const Vec3& axis) const noexcept
{
  const BoxedMesh::Node& node = this->scene_W_.nodes()[pair.sceneNode];
  Extent extent;
  for (std::uint32_t t = node.second; t < node.second + node.count; ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double height = axis.dot(this->scene_W_.corner(t, k));
      extent.low = std::min(extent.low, height);
      extent.high = std::max(extent.high, height);
    }
  }
  return extent;
}

std::array<Vec3, 3> NearPairs::candidates(const LeafPair& pair) const noexcept
{
  const BoxedMesh::Node &a = this->tool_B_.nodes()[pair.toolNode], &b = this->scene_W_.nodes()[pair.sceneNode];
  const Vec3 between = this->step_.from_W.p + this->start_ * a.box.centre() - b.box.centre();
  const double distance = between.norm();
  return { unitNormal(this->scene_W_.corners(b.second)), this->start_ * unitNormal(this->tool_B_.corners(a.second)),
    distance > 0.0 ? Vec3(between / distance) : Vec3(Vec3::UnitZ()) };
}

bool NearPairs::findPlane(LeafPair& pair, double share, double gap_u) noexcept
{
  double best = -std::numeric_limits<double>::infinity();
  for (const Vec3& axis : this->candidates(pair))
  {
    const Extent extent = this->extentOf(pair, axis);
    for (const double sign : { 1.0, -1.0 })
    {
      const Vec3 n = sign * axis;
      const double below = sign > 0.0 ? extent.high : -extent.low;
      const double least = this->gapOver(this->verticesOf(pair), n, below).leastUntil(share);
      if (least > best)
      {
        best = least;
        pair.n_W = n;
        pair.below_u = below;
      }
    }
  }
  return best >= gap_u;
}

void NearPairs::split(LeafPair& pair)
{
  pair.split = true;
  const BoxedMesh::Node &a = this->tool_B_.nodes()[pair.toolNode], &b = this->scene_W_.nodes()[pair.sceneNode];
  for (std::uint32_t i = a.second; i < a.second + a.count; ++i)
  {
    NearTriangles triangles;
    triangles.toolTriangle = i;
    Corners tool_W;
    for (int k = 0; k < 3; ++k)
    {
      triangles.vertices[k] = this->local_[this->tool_B_.mesh().triangles[i][k]];
      tool_W[k] = this->step_.from_W.p + this->at(triangles.vertices[k]).arm_W;
    }
    for (std::uint32_t j = b.second; j < b.second + b.count; ++j)
    {
      triangles.sceneTriangle = j;
      triangles.key_u = std::max(pair.key_u, this->way_u_ + boxesApart_u(tool_W, this->scene_W_.corners(j)));
      triangles.plane = {};
      this->recall(triangles);
      if (triangles.key_u <= this->listed_u_) // else it is as far away as pairs outside of the list
      {
        this->triangles_.push_back(triangles);
      }
    }
  }
}

MovingPair NearPairs::moving(const NearTriangles& pair) noexcept
{
  MovingPair moving;
  for (int k = 0; k < 3; ++k)
  {
    moving.arms_W[k] = this->at(pair.vertices[k]).arm_W;
  }
  moving.scene_W = this->scene_W_.corners(pair.sceneTriangle);
  return moving;
}

Corners NearPairs::toolAt_W(std::uint32_t triangle, const Mat3& turn, const Vec3& centre_W) const noexcept
{
  Corners corners = this->tool_B_.corners(triangle);
  for (Vec3& p : corners)
  {
    p = centre_W + turn * p;
  }
  return corners;
}

} // namespace palpate
