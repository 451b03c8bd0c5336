// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPixelSquares_h
#define vtkHapticPixelSquares_h

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "haptics/geometry/ink/InkLines.h"
#include "vtkHapticImagePlane.h"

/**
 * Lines between the pixels of a flat image, in one walk over its squares of four neighbouring pixels (marching
 * squares). Where two pixels opposite each other are on one side and the others are not, lines cut off those two. The
 * filters of VTK do not say how far they are, cannot be stopped, keep points in single precision and, for areas, walk
 * once for each of them.
 *
 * Division says which lines there are: Divide(values, draw) calls draw(sides) for each way the four values are divided,
 * where bit k of sides is set for the pixels on one side; GetShare(a, b) is how far from a pixel of value a, as a share
 * of the distance to its neighbour of value b, the line between them passes.
 */
template<class Division>
class vtkHapticPixelSquares
{
public:
  /// Values at (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1).
  using Square = std::array<double, 4>;

  vtkHapticPixelSquares(const vtkHapticImagePlane& plane, const Division& division)
    : Plane(plane), Divider(division), Low(plane.GetWidth()), High(plane.GetWidth()), OnLow(plane.GetWidth(), None),
      OnHigh(plane.GetWidth(), None), Between(plane.GetWidth(), None)
  {
  }

  /// In pixel coordinates. `goes` is told the share done and answers whether to go on.
  [[nodiscard]] palpate::LooseLines Walk(const palpate::Goes& goes)
  {
    constexpr std::size_t rowsPerReport = 16;
    const std::uint32_t height = this->Plane.GetHeight();
    palpate::Steps steps(goes, rowsPerReport);
    this->Read(0);
    for (std::uint32_t j = 0; j + 1 < height && steps.go(j, height); ++j)
    {
      this->Low.swap(this->High);
      this->OnLow.swap(this->OnHigh);
      this->Read(j + 1);
      this->OnHigh.assign(this->OnHigh.size(), None);
      this->Between.assign(this->Between.size(), None);
      this->WalkRow(j);
    }
    return std::move(this->Lines);
  }

private:
  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

  /// Sides of a square: low, high, left, right.
  struct Cut
  {
    int Count;
    std::array<std::array<std::uint8_t, 2>, 2> Sides;
  };
  static constexpr std::array<Cut, 16> Cuts{ { { 0, {} }, { 1, { { { 0, 2 } } } }, { 1, { { { 0, 3 } } } },
    { 1, { { { 2, 3 } } } }, { 1, { { { 1, 2 } } } }, { 1, { { { 0, 1 } } } }, { 2, { { { 1, 2 }, { 0, 3 } } } },
    { 1, { { { 1, 3 } } } }, { 1, { { { 1, 3 } } } }, { 2, { { { 0, 2 }, { 1, 3 } } } }, { 1, { { { 0, 1 } } } },
    { 1, { { { 1, 2 } } } }, { 1, { { { 2, 3 } } } }, { 1, { { { 0, 3 } } } }, { 1, { { { 0, 2 } } } }, { 0, {} } } };

  /// The values of row j as the higher ones.
  void Read(std::uint32_t j)
  {
    for (std::size_t i = 0; i < this->High.size(); ++i)
    {
      this->High[i] = this->Plane.GetValue(static_cast<std::int64_t>(i), j);
    }
  }

  void WalkRow(std::uint32_t j)
  {
    for (std::uint32_t i = 0; i + 1 < this->Low.size(); ++i)
    {
      const Square values{ this->Low[i], this->Low[i + 1], this->High[i], this->High[i + 1] };
      this->Divider.Divide(values,
        [&](unsigned sides)
        {
          const Cut& cut = Cuts[sides];
          for (int line = 0; line < cut.Count; ++line)
          {
            const auto& [a, b] = cut.Sides[static_cast<std::size_t>(line)];
            this->Lines.segments.push_back({ this->PointOn(a, i, j, values), this->PointOn(b, i, j, values) });
          }
        });
    }
  }

  std::uint32_t PointOn(std::uint8_t side, std::uint32_t i, std::uint32_t j, const Square& values)
  {
    const bool upright = side >= 2;
    const std::uint32_t right = side == 3, high = side == 1;
    std::uint32_t& index = upright ? this->Between[i + right] : (high ? this->OnHigh : this->OnLow)[i];
    if (index == None)
    {
      index = static_cast<std::uint32_t>(this->Lines.points_W.size());
      const double share = upright ? this->Divider.GetShare(values[right], values[right + 2])
                                   : this->Divider.GetShare(values[2 * high], values[2 * high + 1]);
      this->Lines.points_W.emplace_back(upright ? i + right : i + share, upright ? j + share : j + high, 0.0);
    }
    return index;
  }

  const vtkHapticImagePlane& Plane;
  const Division& Divider;
  palpate::LooseLines Lines;
  std::vector<double> Low, High; // the values of two rows
  // Points between neighbours in the lower row, in the higher one, and in a column; None where there is none yet.
  std::vector<std::uint32_t> OnLow, OnHigh, Between;
};

#endif
