// SPDX-License-Identifier: GPL-3.0-or-later
#include "Plug.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace palpate::test
{
namespace
{

constexpr int stepsAcross = 12; // rings between two borders

/// A closed line round the axis: its distance from it at an angle, on a ball.
struct Ring
{
  std::function<double(double angle)> away_mm;
  double ball_mm = 0.0;
};

std::function<double(double)> borderOf(const PlugSize& size, double narrower_mm)
{
  return [=](double angle) { return size.hole_mm - narrower_mm + size.wave_mm * std::sin(5.0 * angle); };
}

std::function<double(double)> circle(double away_mm)
{
  return [=](double) { return away_mm; };
}

/// From one line to another on one ball.
void appendRings(std::vector<Ring>& rings, const Ring& from, const Ring& to)
{
  for (int i = 0; i <= stepsAcross; ++i)
  {
    const double share = static_cast<double>(i) / stepsAcross;
    rings.push_back(
      { [=](double angle) { return (1.0 - share) * from.away_mm(angle) + share * to.away_mm(angle); }, from.ball_mm });
  }
}

/// Strips between rings that follow one another, and between the last and the first.
TriangleMesh meshOf(const std::vector<Ring>& rings, int around)
{
  TriangleMesh mesh;
  for (const Ring& ring : rings)
  {
    for (int k = 0; k < around; ++k)
    {
      const double angle = 2.0 * std::numbers::pi * k / around, away = ring.away_mm(angle);
      mesh.vertices_W.emplace_back(
        away * std::cos(angle), -std::sqrt(ring.ball_mm * ring.ball_mm - away * away), away * std::sin(angle));
    }
  }
  const auto count = static_cast<std::uint32_t>(rings.size()), n = static_cast<std::uint32_t>(around);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const std::uint32_t here = i * n, next = (i + 1) % count * n;
    for (std::uint32_t k = 0; k < n; ++k)
    {
      const std::uint32_t on = (k + 1) % n;
      mesh.triangles.push_back({ here + k, here + on, next + on });
      mesh.triangles.push_back({ here + k, next + on, next + k });
    }
  }
  return mesh;
}

} // namespace

TriangleMesh shellWithHole(const PlugSize& size)
{
  const Ring outside{ borderOf(size, 0.0), size.outer_mm }, inside{ borderOf(size, size.taper_mm), size.inner_mm };
  std::vector<Ring> rings;
  appendRings(rings, { circle(size.edge_mm), size.outer_mm }, outside);
  appendRings(rings, inside, { circle(size.edge_mm), size.inner_mm });
  return meshOf(rings, size.around);
}

TriangleMesh plugOf(const PlugSize& size, double play_mm)
{
  const Ring outside{ borderOf(size, play_mm), size.outer_mm };
  const Ring inside{ borderOf(size, size.taper_mm + play_mm), size.inner_mm };
  std::vector<Ring> rings;
  appendRings(rings, { circle(0.0), size.outer_mm }, outside);
  appendRings(rings, inside, { circle(0.0), size.inner_mm });
  return meshOf(rings, size.around);
}

} // namespace palpate::test
