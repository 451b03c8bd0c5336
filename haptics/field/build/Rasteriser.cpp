// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/build/Rasteriser.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{

/// How far outside of a tetrahedron a point is still its own, in shares of its height: two that share a face leave no
/// gap by rounding.
constexpr double seam = 1e-9;

/// The box around a grid in W.
struct Reach
{
  Vec3 low = Vec3::Constant(INFINITY), high = Vec3::Constant(-INFINITY);

  explicit Reach(const FieldBlockGrid& grid)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vec3 index(
        corner & 1 ? grid.size[0] - 1 : 0, corner & 2 ? grid.size[1] - 1 : 0, corner & 4 ? grid.size[2] - 1 : 0);
      const Vec3 p_W = grid.toWorld(index);
      this->low = this->low.cwiseMin(p_W);
      this->high = this->high.cwiseMax(p_W);
    }
  }
};

/// The shares of a tetrahedron's corners at a point are affine in its index coordinates.
struct Shares
{
  Eigen::Vector4d at0; ///< at index (0, 0, 0)
  std::array<Eigen::Vector4d, 3> slope;
  Eigen::Vector4d perSlope; ///< 1 over those along x
  bool solid = false;

  explicit Shares(const std::array<Vec3, 4>& p)
  {
    const Vec3 a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0], bc = b.cross(c);
    const double volume = a.dot(bc), perVolume = 1.0 / volume;
    this->solid = std::fabs(volume) > std::numeric_limits<double>::min();
    const Vec3 g1 = bc * perVolume, g2 = c.cross(a) * perVolume, g3 = a.cross(b) * perVolume;
    for (int k = 0; k < 3; ++k)
    {
      this->slope[k] = { -g1[k] - g2[k] - g3[k], g1[k], g2[k], g3[k] };
    }
    this->perSlope = this->slope[0].cwiseInverse();
    this->at0 = { 1.0 + (g1 + g2 + g3).dot(p[0]), -g1.dot(p[0]), -g2.dot(p[0]), -g3.dot(p[0]) };
  }
};

/// The points of a grid in the box of a tetrahedron.
struct Points
{
  GridIndex first, last;
  bool any = true;

  Points(const std::array<Vec3, 4>& p, const GridIndex& size)
  {
    const Vec3 low = p[0].cwiseMin(p[1]).cwiseMin(p[2].cwiseMin(p[3]));
    const Vec3 high = p[0].cwiseMax(p[1]).cwiseMax(p[2].cwiseMax(p[3]));
    for (int k = 0; k < 3; ++k)
    {
      const double from = std::max(low[k] - seam, 0.0), to = std::min(high[k] + seam, size[k] - 1.0);
      this->first[k] = static_cast<int>(from) + (from > static_cast<int>(from) ? 1 : 0); // neither is negative
      this->last[k] = to >= 0.0 ? static_cast<int>(to) : -1;
      this->any = this->any && from < size[k] && this->first[k] <= this->last[k];
    }
  }
};

class Raster
{
public:
  Raster(const TetraField& field, const FieldBlockGrid& grid)
    : field_(field), grid_(grid),
      turn_(grid.spacing_u.cwiseInverse().asDiagonal() * grid.pose_W.q.conjugate().toRotationMatrix()),
      values(grid.points() * static_cast<std::size_t>(field.components), std::numeric_limits<float>::quiet_NaN())
  {
  }

  void add(std::uint32_t number)
  {
    const Tetrahedron& t = this->field_.tetrahedra[number];
    std::array<Vec3, 4> corners;
    for (int i = 0; i < 4; ++i)
    {
      corners[i] = this->turn_ * (this->field_.points_W[t[i]] - this->grid_.pose_W.p);
    }
    const Points points(corners, this->grid_.size);
    if (!points.any) // most are small and pass between points
    {
      return;
    }
    const Shares shares(corners);
    for (int z = points.first[2]; shares.solid && z <= points.last[2]; ++z)
    {
      for (int y = points.first[1]; y <= points.last[1]; ++y)
      {
        this->addRow(t, shares, { points.first[0], y, z }, points.last[0]);
      }
    }
  }

private:
  const TetraField& field_;
  const FieldBlockGrid& grid_;
  Mat3 turn_; ///< from displacements in W to displacements in cells

public:
  std::vector<float> values;

private:
  void addRow(const Tetrahedron& t, const Shares& shares, const GridIndex& from, int last)
  {
    const Eigen::Vector4d row = shares.at0 + from[1] * shares.slope[1] + from[2] * shares.slope[2];
    const std::size_t begin = static_cast<std::size_t>(this->grid_.size[0]) *
                              (from[1] + static_cast<std::size_t>(this->grid_.size[1]) * from[2]);
    // Each share bounds the row along x from one side.
    double low = from[0], high = last;
    for (int i = 0; i < 4; ++i)
    {
      const double slope = shares.slope[0][i], end = -(row[i] + seam) * shares.perSlope[i];
      low = slope > 0.0 ? std::max(low, end) : low;
      high = slope < 0.0 ? std::min(high, end) : high;
      high = slope == 0.0 && row[i] < -seam ? -1.0 : high;
    }
    const int first = static_cast<int>(low) + (low > static_cast<int>(low) ? 1 : 0);
    for (int x = first; x <= high; ++x)
    {
      this->put(t, row + x * shares.slope[0], (begin + x) * this->field_.components);
    }
  }

  void put(const Tetrahedron& t, const Eigen::Vector4d& share, std::size_t at)
  {
    for (int c = 0; c < this->field_.components; ++c)
    {
      double sum = 0.0;
      for (int i = 0; i < 4; ++i)
      {
        sum += share[i] * this->field_.values[static_cast<std::size_t>(t[i]) * this->field_.components + c];
      }
      this->values[at + c] = static_cast<float>(sum);
    }
  }
};

} // namespace

std::vector<float> rasterise(const TetraField& field, const TetraBins& bins, const FieldBlockGrid& grid)
{
  Raster raster(field, grid);
  const Reach reach(grid);
  bins.forEachNear(reach.low, reach.high, [&raster](std::uint32_t number) { raster.add(number); });
  return std::move(raster.values);
}

} // namespace palpate
