// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/shapes/AnalyticTouch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "testing/support/Meshes.h"

namespace palpate::lab
{
namespace
{

constexpr double stiffness_N_per_m = 500.0;
constexpr double pi = std::numbers::pi;

/// A hand's own changes of force, well below the 10 Hz it can do.
double pushAt_N(double t_s)
{
  return 1.0 + 0.4 * std::sin(2 * pi * 2.0 * t_s);
}

Vec3 torusPoint(double u, double v, double tube_m)
{
  constexpr double ring_m = 0.04;
  const double out_m = ring_m + tube_m * std::cos(v);
  return { out_m * std::cos(u), out_m * std::sin(u), tube_m * std::sin(v) };
}

TriangleMesh makeTorus(std::uint32_t around, std::uint32_t across, double tube_m)
{
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i)
  {
    for (std::uint32_t j = 0; j < across; ++j)
    {
      mesh.vertices_W.push_back(torusPoint(2 * pi * i / around, 2 * pi * j / across, tube_m));
      const std::uint32_t i1 = (i + 1) % around, j1 = (j + 1) % across;
      mesh.triangles.push_back({ i * across + j, i1 * across + j, i1 * across + j1 });
      mesh.triangles.push_back({ i * across + j, i1 * across + j1, i * across + j1 });
    }
  }
  return mesh;
}

/// From wall to wall and back: 0 .. 2, of which the middle 0.6 is spent in the crease.
double phaseAt(double t_s)
{
  const double phase = std::fmod(t_s, 4.0);
  return phase < 2.0 ? phase : 4.0 - phase;
}

TouchMoment wedgeAt(double t_s, double radius_m)
{
  constexpr double half_rad = pi / 6;
  const Vec3 left(std::cos(half_rad), 0, std::sin(half_rad)), right(-std::cos(half_rad), 0, std::sin(half_rad));
  const double phase = phaseAt(t_s);
  const double turn = std::clamp((phase - 0.7) / 0.6, 0.0, 1.0);
  const double up_m = 0.03 * std::max({ 0.0, 0.7 - phase, phase - 1.3 }) / 0.7;
  const Vec3 along = Vec3(phase < 1.0 ? -std::sin(half_rad) : std::sin(half_rad), 0, std::cos(half_rad));
  const Vec3 crease_W(0, 0.02 * std::sin(t_s), radius_m / std::sin(half_rad));
  return { crease_W + up_m * along, pushAt_N(t_s) * ((1 - turn) * left + turn * right) };
}

} // namespace

AnalyticTouch touchPlane(test::Random& random)
{
  const Vec3 n = Vec3(0.3, -0.2, 1.0).normalized();
  const Vec3 e1 = n.unitOrthogonal(), e2 = n.cross(e1);
  return { "plane", test::makePlane(n, 0.1, 60, random), 0.0,
    [=](double t_s, double radius_m)
    {
      const Vec3 foot_W = 0.05 * std::sin(2 * t_s) * e1 + 0.03 * std::sin(3.1 * t_s) * e2;
      return TouchMoment{ foot_W + radius_m * n, pushAt_N(t_s) * n };
    } };
}

AnalyticTouch touchSphere(int levels)
{
  constexpr double sphere_m = 0.05;
  AnalyticTouch touch{ "sphere", test::makeIcosphere(levels, sphere_m), 0.0,
    [](double t_s, double radius_m)
    {
      const double a = 2 * t_s, b = 0.3 * t_s;
      const Vec3 n(std::cos(a), std::sin(a) * std::cos(b), std::sin(a) * std::sin(b));
      return TouchMoment{ (sphere_m + radius_m) * n, pushAt_N(t_s) * n };
    } };
  // A facet whose corners lie on the sphere dips under it by 5.83 R / N in its middle, so its corners are tilted by
  // the root of twice that over R; of a contact anywhere on it no more.
  touch.tilt_rad = std::sqrt(2 * 5.83 / static_cast<double>(touch.mesh.triangles.size()));
  return touch;
}

AnalyticTouch touchWedge()
{
  return { "wedge", test::makeGroove(pi / 6, 0.1), 0.0, wedgeAt };
}

AnalyticTouch touchTorus(std::uint32_t around, std::uint32_t across)
{
  constexpr double tube_m = 0.015;
  return { "torus", makeTorus(around, across, tube_m), 2 * pi / around + 2 * pi / across,
    [](double t_s, double radius_m)
    {
      const double u = 0.8 * t_s, v = 3.0 * t_s;
      const Vec3 n(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
      return TouchMoment{ torusPoint(u, v, tube_m + radius_m), pushAt_N(t_s) * n };
    } };
}

AnalyticTouch rubbed(const AnalyticTouch& smooth, double mu)
{
  AnalyticTouch rough = smooth;
  rough.at = [at = smooth.at, mu](double t_s, double radius_m)
  {
    constexpr double h_s = 1e-6;
    TouchMoment moment = at(t_s, radius_m);
    const Vec3 way_W = at(t_s + h_s, radius_m).centre_W - at(t_s - h_s, radius_m).centre_W;
    moment.force_N -= mu * moment.force_N.norm() * way_W.normalized();
    return moment;
  };
  return rough;
}

RenderedTouch render(const AnalyticTouch& touch, const MethodKind& method, int ticks)
{
  RenderedTouch rendered;
  test::CostSample sample(static_cast<std::size_t>(ticks));
  const auto proxy = method.make(World(touch.mesh));
  const TouchMoment first = touch.at(0.0, method.radius_m);
  proxy->start(first.centre_W + 5e-3 * first.force_N.normalized());
  for (int i = 0; i < ticks; ++i)
  {
    const TouchMoment moment = touch.at(1e-3 * i, method.radius_m);
    MethodTick tick;
    sample.time([&] { tick = proxy->tick(moment.centre_W - moment.force_N / stiffness_N_per_m); });
    rendered.truth_N.push_back(moment.force_N);
    rendered.force_N.emplace_back(stiffness_N_per_m * tick.force_u);
  }
  rendered.cost = Cost::of(sample);
  return rendered;
}

} // namespace palpate::lab
