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

  /// The face, by compute() where it is not there.
  template<class Compute>
  [[nodiscard]] const FaceRecord& at(std::uint32_t surface, std::uint32_t triangle, Compute compute) noexcept
  {
    const std::size_t slot = (triangle + 5 * surface) % slots;
    const std::uint64_t key = std::uint64_t{ surface } << 32 | triangle;
    if (this->keys_[slot] != key)
    {
      this->faces_[slot] = compute();
      this->keys_[slot] = key;
    }
    return this->faces_[slot];
  }

private:
  static constexpr std::size_t slots = 64; ///< 8 kB: a quarter of a first cache
  static constexpr std::uint64_t none = ~std::uint64_t{ 0 };

  std::array<std::uint64_t, slots> keys_;
  std::array<FaceRecord, slots> faces_;
};

} // namespace palpate
