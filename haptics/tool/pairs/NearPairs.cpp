// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/pairs/NearPairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{

constexpr std::size_t knownPlanes = 1u << 14;    // four times the leaves that a list usually has
constexpr std::uint32_t spreading = 2654435761u; // multiplicative hashing (Knuth 1973)

} // namespace

NearPairs::NearPairs(const BoxedMesh& tool_B, const BoxedMesh& scene_W)
  : tool_B_(tool_B), scene_W_(scene_W), leafRange_(tool_B.nodes().size()), local_(tool_B.mesh().vertices_W.size()),
    localStamp_(tool_B.mesh().vertices_W.size()), known_(knownPlanes)
{
}

void NearPairs::rebuild(const std::vector<BoxPair>& near, double way_u)
{
  ++this->stamp_;
  this->way_u_ = way_u;
  for (const LeafPair& pair : this->leaves_)
  {
    this->knownPlane(pair) = { pair.toolNode, pair.sceneNode, pair.n_W, pair.below_u };
  }
  this->leaves_.clear();
  this->triangles_.clear();
  this->leafVertices_.clear();
  this->body_B_.clear();
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

NearPairs::KnownPlane& NearPairs::knownPlane(const LeafPair& pair) noexcept
{
  const std::uint32_t hash = (pair.toolNode * spreading ^ pair.sceneNode) * spreading;
  return this->known_[(hash >> 16) % knownPlanes];
}

void NearPairs::recall(LeafPair& pair) noexcept
{
  const KnownPlane& known = this->knownPlane(pair);
  if (known.toolNode == pair.toolNode && known.sceneNode == pair.sceneNode)
  {
    pair.n_W = known.n_W;
    pair.below_u = known.below_u;
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
        this->local_[v] = static_cast<std::uint32_t>(this->body_B_.size());
        this->body_B_.push_back(this->tool_B_.mesh().vertices_W[v]);
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

/// Several steps are tried from one pose.
void NearPairs::turnArms(const Quat& turn)
{
  if (this->armsOf_ == this->stamp_ && this->step_.from_W.q.coeffs() == turn.coeffs())
  {
    return;
  }
  this->armsOf_ = this->stamp_;
  this->start_ = turn.toRotationMatrix();
  this->arms_W_.resize(this->body_B_.size());
  for (std::size_t i = 0; i < this->arms_W_.size(); ++i)
  {
    this->arms_W_[i] = this->start_ * this->body_B_[i];
  }
}

void NearPairs::setStep(const ScrewStep& step, double way_u)
{
  this->turnArms(step.from_W.q);
  this->step_ = step;
  this->way_u_ = way_u;
  const Mat3 end = step.turn(1.0);
  const std::size_t count = this->arms_W_.size();
  this->ends_W_.resize(count);
  this->along_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->ends_W_[i] = end * this->arms_W_[i];
    this->along_[i] = step.w_W.dot(this->arms_W_[i]);
  }
}

SpanGap NearPairs::gapOver(std::span<const std::uint32_t> vertices, const Vec3& n_W, double below_u) const noexcept
{
  const Vec3& w = this->step_.w_W;
  const double nw = n_W.dot(w), w2 = w.squaredNorm();
  double from = std::numeric_limits<double>::infinity(), to = from, bend = 0.0, reach2 = 0.0;
  for (const std::uint32_t v : vertices)
  {
    const double height = n_W.dot(this->arms_W_[v]);
    from = std::min(from, height);
    to = std::min(to, n_W.dot(this->ends_W_[v]));
    bend = std::max(bend, nw * this->along_[v] - w2 * height); // n . (w x (w x arm))
    reach2 = std::max(reach2, this->arms_W_[v].squaredNorm());
  }
  bend += w2 * std::sqrt(w2 * reach2);
  const double centre = n_W.dot(this->step_.from_W.p) - below_u;
  return { from + centre, to + centre + n_W.dot(this->step_.v_W), 0.125 * bend };
}

SpanGap NearPairs::gapOf(const NearTriangles& pair, const Vec3& n_W) const noexcept
{
  const Corners scene_W = this->scene_W_.corners(pair.sceneTriangle);
  const double below_u = std::max({ n_W.dot(scene_W[0]), n_W.dot(scene_W[1]), n_W.dot(scene_W[2]) });
  return this->gapOver(pair.vertices, n_W, below_u);
}

double NearPairs::belowOf(const LeafPair& pair, const Vec3& n_W) const noexcept
{
  const BoxedMesh::Node& node = this->scene_W_.nodes()[pair.sceneNode];
  double below = -std::numeric_limits<double>::infinity();
  for (std::uint32_t t = node.second; t < node.second + node.count; ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      below = std::max(below, n_W.dot(this->scene_W_.corner(t, k)));
    }
  }
  return below;
}

std::array<Vec3, 3> NearPairs::candidates(const LeafPair& pair) const noexcept
{
  const BoxedMesh::Node &a = this->tool_B_.nodes()[pair.toolNode], &b = this->scene_W_.nodes()[pair.sceneNode];
  const Vec3 between = this->step_.from_W.p + this->start_ * a.box.centre() - b.box.centre();
  const double distance = between.norm();
  return { unitNormal(this->scene_W_.corners(b.second)), this->start_ * unitNormal(this->tool_B_.corners(a.second)),
    distance > 0.0 ? Vec3(between / distance) : Vec3(Vec3::UnitZ()) };
}

bool NearPairs::findPlane(LeafPair& pair, double share, double gap_u) const noexcept
{
  double best = -std::numeric_limits<double>::infinity();
  for (const Vec3& axis : this->candidates(pair))
  {
    for (const double sign : { 1.0, -1.0 })
    {
      const Vec3 n = sign * axis;
      const double below = this->belowOf(pair, n);
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
    for (int k = 0; k < 3; ++k)
    {
      triangles.vertices[k] = this->local_[this->tool_B_.mesh().triangles[i][k]];
    }
    for (std::uint32_t j = b.second; j < b.second + b.count; ++j)
    {
      triangles.sceneTriangle = j;
      this->triangles_.push_back(triangles);
    }
  }
}

MovingPair NearPairs::moving(const NearTriangles& pair) const noexcept
{
  MovingPair moving;
  for (int k = 0; k < 3; ++k)
  {
    moving.arms_W[k] = this->arms_W_[pair.vertices[k]];
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
