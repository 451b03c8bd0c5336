// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/core/PointGrid.h"

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
      octave.bins.forEach(octave.bins.cellOf(low_W - octave.widest), octave.bins.cellOf(high_W),
        [&](std::size_t bin)
        {
          for (std::uint32_t at = octave.start[bin]; at < octave.start[bin + 1]; ++at)
          {
            visit(octave.tetrahedra[at]);
          }
        });
    }
  }
  [[nodiscard]] std::size_t bytes() const noexcept;

private:
  struct Octave
  {
    PointGrid bins;
    Vec3 widest = Vec3::Zero(); ///< extent of any of its tetrahedra
    std::vector<std::uint32_t> start, tetrahedra;
  };
  static Octave octaveOf(
    std::span<const Vec3> points_W, std::span<const Tetrahedron> tetrahedra, const std::vector<std::uint32_t>& members);

  std::vector<Octave> octaves_;
};

} // namespace palpate
