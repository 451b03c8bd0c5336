// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

using Tetrahedron = std::array<std::uint32_t, 4>; ///< numbers of points

/// Tetrahedra by where the lowest corner of their box is, so that each is listed once. Those of one octave of size
/// share bins of their size: a large one beside a small one does not widen the search for all. Four bytes a tetrahedron
/// and little else. Built once for a mesh, on a worker.
class TetraBins
{
public:
  TetraBins(std::span<const Vec3> points_W, std::span<const Tetrahedron> tetrahedra);

  /// Calls visit(number) for each tetrahedron whose box may meet the box, and for few others.
  template<class Visit>
  void forEachNear(const Vec3& low_W, const Vec3& high_W, const Visit& visit) const
  {
    for (const Octave& octave : this->octaves_)
    {
      const std::array<int, 3> first = octave.binOf(low_W - octave.widest), last = octave.binOf(high_W);
      for (int z = first[2]; z <= last[2]; ++z)
      {
        for (int y = first[1]; y <= last[1]; ++y)
        {
          const std::size_t row = octave.size[0] * (y + octave.size[1] * static_cast<std::size_t>(z));
          for (std::uint32_t at = octave.start[row + first[0]]; at < octave.start[row + last[0] + 1]; ++at)
          {
            visit(octave.tetrahedra[at]);
          }
        }
      }
    }
  }
  [[nodiscard]] std::size_t bytes() const noexcept;

private:
  struct Octave
  {
    Vec3 low = Vec3::Zero(), bin = Vec3::Ones();
    Vec3 widest = Vec3::Zero(); ///< extent of any of its tetrahedra
    std::array<int, 3> size{ 1, 1, 1 };
    std::vector<std::uint32_t> start, tetrahedra;

    [[nodiscard]] std::array<int, 3> binOf(const Vec3& p_W) const noexcept;
  };
  static Octave octaveOf(
    std::span<const Vec3> points_W, std::span<const Tetrahedron> tetrahedra, const std::vector<std::uint32_t>& members);

  std::vector<Octave> octaves_;
};

} // namespace palpate
