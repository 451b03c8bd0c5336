// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/CleanedVertices.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "haptics/core/LargePages.h"

namespace palpate
{
namespace
{

bool before(const Vec3& a, const Vec3& b)
{
  return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

/// Clean vertices are in order and no two are equal.
std::uint32_t find(const std::vector<Vec3>& clean_W, const Vec3& p_W)
{
  const auto at = std::lower_bound(clean_W.begin(), clean_W.end(), p_W, before);
  const bool known = at != clean_W.end() && *at == p_W;
  return static_cast<std::uint32_t>((known ? at : clean_W.end()) - clean_W.begin());
}

} // namespace

CleanedVertices::CleanedVertices(std::shared_ptr<const TriangleMesh> raw, const std::vector<Vec3>& clean_W,
  std::vector<std::uint32_t> source, bool droppedByPlace)
  : raw_(std::move(raw)), source_(std::move(source)), droppedByPlace_(droppedByPlace)
{
  reserveLarge(this->becameOf_, this->raw_->vertices_W.size());
  for (const Vec3& p_W : this->raw_->vertices_W)
  {
    this->becameOf_.push_back(find(clean_W, p_W));
  }
}

std::optional<std::vector<Vec3>> CleanedVertices::follow(const TriangleMesh& moved) const
{
  if (this->droppedByPlace_ || moved.vertices_W.size() != this->becameOf_.size() ||
      moved.triangles != this->raw_->triangles)
  {
    return std::nullopt;
  }
  std::vector<Vec3> positions_W;
  reserveLarge(positions_W, this->source_.size());
  for (const std::uint32_t source : this->source_)
  {
    positions_W.push_back(moved.vertices_W[source]);
  }
  for (std::size_t i = 0; i < this->becameOf_.size(); ++i)
  {
    const std::uint32_t became = this->becameOf_[i];
    if (became < positions_W.size() && moved.vertices_W[i] != positions_W[became])
    {
      return std::nullopt;
    }
  }
  return positions_W;
}

} // namespace palpate
