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
constexpr double flat = 1e-14; ///< of the corners: below it a gradient is rounding

bool isNear(const Vec3& t) noexcept
{
  return (t.array() >= -farCell).all() && (t.array() <= 1.0 + farCell).all();
}

IsoRow rowOf(const IsoView& view, const GridIndex& at) noexcept
{
  const TrilinearCell cell = view.set.cell(at);
  const Vec3 t = view.x.in(at);
  const Vec3 gradient = cell.gradient(t).cwiseQuotient(view.spacing_u);
  const double slope = gradient.norm(), largest = cell.largestMagnitude();
  IsoRow row;
  row.cell = at;
  if (!(slope * view.spacing_u.maxCoeff() > flat * largest))
  {
    const double far_u = view.q_u.norm();
    row.n = far_u > 0.0 ? Vec3(-view.q_u / far_u) : Vec3(Vec3::UnitX());
    return row;
  }
  const Vec3& h = view.spacing_u;
  row.n = gradient / slope;
  row.gap_u = cell.value(t) / slope;
  row.margin_u = 2.0 * landingMargin(cell) / slope;
  row.bend = cell.mixed(t).cwiseQuotient(slope * Vec3(h.y() * h.z(), h.z() * h.x(), h.x() * h.y()));
  return row;
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
  const double h_u = view.spacing_u.minCoeff();
  IsoRows rows;
  for (const GridIndex& at : cells)
  {
    const IsoRow row = rowOf(view, at);
    const bool met = view.newestHit && &at == &cells.back();
    if (met || (row.gap_u >= -ridge * h_u && row.gap_u <= farPatch * h_u && isNear(view.x.in(at))))
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
