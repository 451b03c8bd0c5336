// SPDX-License-Identifier: GPL-3.0-or-later
// Row 16: the unit of a scene and its place change nothing.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/methods/ContactMethod.h"
#include "testing/lab/methods/Textbook.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Probe.h"

namespace palpate::lab
{
namespace scale_experiment
{

/// A change of frame: x -> factor x + by.
struct Change
{
  double factor = 1.0;
  Vec3 by = Vec3::Zero();

  [[nodiscard]] Vec3 to(const Vec3& v) const { return this->factor * v + this->by; }
  [[nodiscard]] Vec3 from(const Vec3& v) const { return (v - this->by) / this->factor; }
};

/// Largest difference of the force [relative] to the scene as it is, over a slide.
double difference(const test::NoisySphere& sphere, const Change& change, double r, int ticks)
{
  TriangleMesh mesh = sphere.mesh();
  for (Vec3& v : mesh.vertices_W)
  {
    v = change.to(v);
  }
  test::Probe plain(test::sceneOf(sphere.mesh()), r, slideStart_W(sphere));
  test::Probe other(test::sceneOf(mesh), change.factor * r, change.to(slideStart_W(sphere)));
  double worst = 0.0;
  for (int i = 0; i < ticks; ++i)
  {
    const Vec3 p_W = slideOver(sphere, static_cast<std::size_t>(i)).p_W;
    plain.to(p_W);
    other.to(change.to(p_W));
    const Vec3 truth = plain.force(1.0);
    worst = std::max(worst, (change.from(other.x_W()) - p_W - truth).norm() / truth.norm());
  }
  return worst;
}

/// 2 deep under a plane, all in units of `factor`: the force of a method with a constant gap [relative].
double gapError(double factor)
{
  test::Random random(1);
  const World world(test::scaled(test::makeSheet({ 100, 100, 1, 1, 0.0 }, random), factor));
  const auto proxy = method("point-no-side").make(world);
  proxy->start(factor * Vec3(1, 2, 5));
  return std::abs(proxy->tick(factor * Vec3(1, 2, -2)).force_u.norm() / factor - 2) / 2;
}

} // namespace scale_experiment

void runScale(const Conditions& conditions, Table& table)
{
  using namespace scale_experiment;
  const test::NoisySphere sphere(5000, 1.0);
  const int ticks = conditions.pick(300, 3000, 30000);
  const double diagonal = 103.0 * std::sqrt(3.0); // of the box around a sphere of radius at most 51.5
  for (const double r : { 0.0, 1.0 })
  {
    const std::string name = r > 0 ? "god-object r=1mm" : "god-object r=0";
    for (const int digits : { -6, -3, 3, 6 })
    {
      table.atMost({ "scale=1e" + std::to_string(digits), name, "force error", "" },
        difference(sphere, { std::pow(10.0, digits), Vec3::Zero() }, r, ticks), 1e-9);
    }
    for (const int exponent : { -20, 20 })
    {
      table.within({ "scale=2^" + std::to_string(exponent), name, "force error", "" },
        difference(sphere, { std::ldexp(1.0, exponent), Vec3::Zero() }, r, ticks), 0.0, 0.0);
    }
    table.atMost({ "shift=1e6 diagonals", name, "force error", "" },
      difference(sphere, { 1.0, 1e6 * diagonal * Vec3(1, -1, 1).normalized() }, r, ticks), 1e-6);
  }
  for (const int digits : { -6, -3, 0, 3, 6 })
  {
    const double truth = gap_u / (2 * std::pow(10.0, digits)); // error by a gap at a depth of two units
    table.within({ "scale=1e" + std::to_string(digits), "point-no-side", "force error", "" },
      gapError(std::pow(10.0, digits)), truth, 1e-3 * truth + 1e-9);
  }
}

} // namespace palpate::lab
