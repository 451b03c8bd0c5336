// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>

#include "haptics/compliance/body/SoftBody.h"

namespace palpate::test
{

/// A box from (0, 0, 0) to `size` of so many cells an axis, each six tetrahedra around its diagonal (Kuhn 1960).
inline TetraMesh blockOf(const std::array<int, 3>& cells, const Vec3& size)
{
  TetraMesh mesh;
  const auto at = [&cells](int i, int j, int k)
  { return static_cast<std::uint32_t>((k * (cells[1] + 1) + j) * (cells[0] + 1) + i); };
  for (int k = 0; k <= cells[2]; ++k)
  {
    for (int j = 0; j <= cells[1]; ++j)
    {
      for (int i = 0; i <= cells[0]; ++i)
      {
        mesh.vertices_W.emplace_back(
          Vec3(i, j, k).cwiseProduct(size).cwiseQuotient(Vec3(cells[0], cells[1], cells[2])));
      }
    }
  }
  constexpr std::array<std::array<int, 3>, 6> ways{ { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 },
    { 1, 0, 2 } } };
  for (int cell = 0; cell < cells[0] * cells[1] * cells[2]; ++cell)
  {
    const std::array<int, 3> low{ cell % cells[0], cell / cells[0] % cells[1], cell / cells[0] / cells[1] };
    for (std::size_t w = 0; w < ways.size(); ++w)
    {
      std::array<int, 3> p = low;
      Tetra t{ at(p[0], p[1], p[2]) };
      for (int corner = 0; corner < 3; ++corner)
      {
        ++p[static_cast<std::size_t>(ways[w][static_cast<std::size_t>(corner)])];
        t[static_cast<std::size_t>(corner) + 1] = at(p[0], p[1], p[2]);
      }
      if (w >= 3)
      {
        std::swap(t[2], t[3]);
      }
      mesh.tetras.push_back(t);
    }
  }
  return mesh;
}

inline std::vector<bool> fixedWhere(const TetraMesh& mesh, const std::function<bool(const Vec3&)>& where)
{
  std::vector<bool> fixed;
  for (const Vec3& p : mesh.vertices_W)
  {
    fixed.push_back(where(p));
  }
  return fixed;
}

/// The block of the papers: .1 x .1 x .05 m of 20 kPa on a rigid floor, n cells along it.
inline SoftBodyInput pad(int n)
{
  SoftBodyInput input;
  input.mesh = blockOf({ n, n, n / 2 }, { 0.1, 0.1, 0.05 });
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.z() == 0.0; });
  input.young_Pa = { 20e3 };
  return input;
}

/// Of its upper side.
inline Vec3 middleOfPad()
{
  return { 0.05, 0.05, 0.05 };
}

} // namespace palpate::test
