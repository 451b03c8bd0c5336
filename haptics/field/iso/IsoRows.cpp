// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/IsoRows.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

constexpr double ridge = 1e-9; ///< of a spacing: more than rounding of a gap, less than anything that is felt
constexpr double farPatch = 0.5, farCell = 0.5;

bool isNear(const Vec3& t) noexcept
{
  return (t.array() >= -farCell).all() && (t.array() <= 1.0 + farCell).all();
}

} // namespace

void IsoRows::forget(int first) noexcept
{
  for (int i = first; i < this->count; ++i)
  {
    this->row[i - first] = this->row[i];
  }
  this->count -= first;
}

IsoRows rowsAt(const IsoView& view, std::span<const GridIndex> cells) noexcept
{
  IsoRows rows;
  for (const GridIndex& at : cells)
  {
    const IsoRow row = view.space.row(at, view.x, view.of, view.q_u);
    const bool met = view.newestHit && &at == &cells.back();
    if (met || (row.gap_u >= -ridge * row.cell_u && row.gap_u <= farPatch * row.cell_u && isNear(row.t)))
    {
      rows.row[rows.count++] = row;
    }
  }
  return rows;
}

ProjectionResult projectOntoRows(
  IsoRows& rows, const Vec3& target_u, std::span<const double> lift_u, double slack_u) noexcept
{
  std::array<PlaneRow, IsoState::mostCells> planes;
  const int count = rows.count;
  for (int i = 0; i < count; ++i)
  {
    planes[i] = { rows.row[i].n, (lift_u.empty() ? 0.0 : lift_u[i]) - rows.row[i].gap_u };
  }
  for (int first = 0;; first = std::max(first + 1, count - 2))
  {
    const std::span<const PlaneRow> kept(planes.data() + first, static_cast<std::size_t>(count - first));
    const ProjectionResult result = projectOntoPlanes(kept, target_u, slack_u);
    if (result.feasible || kept.size() <= 1)
    {
      rows.forget(first);
      return result;
    }
  }
}

} // namespace palpate
