// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-soft-bench: cost of a snapshot of a soft body for its worker, beside one solve with the body's factor, and of
// a tick for the servo, beside one on a rigid body.
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

#include <CLI/CLI.hpp>

#include "haptics/compliance/body/KeptInverse.h"
#include "haptics/compliance/snapshot/SnapshotMaker.h"
#include "haptics/contact/GodObject.h"
#include "testing/haptics/compliance/SoftScenes.h"
#include "testing/support/CostSample.h"

namespace palpate::test
{
namespace
{

/// Ticks on a soft body that one on a rigid body may be: twice the number seen.
constexpr double mostOfRigid = 32.0;

struct Options
{
  int snapshots = 10;
  bool small = false, withAssertions = false;
};

struct Case
{
  std::string name;
  int cells = 12; ///< along the block
  ElasticModel model = ElasticModel::Linear;
  ElementKind element = ElementKind::Linear;
  Factoring factoring = Factoring::EachStep;
  int newtonSteps = 1;
  double goal_Hz = 0.0;    ///< 0: none is asked for
  double mostSolves = 0.0; ///< that a snapshot may cost (p50)
  bool kept = false;       ///< answers from a kept inverse
};

double residentMB()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1e-3 * static_cast<double>(usage.ru_maxrss);
}

std::uint32_t triangleAt(const SoftSurface& surface, const Vec3& p_W)
{
  std::uint32_t nearest = 0;
  const auto off = [&](std::uint32_t t) { return (surface.rest_W[surface.triangles[t][0]] - p_W).norm(); };
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
  {
    nearest = off(t) < off(nearest) ? t : nearest;
  }
  return nearest;
}

/// A ball goes to and fro over the block, 20 mm to either side, at .1 m/s, and presses with 2 and with 3 N in turn, the
/// second time askew.
SnapshotRequest requestAt(const SoftSurface& surface, int snapshot, double period_s)
{
  constexpr double speed = 0.1, aside_u = 0.02;
  const double gone_u = std::fmod(speed * period_s * snapshot, 4.0 * aside_u);
  SnapshotRequest request;
  request.ball_W = middleOfPad() + Vec3(std::abs(gone_u - 2.0 * aside_u) - aside_u, 0.0, 0.0);
  request.velocity_u_per_s = Vec3(gone_u < 2.0 * aside_u ? -speed : speed, 0.0, 0.0);
  request.radius_u = 0.005;
  request.period_s = period_s;
  request.forceAt.push_back(
    { surface.triangles[triangleAt(surface, request.ball_W)], Vec3::Constant(1.0 / 3.0), request.ball_W });
  request.force_N.emplace_back(0.3 * (snapshot % 2), 0.0, snapshot % 2 == 0 ? -2.0 : -3.0);
  return request;
}

/// Condensed as far as it goes, around the middle of the pad.
std::shared_ptr<const KeptInverse> keptInverse(
  const SoftBody& body, const SoftSurface& surface, const ProgramClock& clock)
{
  auto kept = std::make_shared<KeptInverse>(body, borderNodesFrom(surface, middleOfPad()));
  CostSample parts(KeptInverse::mostNodes, clock);
  while (kept->known() < kept->size())
  {
    parts.time([&] { (void)kept->condenseNext(); });
  }
  std::printf("kept: %zu nodes, %zu at once in p50 %.1f ms p99 %.1f ms\n", kept->size(), KeptInverse::nodesAtOnce,
    1e-3 * parts.quantile_us(0.5), 1e-3 * parts.quantile_us(0.99));
  return kept;
}

/// Whether a snapshot costs no more solves than it may.
bool benchmark(const Case& c, const Options& options)
{
  SoftBodyInput input = pad(c.cells);
  input.model = c.model;
  input.element = c.element;
  SoftBodyResult made = makeSoftBody(input);
  SoftBody& body = *made.body;
  body.factorsBe(c.factoring);
  const SoftSurface surface = makeSoftSurface(body, made.checked.mesh);
  SnapshotMaker maker(body, surface);
  const ProgramClock clock; // a second thread helps
  maker.answerBy(c.kept ? keptInverse(body, surface, clock) : nullptr);
  CostSample snapshots(static_cast<std::size_t>(options.snapshots), clock);
  CostSample walls(static_cast<std::size_t>(options.snapshots));
  CostSample solves(static_cast<std::size_t>(options.snapshots), clock);
  const Eigen::VectorXd load = Eigen::VectorXd::Constant(body.displacement().size(), 1e-3);
  std::size_t vertices = 0;
  double sum = 0.0;
  const double period_s = c.goal_Hz > 0.0 ? 1.0 / c.goal_Hz : 0.04;
  for (int i = -1; i < options.snapshots; ++i)
  {
    std::shared_ptr<const ComplianceSnapshot> snapshot;
    const auto make = [&] { snapshot = maker.make(requestAt(surface, i + 1, period_s), c.newtonSteps); };
    if (i < 0)
    {
      make(); // to be warm
      continue;
    }
    walls.time([&] { snapshots.time(make); });
    solves.time([&] { sum += body.linearAnswer(load).sum(); });
    vertices = snapshot->near.size();
  }
  const double packet_ms = 1e-3 * snapshots.quantile_us(0.5), wall_ms = 1e-3 * walls.quantile_us(0.5),
               solve_ms = 1e-3 * solves.quantile_us(0.5);
  std::printf("%-44s %6zu nodes, %3zu vertices: processor time of a snapshot p50 %7.2f ms p99 %7.2f ms, by the wall "
              "p50 %7.2f ms, %6.1f Hz",
    c.name.c_str(), input.mesh.vertices_W.size(), vertices, packet_ms, 1e-3 * snapshots.quantile_us(0.99), wall_ms,
    1e3 / wall_ms);
  std::printf("%s", c.goal_Hz > 0.0 ? (" (goal " + std::to_string(static_cast<int>(c.goal_Hz)) + " Hz)").c_str() : "");
  std::printf("; a solve %.3f ms, ratio %.1f; factor %.0f MB, all %.0f MB; %zu factorings%s\n", solve_ms,
    packet_ms / solve_ms, 1e-6 * static_cast<double>(body.factorBytes()), residentMB(), body.factorings(),
    std::isfinite(sum) ? "" : "; NO ANSWER");
  return packet_ms <= c.mostSolves * solve_ms;
}

/// Cost of a tick on a body for the servo, beside the same tick on the body as it would be rigid.
bool tickCosts(const char* name, SoftPad pad, double friction, double mostRigid)
{
  constexpr int passes = 5, ticks = 600;
  SoftScene s(std::move(pad));
  s.plan.friction = { friction, friction };
  CostSample soft(passes * ticks), rigid(passes * ticks);
  for (int pass = 0; pass < passes; ++pass)
  {
    GodObjectState hard;
    s.state = {};
    for (int tick = 0; tick < ticks; ++tick)
    {
      const Vec3 p_W = wayOver(tick);
      soft.time([&] { (void)s.move(p_W); });
      rigid.time([&] { (void)moveGodObject(s.scene, s.plan, p_W, hard); });
    }
  }
  const double ratio = soft.quantile_us(0.5) / rigid.quantile_us(0.5);
  std::printf("%-44s a tick p50 %.1f us p99 %.1f us; rigid p50 %.1f us, ratio %.1f\n", name, soft.quantile_us(0.5),
    soft.quantile_us(0.99), rigid.quantile_us(0.5), ratio);
  return ratio <= mostRigid;
}

} // namespace
} // namespace palpate::test

