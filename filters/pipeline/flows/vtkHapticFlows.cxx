// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFlows.h"

#include <cmath>
#include <numbers>

using palpate::Vec3;

namespace
{
constexpr double pi = std::numbers::pi;

Vec3 ArnoldBeltramiChildress(const Vec3& p, double)
{
  const double a = std::sqrt(3.0), b = std::sqrt(2.0), c = 1.0;
  return { a * std::sin(p.z()) + c * std::cos(p.y()), b * std::sin(p.x()) + a * std::cos(p.z()),
    c * std::sin(p.y()) + b * std::cos(p.x()) };
}

Vec3 TaylorGreen(const Vec3& p, double)
{
  return { std::sin(p.x()) * std::cos(p.y()) * std::cos(p.z()), -std::cos(p.x()) * std::sin(p.y()) * std::cos(p.z()),
    0.0 };
}

Vec3 LambOseen(const Vec3& p, double)
{
  const double r2 = p.x() * p.x() + p.y() * p.y();
  const double turn = r2 > 0.0 ? -std::expm1(-r2) / r2 : 1.0;
  return { -turn * p.y(), turn * p.x(), 0.0 };
}

constexpr double gyreSeconds = 10.0;

Vec3 DoubleGyre(const Vec3& p, double time)
{
  const double speed = 0.1, swing = 0.25;
  const double a = swing * std::sin(2.0 * pi / gyreSeconds * time), b = 1.0 - 2.0 * a;
  const double f = (a * p.x() + b) * p.x(), slope = 2.0 * a * p.x() + b;
  return { -pi * speed * std::sin(pi * f) * std::cos(pi * p.y()),
    pi * speed * std::cos(pi * f) * std::sin(pi * p.y()) * slope, 0.0 };
}
} // namespace

const std::array<vtkHapticFlow, 4>& vtkHapticFlows::All()
{
  const Vec3 none = Vec3::Zero(), round = Vec3::Constant(2.0 * pi);
  static const std::array<vtkHapticFlow, 4> flows = { {
    { "ABC", none, round, ArnoldBeltramiChildress },
    { "Taylor-Green", none, round, TaylorGreen },
    { "Lamb-Oseen", Vec3::Constant(-4.0), Vec3::Constant(4.0), LambOseen },
    { "Double gyre", none, Vec3(2.0, 1.0, 0.5), DoubleGyre, gyreSeconds },
  } };
  return flows;
}
