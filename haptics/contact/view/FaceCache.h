// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// Faces of surfaces on their way at one moment, each in the frame of its surface. A tick asks for the same few faces
/// many times, and where vertices are on their way a face takes a root and a division. Fixed memory: a face takes the
/// slot of another one.
class FaceCache
{
public:
  FaceCache() noexcept { this->keys_.fill(none); } // the faces are not to be set to zero

  /// The face where it is there, else null.
  [[nodiscard]] const FaceRecord* find(std::uint32_t surface, std::uint32_t triangle) const noexcept
  {
    const std::size_t slot = slotOf(surface, triangle);
    return this->keys_[slot] == keyOf(surface, triangle) ? &this->faces_[slot] : nullptr;
  }
  /// The face, by compute() where it is not there.
  template<class Compute>
  [[nodiscard]] const FaceRecord& at(std::uint32_t surface, std::uint32_t triangle, Compute compute) noexcept
  {
    const std::size_t slot = slotOf(surface, triangle);
    if (this->keys_[slot] != keyOf(surface, triangle))
    {
      this->faces_[slot] = compute();
      this->keys_[slot] = keyOf(surface, triangle);
    }
    return this->faces_[slot];
  }

private:
  static constexpr std::size_t slots = 128; ///< 17 kB: half of a first cache
  static constexpr std::uint64_t none = ~std::uint64_t{ 0 };

  static std::size_t slotOf(std::uint32_t surface, std::uint32_t triangle) noexcept
  {
    return (triangle + 5 * surface) % slots;
  }
  static std::uint64_t keyOf(std::uint32_t surface, std::uint32_t triangle) noexcept
  {
    return std::uint64_t{ surface } << 32 | triangle;
  }

  std::array<std::uint64_t, slots> keys_;
  std::array<FaceRecord, slots> faces_;
};

} // namespace palpate
