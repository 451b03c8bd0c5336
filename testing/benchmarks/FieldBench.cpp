// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-field-bench: cost of one tick on an isosurface in sliding contact, beside plain trilinear probes of the same
// run, ours and VTK's; and cost of pulls of limited strength.
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "haptics/field/Smoothing.h"
#include "haptics/field/iso/IsoProxy.h"
#include "haptics/field/laws/Primitives.h"
#include "testing/lab/backends/ImageProbe.h"
#include "testing/support/CostSample.h"
#include "testing/support/Fields.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

struct Options
{
  int points = 256;
  std::size_t ticks = 30000;
  std::uint32_t passCap = 10;
  bool withAssertions = false;
};

constexpr double box_mm = 128.0, radius_mm = 40.0, depth_mm = 1.5, step_mm = 0.1;

double normal(Random& random)
{
  return std::sqrt(-2.0 * std::log(1.0 - random.uniform())) * std::cos(2.0 * std::numbers::pi * random.uniform());
}

struct Field
{
  std::string name;
  std::function<double(double r_mm, double h_mm)> function;
  double level = 0.0;
  int passes = 0;          ///< of smoothing
  double mostProbes = 0.0; ///< that a tick may cost (p50)
};

/// The hand winds around the ball, 0.1 mm a tick.
Vec3 handAt_mm(std::size_t tick)
{
  const double turn = step_mm * static_cast<double>(tick) / radius_mm;
  const double tilt = 0.5 * std::sin(0.11 * turn);
  const Vec3 direction(std::cos(turn) * std::cos(tilt), std::sin(turn) * std::cos(tilt), std::sin(tilt));
  return Vec3::Constant(0.5 * box_mm + 0.123) + (radius_mm - depth_mm) * direction;
}

struct Cost
{
  double p50_us, p99_us;
};

/// Of one probe, p50.
double probe_us(const lab::ImageProbe& probe, std::size_t ticks, double h_mm)
{
  CostSample sample(ticks);
  double sum = 0.0;
  constexpr int each = 16; // reading the clock costs as much as a probe
  sample.timeWarm(
    [&](auto call)
    {
      for (std::size_t i = 0; i < ticks; ++i)
      {
        const Vec3 p = handAt_mm(i);
        call(
          [&]
          {
            for (int k = 0; k < each; ++k)
            {
              sum += probe(p / h_mm + Vec3::Constant(0.01 * k));
            }
          });
      }
    });
  if (!std::isfinite(sum))
  {
    std::printf("  a probe found no value: this is no comparison\n");
  }
  return sample.quantile_us(0.5) / each;
}

bool benchmark(const Field& field, const Options& options)
{
  const double h_mm = box_mm / (options.points - 1);
  const Vec3 centre = Vec3::Constant(0.5 * box_mm + 0.123) / h_mm;
  const GridIndex size{ options.points, options.points, options.points };
  const FieldBlock brick(1, FieldBlockGrid{ size },
    { { FieldBlockRole::Scalar, "f",
      smoothed(sampledValues(size, [&](const Vec3& i) { return field.function(h_mm * (i - centre).norm(), h_mm); }),
        size, field.passes) } });
  const FieldBlockComponent scalar = brick.component(FieldBlockRole::Scalar);
  IsoPlan plan;
  plan.level = field.level;
  plan.passCap = options.passCap;
  std::size_t capped = 0, touching = 0;
  double deepest_mm = 0.0;
  CostSample sample(options.ticks);
  sample.timeWarm(
    [&](auto call)
    {
      IsoState state;
      capped = touching = 0;
      (void)moveIsoProxy(
        scalar, Vec3::Constant(h_mm), plan, (handAt_mm(0) - 0.5 * Vec3::Constant(box_mm)) / h_mm * 1.2 + centre, state);
      for (std::size_t i = 0; i < options.ticks; ++i)
      {
        IsoResult result;
        const Vec3 p = handAt_mm(i) / h_mm;
        call([&] { result = moveIsoProxy(scalar, Vec3::Constant(h_mm), plan, p, state); });
        capped += result.capped;
        touching += result.contacts > 0;
        deepest_mm = std::max(deepest_mm, result.pull_u.norm());
      }
    });
  const Cost tick{ sample.quantile_us(0.5), sample.quantile_us(0.99) };
  const double ours_us = probe_us(
    [&brick](const Vec3& index) { return brick.sample(FieldBlockRole::Scalar, index)->value; }, options.ticks, h_mm);
  std::printf("%-28s p50 %6.2f us p99 %6.2f us; of %zu ticks %zu touch, %zu capped; |x - p| at most %.2f mm\n",
    field.name.c_str(), tick.p50_us, tick.p99_us, options.ticks, touching, capped, deepest_mm);
  std::printf(
    "  beside a probe of %.3f us: p50 %.1f p99 %.1f\n", ours_us, tick.p50_us / ours_us, tick.p99_us / ours_us);
  if (const lab::ImageProbeMaker make = lab::imageProbe())
  {
    const double vtk_us = probe_us(make(size, brick.arrays().front().values), options.ticks, h_mm);
    std::printf("  beside one of vtkImageInterpolator of %.3f us: p50 %.1f p99 %.1f\n", vtk_us, tick.p50_us / vtk_us,
      tick.p99_us / vtk_us);
  }
  return tick.p50_us <= field.mostProbes * ours_us;
}

