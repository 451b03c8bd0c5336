// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/PolyLines.h"

#include <cmath>
#include <sstream>

namespace palpate
{

TriangleMesh segmentsOf(const PolyLines& curves)
{
  TriangleMesh mesh;
  mesh.vertices_W = curves.points_W;
  for (const std::vector<std::uint32_t>& line : curves.lines)
  {
    if (line.size() == 1)
    {
      mesh.triangles.push_back({ line[0], line[0], line[0] });
    }
    for (std::size_t k = 1; k < line.size(); ++k)
    {
      mesh.triangles.push_back({ line[k - 1], line[k], line[k] });
    }
  }
  return mesh;
}

std::string refuseLineRadius(double radius_u, double largest_u)
{
  std::ostringstream refusal;
  if (!std::isfinite(radius_u) || radius_u <= 0.0)
  {
    refusal << "its line radius is " << radius_u << ": it must be finite and above 0";
  }
  else if (constexpr double thinnest = 1e-9; radius_u < thinnest * largest_u)
  {
    refusal << "its line radius of " << radius_u << " is below the rounding error of coordinates up to " << largest_u;
  }
  return refusal.str();
}

} // namespace palpate
