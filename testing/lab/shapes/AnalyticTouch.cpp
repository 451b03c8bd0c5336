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

/// A straight part along the crease, and a loop of two straights and two half circles that touches it at both ends.
struct Lap
{
  static constexpr double straight_m = 0.05, bend_m = 0.015, speed_m_per_s = 0.08;
  double along_m = 0.0, up_m = 0.0; ///< along the crease from its middle, and up the wall from it
  double turned = 0.0;              ///< share of the straight part that is done

  explicit Lap(double way_m)
  {
    constexpr double half_m = straight_m / 2, round_m = pi * bend_m;
    const double bend = way_m < 2 * straight_m + round_m ? std::clamp((way_m - straight_m) / round_m, 0.0, 1.0)
                                                         : 1.0 + (way_m - 2 * straight_m - round_m) / round_m;
    const double back_m = std::clamp(way_m - straight_m - round_m, 0.0, straight_m);
    this->turned = std::min(1.0, way_m / straight_m);
    this->along_m = -half_m + straight_m * this->turned - back_m + bend_m * std::sin(pi * bend);
    this->up_m = bend_m * (1.0 - std::cos(pi * bend));
  }
  static constexpr double length_m() { return 2 * straight_m + 2 * pi * bend_m; }
  /// High on a wall, with space before it to come from.
  static constexpr double begin_m() { return 1.5 * straight_m + pi * bend_m; }
};

TouchMoment wedgeAt(double t_s, double radius_m)
{
  constexpr double half_rad = pi / 6;
  const Vec3 left(std::cos(half_rad), 0, std::sin(half_rad)), right(-std::cos(half_rad), 0, std::sin(half_rad));
  const double way_m = std::fmod(Lap::begin_m() + Lap::speed_m_per_s * t_s, 2 * Lap::length_m());
  const bool toRight = way_m < Lap::length_m(); // and over the right wall, of normal `right`
  const Lap lap(toRight ? way_m : way_m - Lap::length_m());
  const Vec3 up(toRight ? std::sin(half_rad) : -std::sin(half_rad), 0, std::cos(half_rad));
  const double turn = toRight ? lap.turned : 1.0 - lap.turned, push_N = pushAt_N(t_s);
  const Vec3 crease_W(0, lap.along_m, radius_m / std::sin(half_rad));
  return { crease_W + lap.up_m * up, push_N * ((1 - turn) * left + turn * right), push_N };
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
      return TouchMoment{ foot_W + radius_m * n, pushAt_N(t_s) * n, pushAt_N(t_s) };
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
      return TouchMoment{ (sphere_m + radius_m) * n, pushAt_N(t_s) * n, pushAt_N(t_s) };
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
      return TouchMoment{ torusPoint(u, v, tube_m + radius_m), pushAt_N(t_s) * n, pushAt_N(t_s) };
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
    moment.force_N -= mu * moment.pressed_N * way_W.normalized();
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
