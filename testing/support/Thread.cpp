// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Thread.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::test
{
namespace
{

constexpr double heightOfThread = 0.5; // in pitches

/// How far the thread is outside of a point [u], along the radius.
double radialGap(const ThreadSize& size, const Vec3& p)
{
  const double turns = p.z() / size.pitch_u - std::atan2(p.y(), p.x()) / (2.0 * std::numbers::pi);
  const double wave = 1.0 - 2.0 * std::abs(turns - std::round(turns)); // 0 at the root, 1 at the crest
  return size.radius_u + heightOfThread * size.pitch_u * wave - p.head<2>().norm();
}

double beyondEnds(const ThreadSize& size, const Vec3& p)
{
  return std::abs(p.z()) - 0.5 * size.length_u;
}

} // namespace

TriangleMesh threadMesh(const ThreadSize& size, int around)
{
  TriangleMesh mesh;
  const int steps = static_cast<int>(size.length_u / size.pitch_u * around);
  for (int i = 0; i <= steps; ++i)
  {
    const double turns = static_cast<double>(i) / around, angle = 2.0 * std::numbers::pi * turns;
    const Vec3 radial(std::cos(angle), std::sin(angle), 0.0);
    // The phase is that of distanceToScrew: crests where z / pitch less the turn is whole.
    const double start = std::floor(-0.5 * size.length_u / size.pitch_u);
    const Vec3 up(0, 0, size.pitch_u * (start + turns));
    mesh.vertices_W.emplace_back((size.radius_u + heightOfThread * size.pitch_u) * radial + up);
    mesh.vertices_W.emplace_back(size.radius_u * radial + up + Vec3(0, 0, 0.5 * size.pitch_u));
  }
  const auto strip = [&](int low, int high)
  {
    const auto a = static_cast<std::uint32_t>(low), b = static_cast<std::uint32_t>(high);
    mesh.triangles.push_back({ a, a + 2, b + 2 });
    mesh.triangles.push_back({ a, b + 2, b });
  };
  for (int i = 0; i < steps; ++i)
  {
    strip(2 * i, 2 * i + 1);
    if (i + around < steps)
    {
      strip(2 * i + 1, 2 * (i + around));
    }
  }
  return mesh;
}

double distanceToScrew(const ThreadSize& size, const Vec3& p)
{
  return std::max(-radialGap(size, p) / std::numbers::sqrt2, beyondEnds(size, p));
}

double distanceToNut(const ThreadSize& size, const Vec3& p)
{
  return std::max(radialGap(size, p) / std::numbers::sqrt2, beyondEnds(size, p));
}

} // namespace palpate::test
