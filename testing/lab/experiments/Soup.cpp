// SPDX-License-Identifier: GPL-3.0-or-later
// Row 15: meshes as they come. Duplicates, flips, triangles without area, gaps, fins, triangles that cross.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/methods/ContactMethod.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Probe.h"

namespace palpate::lab
{
namespace soup_experiment
{

std::string oursWith(double r)
{
  return r > 0 ? "god-object r=1mm" : "god-object r=0";
}

/// The counts that cleaning must report: of every four damages one is five copies, one a flip, one has no area, one is
/// not finite.
void judgeReport(const TriangleMesh& good, const TriangleMesh& damaged, Table& table)
{
  const CleanReport report = cleanMesh(damaged).report;
  const auto quarter = static_cast<double>(good.triangles.size()) / 4;
  const std::string caseName = "damaged sphere", method = "cleaning";
  table.within(
    { caseName, method, "duplicates reported", "" }, static_cast<double>(report.duplicate), 6 * quarter, 0.0);
  table.within(
    { caseName, method, "triangles without area reported", "" }, static_cast<double>(report.collinear), quarter, 0.0);
  table.within(
    { caseName, method, "triangles not finite reported", "" }, static_cast<double>(report.nonFinite), quarter, 0.0);
}

void runDamage(const Conditions& conditions, test::Random& random, Table& table)
{
  const test::NoisySphere sphere(2000, 1.0);
  const TriangleMesh damaged = test::withDefects(sphere.mesh(), random);
  judgeReport(sphere.mesh(), damaged, table);
  const int ticks = conditions.pick(500, 5000, 50000);
  for (const double r : { 0.0, 1.0 })
  {
    test::Probe onGood(test::sceneOf(sphere.mesh()), r, slideStart_W(sphere));
    test::Probe onDamaged(test::sceneOf(damaged), r, slideStart_W(sphere));
    int changed = 0;
    for (int i = 0; i < ticks; ++i)
    {
      const Vec3 p_W = slideOver(sphere, static_cast<std::size_t>(i)).p_W;
      onGood.to(p_W);
      onDamaged.to(p_W);
      changed += onDamaged.x_W() != onGood.x_W();
    }
    table.within({ "damaged sphere", oursWith(r), "ticks with another force", "" }, changed, 0.0, 0.0);
  }
  // A flipped face pulls nothing out: where it is the nearest one, all force is missing.
  const auto good = method("penalty").make(World(sphere.mesh())), bad = method("penalty").make(World(damaged));
  double worst = 0.0;
  for (int i = 0; i < ticks; ++i)
  {
    const Vec3 p_W = slideOver(sphere, static_cast<std::size_t>(i)).p_W, truth = good->tick(p_W).force_u;
    worst = std::max(worst, (bad->tick(p_W).force_u - truth).norm() / truth.norm());
  }
  table.atLeast({ "damaged sphere", "penalty", "force error", "" }, worst, 1.0);
}

/// Over a gap and back to its middle: how deep the ball sinks [m], and whether anything fell through.
struct Bridge
{
  double deepest_m = 0.0, middle_m = 0.0;
  bool fell = false;
};

Bridge cross(const TriangleMesh& mesh, double r)
{
  test::Probe ball(test::sceneOf(mesh), r, { -0.01, 0.001, 0.005 });
  Bridge seen;
  for (int i = 0; i <= 200; ++i)
  {
    ball.to({ -0.01 + 1e-4 * i, 0.001, -0.001 });
    seen.deepest_m = std::max(seen.deepest_m, r - ball.x_W().z());
  }
  ball.along({ 0, 0.001, -0.001 }, 100);
  seen.middle_m = r - ball.x_W().z();
  seen.fell = seen.deepest_m > 0.9e-3;
  return seen;
}

void runGaps(test::Random& random, Table& table)
{
  constexpr double r = 1e-3;
  for (const double gap_m : { 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 1.9e-3 })
  {
    char caseName[32];
    std::snprintf(caseName, sizeof caseName, "gap=%gm", gap_m);
    const TriangleMesh mesh = test::makeCracked(gap_m, random);
    const double sagitta_m = r - std::sqrt(r * r - gap_m * gap_m / 4);
    const Bridge ball = cross(mesh, r);
    table.within({ caseName, oursWith(r), "falls", "" }, ball.fell, 0.0, 0.0);
    table.within({ caseName, oursWith(r), "sunk at the middle", "m" }, ball.middle_m, sagitta_m, 1e-9);
    table.within({ caseName, oursWith(r), "sunk, most", "m" }, ball.deepest_m, sagitta_m / 2, sagitta_m / 2 + 1e-12);
    // A point that is led over the gap falls in: a ball does not, by its radius.
    test::Probe point(test::sceneOf(mesh), 0.0, { 0, 0.001, 0.005 });
    point.to({ 0, 0.001, -0.001 });
    table.within({ caseName, oursWith(0.0), "falls", "" }, point.x_W().z() < 0, 1.0, 0.0);
  }
}

void runFin(Table& table)
{
  for (const double r : { 0.0, 0.1 })
  {
    test::Probe ball(test::sceneOf(test::makeFin()), r, { -0.7, 0.1, 0.4 });
    ball.along({ 0.3, 0.2, -0.05 }, 20);
    table.atMost(
      { "fin", r > 0 ? "god-object r=0.1" : oursWith(0.0), "distance from the rest between floor and fin", "u" },
      (ball.x_W() - Vec3(-r, 0.2, r)).norm(), 1e-12);
  }
}

/// Random segments among triangles that cross each other, judged in exact arithmetic.
void runCrossing(const Conditions& conditions, test::Random& random, double r, Table& table)
{
  const TriangleMesh mesh = test::makeSoup(r > 0 ? 150 : 400, 10.0, random);
  // Slivers 1e-6 wide: the normal of a face is known to rounding times 1e7, so the distance to 1e-16 * 10 * 1e7.
  test::PathChecker checker(cleanMesh(mesh).mesh, r, 1e-8);
  test::Probe ball(test::sceneOf(mesh), r, Vec3::Zero(), &checker);
  Vec3 goal_W = Vec3::Zero(), p_W = Vec3::Zero();
  for (int i = 0; i < conditions.pick(1000, 10000, 100000); ++i)
  {
    goal_W = i % 50 == 0 ? random.inCube(10.0) : goal_W;
    p_W += 0.05 * (goal_W - p_W);
    ball.to(p_W);
  }
  table.within({ "crossing triangles", r > 0 ? "god-object r=0.3" : oursWith(r), "paths through a triangle", "" },
    !ball.finding().empty(), 0.0, 0.0);
}

} // namespace soup_experiment

void runSoup(const Conditions& conditions, Table& table)
{
  using namespace soup_experiment;
  test::Random random(conditions.seed + 91);
  runDamage(conditions, random, table);
  runGaps(random, table);
  runFin(table);
  runCrossing(conditions, random, 0.0, table);
  runCrossing(conditions, random, 0.3, table);
}

} // namespace palpate::lab