int main(int argc, char** argv)
{
  using namespace palpate;
  using namespace palpate::test;
  Options options;
  CLI::App app("what a snapshot of a soft body costs its worker");
  app.add_option("--snapshots", options.snapshots, "of each body");
  app.add_flag("--small", options.small, "without what takes minutes");
  app.add_flag("--assert", options.withAssertions, "fail if a snapshot costs more solves than it may");
  CLI11_PARSE(app, argc, argv);
  constexpr auto hooke = ElasticModel::Linear, rubber = ElasticModel::NeoHookean;
  constexpr auto linear = ElementKind::Linear, smoothed = ElementKind::EdgeSmoothed;
  // At most twice the solves that were seen with the plain BLAS; with a better one a snapshot costs half as many.
  std::vector<Case> cases{ { "linear law", 12, hooke, linear, Factoring::EachStep, 1, 0.0, 20.0 },
    { "neo-Hookean, 2 steps", 12, rubber, linear, Factoring::EachStep, 2, 20.0, 200.0 },
    { "neo-Hookean, 2 steps, edge-smoothed", 12, rubber, smoothed, Factoring::EachStep, 2, 0.0, 240.0 },
    { "linear law, a kept inverse", 18, hooke, linear, Factoring::EachStep, 1, 200.0, 0.5, true },
    { "neo-Hookean, 2 steps, an old factor", 18, rubber, linear, Factoring::WhenOld, 2, 30.0, 40.0 } };
  if (!options.small)
  {
    cases.push_back({ "neo-Hookean, 2 steps", 18, rubber, linear, Factoring::EachStep, 2, 0.0, 240.0 });
    // First: the resident memory is the most that ever was.
    cases.insert(cases.begin(), { "linear law", 28, hooke, linear, Factoring::EachStep, 1, 20.0, 25.0 });
    cases.insert(cases.begin() + 1,
      { "linear law, a kept inverse", 28, hooke, linear, Factoring::EachStep, 1, 200.0, 0.25, true });
  }
  bool within = true;
  for (const Case& c : cases)
  {
    within = benchmark(c, options) && within;
  }
  within = tickCosts("flat", SoftPad(10, 2.0, ElementKind::Linear), 0.0, mostOfRigid) && within;
  within = tickCosts("bumps with friction", bumpyPad(), 0.2, mostOfRigid) && within;
  return within || !options.withAssertions ? 0 : 1;
}
