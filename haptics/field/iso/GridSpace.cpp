// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/GridSpace.h"

namespace palpate
{

IsoRow GridSpace::row(const GridIndex& at, const GridPlace& x, const IsoSide& of, const Vec3& q_u) const noexcept
{
  const Vec3& h = this->h_u_;
  const TrilinearCell cell = this->cell(at, of);
  IsoRow row;
  row.cell = at;
  row.cell_u = h.minCoeff();
  row.t = x.in(at);
  const Vec3 gradient = cell.gradient(row.t).cwiseQuotient(h);
  const double slope = gradient.norm(), largest = cell.largestMagnitude();
  if (!(slope * h.maxCoeff() > flatGradient * largest))
  {
    const double far_u = q_u.norm();
    row.n = far_u > 0.0 ? Vec3(-q_u / far_u) : Vec3(Vec3::UnitX());
    return row;
  }
  row.n = gradient / slope;
  row.gap_u = cell.value(row.t) / slope;
  row.margin_u = 2.0 * landingMargin(cell) / slope;
  row.mixed = cell.mixed(row.t).cwiseQuotient(slope * Vec3(h.y() * h.z(), h.z() * h.x(), h.x() * h.y()));
  return row;
}

} // namespace palpate
