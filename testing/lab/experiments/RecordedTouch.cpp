// SPDX-License-Identifier: GPL-3.0-or-later
// Row 56: touches known by a formula, pushed in by force / stiffness and rendered, give their forces back.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/methods/GodObjectMethod.h"
#include "testing/lab/shapes/AnalyticTouch.h"

namespace palpate::lab
{
namespace recorded_touch_experiment
{

struct TouchError
{
  double rms = 0.0;           ///< of the force's vector, relative to the RMS of the true force
  double direction_rad = 0.0; ///< largest
};

TouchError errorOf(const RenderedTouch& touch)
{
  TouchError error;
  double wrong = 0.0, all = 0.0;
  for (std::size_t i = 0; i < touch.truth_N.size(); ++i)
  {
    const Vec3 &truth_N = touch.truth_N[i], &force_N = touch.force_N[i];
    wrong += (force_N - truth_N).squaredNorm();
    all += truth_N.squaredNorm();
    const double angle_rad = std::atan2(force_N.cross(truth_N).norm(), force_N.dot(truth_N));
    error.direction_rad = std::max(error.direction_rad, angle_rad);
  }
  error.rms = std::sqrt(wrong / all);
  return error;
}

void judge(const AnalyticTouch& touch, int ticks, Table& table)
{
  constexpr double degree = 180.0 / std::numbers::pi;
  const std::string name = "body=" + touch.name;
  for (const char* const ours : { "god-object r=0", "god-object r=1mm" })
  {
    const RenderedTouch rendered = render(touch, method(ours), ticks);
    const TouchError error = errorOf(rendered);
    table.atMost({ name, ours, "force vector error, RMS" }, error.rms, 0.01).cost = rendered.cost;
    // Where facets are flat as the body is, the error is rounding.
    table.atMost({ name, ours, "direction error, largest", "deg" }, degree * error.direction_rad,
      degree * std::max(touch.tilt_rad, 1e-9));
  }
}

/// A rough body: exact where the path is straight on flat ground, elsewhere in the limit of small steps and of a depth
/// that is small beside the bends of path and body.
void judgeRubbed(const AnalyticTouch& smooth, int ticks, Table& table)
{
  constexpr double mu = 0.3;
  const AnalyticTouch touch = rubbed(smooth, mu);
  const std::string name = "body=" + touch.name + " mu=0.3";
  for (const double radius_m : { 0.0, 1e-3 })
  {
    const MethodKind ours{ radius_m == 0.0 ? "god-object r=0" : "god-object r=1mm", radius_m,
      [radius_m](const World& world) {
        return std::make_unique<GodObjectMethod>(world, radius_m, FrictionPlan{ mu, mu });
      } };
    const RenderedTouch rendered = render(touch, ours, ticks);
    table.atMost({ name, ours.name, "force vector error, RMS" }, errorOf(rendered).rms, 0.03).cost = rendered.cost;
  }
  // Rendered without friction all of it is missing: mu / sqrt(1 + mu^2).
  const RenderedTouch slippery = render(touch, method("god-object r=0"), ticks);
  table.atLeast(
    { name, "without friction", "force vector error, RMS" }, errorOf(slippery).rms, 0.95 * mu / std::sqrt(1 + mu * mu));
}

} // namespace recorded_touch_experiment

void runRecordedTouch(const Conditions& conditions, Table& table)
{
  using namespace recorded_touch_experiment;
  const int ticks = conditions.pick(4000, 20000, 200000);
  test::Random random(conditions.seed);
  const AnalyticTouch plane = touchPlane(random);
  judge(plane, ticks, table);
  judgeRubbed(plane, ticks, table);
  const AnalyticTouch wedge = touchWedge();
  judge(wedge, ticks, table);
  judgeRubbed(wedge, ticks, table);
  // In a narrow wedge the nearest face knows nothing of the other one.
  const RenderedTouch nearest = render(wedge, method("penalty"), ticks);
  table.atLeast({ "body=wedge", "penalty", "force vector error, RMS" }, errorOf(nearest).rms, 0.1).cost = nearest.cost;
  conditions.progress(0.3);
  const AnalyticTouch sphere = touchSphere(conditions.pick(6, 7, 7));
  judge(sphere, ticks, table);
  judgeRubbed(sphere, ticks, table);
  conditions.progress(0.6);
  const std::uint32_t cells = conditions.pick(320U, 600U, 600U);
  const AnalyticTouch torus = touchTorus(cells, cells);
  judge(torus, ticks, table);
  judgeRubbed(torus, ticks, table);
}

} // namespace palpate::lab
