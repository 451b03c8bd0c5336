// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/simplify/SurfacePatches.h"

#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

class Grower
{
public:
  explicit Grower(const SurfaceData& data)
    : data_(data), taken_(data.faces.size(), false), number_(data.mesh.vertices_W.size(), SurfaceData::none)
  {
  }

  void grow(std::uint32_t seed, std::size_t size)
  {
    const std::size_t first = this->patches_.triangles.size();
    this->take(seed, first + size);
    for (std::size_t at = first; at < this->patches_.triangles.size(); ++at)
    {
      for (const std::uint32_t v : this->data_.corners(this->patches_.triangles[at]))
      {
        this->data_.forEachAround(v, [&](std::uint32_t t) { this->take(t, first + size); });
      }
    }
  }

  SurfacePatches finish()
  {
    for (const std::uint32_t v : this->patches_.vertices)
    {
      bool rim = false;
      this->data_.forEachAround(v, [&](std::uint32_t t) { rim = rim || !this->taken_[t]; });
      this->patches_.rim.push_back(rim);
    }
    return std::move(this->patches_);
  }

private:
  void take(std::uint32_t triangle, std::size_t most)
  {
    if (this->taken_[triangle] || this->patches_.triangles.size() >= most)
    {
      return;
    }
    this->taken_[triangle] = true;
    this->patches_.triangles.push_back(triangle);
    const auto& [a, b, c] = this->data_.mesh.triangles[triangle];
    this->patches_.mesh.triangles.push_back({ this->number(a), this->number(b), this->number(c) });
  }

  std::uint32_t number(std::uint32_t vertex)
  {
    std::uint32_t& number = this->number_[vertex];
    if (number == SurfaceData::none)
    {
      number = static_cast<std::uint32_t>(this->patches_.vertices.size());
      this->patches_.vertices.push_back(vertex);
      this->patches_.mesh.vertices_W.push_back(this->data_.vertex(vertex));
    }
    return number;
  }

  const SurfaceData& data_;
  std::vector<bool> taken_;
  std::vector<std::uint32_t> number_; ///< in the patches
  SurfacePatches patches_;
};

} // namespace

SurfacePatches patchesOf(const SurfaceTree& surface, std::size_t count, std::size_t size)
{
  Grower grower(surface.data());
  const std::size_t triangles = surface.mesh().triangles.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    grower.grow(static_cast<std::uint32_t>((2 * i + 1) * triangles / (2 * count)), size);
  }
  return grower.finish();
}

} // namespace palpate
