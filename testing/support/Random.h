// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate::test
{

/// splitmix64 (Steele, Lea & Flood 2014): the same numbers on every machine, unlike the distributions of <random>.
class Random
{
public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

  [[nodiscard]] std::uint64_t next() noexcept;
  /// Uniform in [0, 1).
  [[nodiscard]] double uniform() noexcept;
  [[nodiscard]] double uniform(double low, double high) noexcept { return low + (high - low) * this->uniform(); }
  /// Uniform in 0 .. count - 1.
  [[nodiscard]] std::uint32_t below(std::uint32_t count) noexcept;
  /// Uniform in the cube [-half, half]^3.
  [[nodiscard]] Vec3 inCube(double half) noexcept;
  /// Uniform on the unit sphere.
  [[nodiscard]] Vec3 direction() noexcept;

  template<class T>
  void shuffle(std::vector<T>& items) noexcept
  {
    for (std::size_t left = items.size(); left > 1; --left)
    {
      std::swap(items[left - 1], items[this->below(static_cast<std::uint32_t>(left))]);
    }
  }

private:
  std::uint64_t state_;
};

/// PALPATE_TEST_SEED where it is set, else the test's own seed.
[[nodiscard]] std::uint64_t testSeed(std::uint64_t ownSeed);
/// PALPATE_TEST_COUNT where it is set, else the test's own count of cases.
[[nodiscard]] std::size_t testCount(std::size_t ownCount);
/// PALPATE_TEST_MESHES where it is set, else the test's own count of meshes.
[[nodiscard]] std::size_t testMeshes(std::size_t ownCount);
/// PALPATE_TEST_TRIANGLES where it is set, else the test's own largest mesh.
[[nodiscard]] std::size_t testTriangles(std::size_t ownCount);

} // namespace palpate::test
