// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "haptics/field/proxy/FieldProxy.h"
#include "testing/support/Fields.h"

namespace palpate::test
{

inline constexpr double k = 1.0; ///< [N/u]; with a spacing of a millimetre work is in mJ
inline const GridIndex cube_n{ 32, 32, 32 };
inline const Vec3 middle(15.5, 15.5, 15.5);

inline FieldBlock brickOf(
  std::vector<FieldBlockArray> arrays, std::vector<Vec3> places_W = {}, std::vector<FieldBlockLine> lines_W = {})
{
  return FieldBlock(1, FieldBlockGrid{ cube_n }, std::move(arrays), std::move(places_W), std::move(lines_W));
}

template<class Function>
FieldBlockArray scalar(const Function& function, FieldBlockRole role = FieldBlockRole::Scalar)
{
  return { role, "f", sampledValues(cube_n, function) };
}

inline const auto height = [](const Vec3& i) { return i.z(); };

/// A hand that moves and the work that the field does on it, by the trapezoid of both ends of each step.
struct Hand
{
  const FieldBlock& brick;
  FieldPlan plan;
  FieldState state = {};
  Vec3 p = middle, force = Vec3::Zero();
  double work = 0.0;
  FieldResult last = {};

  void to(const Vec3& next)
  {
    this->last = moveFieldProxy(this->brick, this->plan, k, next, this->state);
    const Vec3 now = k * this->last.pull_W + this->last.push_W;
    this->work += 0.5 * (this->force + now).dot(next - this->p);
    this->force = now;
    this->p = next;
  }
  void start(const Vec3& at)
  {
    this->p = at;
    this->to(at);
    this->work = 0.0;
  }
};

} // namespace palpate::test