/// Lines, planes and points that pull towards where the proxy was; the hand 1 mm from there. Their p99 [us].
double benchmarkPulls(std::size_t count, std::size_t ticks, Random& random)
{
  constexpr std::array kinds{ PrimitiveKind::Point, PrimitiveKind::Line, PrimitiveKind::Plane, PrimitiveKind::Line };
  std::vector<std::vector<Primitive>> problems(1000);
  for (std::vector<Primitive>& pulls : problems)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      pulls.push_back({ kinds[i], random.uniform(0.05, 2.0), Vec3::Zero(), random.direction() });
    }
  }
  CostSample sample(ticks);
  double error_mm = 0.0;
  sample.timeWarm(
    [&](auto call)
    {
      for (std::size_t i = 0; i < ticks; ++i)
      {
        const Vec3 p = random.direction();
        PrimitiveSolution solution;
        call([&] { solution = solvePrimitives(problems[i % problems.size()], p, 1.0); });
        error_mm = std::max(error_mm, solution.error_u);
      }
    });
  std::printf("%zu pulls at one place %18s p50 %6.2f us p99 %6.2f us; certain to %.1e mm\n", count, "",
    sample.quantile_us(0.5), sample.quantile_us(0.99), error_mm);
  return sample.quantile_us(0.99);
}

/// The largest cost of a tick of four pulls among a hundred is asserted beside plain probes of the same run.
bool arePullsQuick(double p99_us, std::size_t ticks)
{
  constexpr int points = 64;
  constexpr double h_mm = box_mm / (points - 1), mostProbes = 110.0; // which are 10 us where a probe takes 0.09
  const auto brick = scalarFieldBlock(points, [](const Vec3& i) { return i.norm(); });
  const double plain_us =
    probe_us([&brick](const Vec3& index) { return brick->sample(FieldBlockRole::Scalar, index)->value; }, ticks, h_mm);
  std::printf("  beside a probe of %.3f us: p99 %.1f\n", plain_us, p99_us / plain_us);
  return p99_us <= mostProbes * plain_us;
}

std::vector<Field> fields(Random& random)
{
  const auto distance = [](double r, double) { return r; };
  const auto square = [](double r, double) { return r * r; };
  const auto noisy = [&random](double sigma)
  { return [&random, sigma](double r, double h) { return r + sigma * h * normal(random); }; };
  // Tissue of 1000 with bone of 2000 inside, edges blurred over 1 mm, 25 units of noise; the surface of the tissue.
  const auto scan = [&random](double r, double)
  {
    const auto edge = [r](double at_mm) { return 0.5 * std::erfc(r - at_mm); };
    return 1000.0 * edge(radius_mm) + 1000.0 * edge(25.0) + 25.0 * normal(random);
  };
  return { { "distance", distance, radius_mm, 0, 40.0 }, { "its square", square, radius_mm * radius_mm, 0, 40.0 },
    { "noise of 0.1 h", noisy(0.1), radius_mm, 0, 80.0 },
    { "noise of 0.5 h, one pass", noisy(0.5), radius_mm, 1, 80.0 }, { "like a scan", scan, 500.0, 0, 80.0 } };
}

} // namespace
} // namespace palpate::test

int main(int argc, char** argv)
{
  using namespace palpate::test;
  Options options;
  CLI::App app("what a tick on an isosurface costs");
  app.add_option("--points", options.points, "of the grid along each axis");
  app.add_option("--ticks", options.ticks, "1 ms each");
  app.add_option("--passes", options.passCap, "most of a tick");
  app.add_flag("--assert", options.withAssertions, "fail if a tick costs more probes than it may");
  CLI11_PARSE(app, argc, argv);
  Random random(testSeed(1690));
  bool within = true;
  for (const Field& field : fields(random))
  {
    within = benchmark(field, options) && within;
  }
  (void)benchmarkPulls(1, options.ticks, random);
  within = arePullsQuick(benchmarkPulls(4, options.ticks, random), options.ticks) && within;
  return within || !options.withAssertions ? 0 : 1;
}
