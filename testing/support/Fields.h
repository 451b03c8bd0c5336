// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "haptics/field/FieldBlock.h"

namespace palpate::test
{

/// A function of index coordinates at the points of a grid, x fastest.
template<class Function>
std::vector<float> sampledValues(const GridIndex& size, const Function& function)
{
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(size[0]) * size[1] * size[2]);
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        values.push_back(static_cast<float>(function(Vec3(x, y, z))));
      }
    }
  }
  return values;
}

/// The same of a vector.
template<class Function>
std::vector<float> sampledVectors(const GridIndex& size, const Function& function)
{
  std::vector<float> values;
  (void)sampledValues(size,
    [&](const Vec3& index)
    {
      const Vec3 v = function(index);
      for (int k = 0; k < 3; ++k)
      {
        values.push_back(static_cast<float>(v[k]));
      }
      return 0.0;
    });
  return values;
}

/// A scalar on a cube of points one unit apart, whatever memory it takes.
template<class Function>
std::shared_ptr<const FieldBlock> scalarFieldBlock(int points, const Function& function)
{
  const GridIndex size{ points, points, points };
  return std::make_shared<const FieldBlock>(1, FieldBlockGrid{ size },
    std::vector<FieldBlockArray>{ { FieldBlockRole::Scalar, "f", sampledValues(size, function) } });
}

} // namespace palpate::test
