// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 70 to 72: constitutive models far from rest: turned, pulled and pressed.
#include <cmath>
#include <numbers>

#include "haptics/compliance/material/ElasticLaw.h"
#include "testing/lab/Experiments.h"

namespace palpate::lab
{
namespace materials_large_experiment
{

constexpr double young_Pa = 20e3;

ElasticModuli moduli()
{
  return moduliOf(young_Pa, 0.4, 1.0).value;
}

/// Saint-Venant & Kirchhoff's law of a bar with free sides, over E: its sides narrow so that only this is left.
double ofGreen(double stretch)
{
  return 0.5 * (stretch * stretch * stretch - stretch);
}

/// Stress along a bar with free sides over E: the stretch of its sides by bisection.
double pulled(ElasticModel model, double stretch)
{
  double low = 0.3;
  double high = 2.5;
  for (int i = 0; i < 200; ++i)
  {
    const double side = 0.5 * (low + high);
    const Mat3 f = Vec3(stretch, side, side).asDiagonal();
    (stressOf(model, moduli(), f)(1, 1) > 0.0 ? high : low) = side;
  }
  return stressOf(model, moduli(), Vec3(stretch, low, low).asDiagonal())(0, 0) / young_Pa;
}

double turned(ElasticModel model, double degrees)
{
  const Mat3 f =
    Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  return stressOf(model, moduli(), f).norm() / young_Pa;
}

} // namespace materials_large_experiment

void runMaterialsLarge(const Conditions&, Table& table)
{
  using namespace materials_large_experiment;
  for (double degrees = 0.0; degrees <= 180.0; degrees += 30.0)
  {
    const std::string name = caseName({ { "turn_deg", degrees } });
    table.atMost({ name, "co-rotational", "stress of an unstrained body over E" },
      turned(ElasticModel::CoRotational, degrees), 1e-9);
    table.atMost(
      { name, "neo-Hookean", "stress of an unstrained body over E" }, turned(ElasticModel::NeoHookean, degrees), 1e-9);
    if (degrees >= 30.0)
    {
      table.atLeast(
        { name, "linear", "stress of an unstrained body over E" }, turned(ElasticModel::Linear, degrees), 0.2);
    }
  }
  for (const double stretch : { 0.5, 0.7, 0.99, 1.01, 1.5, 2.0 })
  {
    const std::string name = caseName({ { "stretch", stretch } });
    table.within({ name, "linear", "stress over E" }, pulled(ElasticModel::Linear, stretch), stretch - 1.0, 1e-9);
    table.within(
      { name, "co-rotational", "stress over E" }, pulled(ElasticModel::CoRotational, stretch), stretch - 1.0, 1e-9);
    const double off = std::abs(pulled(ElasticModel::NeoHookean, stretch) / (stretch - 1.0) - 1.0);
    const Subject subject{ name, "neo-Hookean", "off Hooke's law by" };
    std::abs(stretch - 1.0) < 0.02 ? table.atMost(subject, off, 0.015) : table.info(subject, off);
  }
  // Pressed from where the law of Green's strain is strongest, 1 / sqrt(3), on to .3.
  const double strongest = 1.0 / std::sqrt(3.0);
  const std::string name = caseName({ { "from", strongest }, { "to", 0.3 } });
  const double collapses = ofGreen(0.3) / ofGreen(strongest);
  table.atLeast({ name, "Green's strain", "force lost" }, 1.0 - collapses, 0.2);
  const double holds = pulled(ElasticModel::NeoHookean, 0.3) / pulled(ElasticModel::NeoHookean, strongest);
  table.atLeast({ name, "neo-Hookean", "force over that before" }, holds, 1.0);
}

} // namespace palpate::lab
