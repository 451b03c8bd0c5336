// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 82 to 84: numbers in space felt by a proxy, by mapping them to a force, by followers that step along a line, and
// as a mesh of triangles; and where sampled maps of force begin to shake. Lengths in voxels of a millimetre, k = 1
// N/mm.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>

#include "haptics/field/proxy/FieldProxy.h"
#include "haptics/tick/ForceRenderer.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/Felt.h"
#include "testing/lab/backends/MeshContour.h"
#include "testing/lab/simulation/ExactLoops.h"
#include "testing/support/Fields.h"
#include "testing/support/Meshes.h"

namespace palpate::lab
{
namespace fields_experiment
{

constexpr int points = 64;
constexpr double radius = 20.0;
const Vec3 middle = Vec3::Constant(0.5 * (points - 1) + 0.123);

/// The pull on a hand at p, times k [N].
using Method = std::function<Vec3(const Vec3& p)>;
using Scalar = std::function<double(const Vec3& p)>;

FieldBlock scalars(const Scalar& function)
{
  const GridIndex size{ points, points, points };
  return FieldBlock(
    1, FieldBlockGrid{ size }, { { FieldBlockRole::Scalar, "f", test::sampledValues(size, function) } });
}

Method isosurface(const FieldBlock& brick, double level)
{
  FieldPlan plan;
  plan.isosurface = true;
  plan.isovalue = level;
  return [&brick, plan, state = FieldState()](const Vec3& p) mutable
  { return moveFieldProxy(brick, plan, 1.0, p, state).pull_W; };
}

/// The depth by the value and the gradient where the hand is, without a memory.
Method mapped(const FieldBlock& brick, double level)
{
  return [&brick, level](const Vec3& p) -> Vec3
  {
    const auto at = brick.sample(FieldBlockRole::Scalar, p);
    const double square = at ? at->gradient_W.squaredNorm() : 0.0;
    return at && at->value < level && square > 0.0 ? Vec3((level - at->value) / square * at->gradient_W)
                                                   : Vec3(Vec3::Zero());
  };
}

/// A proxy that looks for the surface at every half cell of its path, and goes on along the tangent plane where it met
/// it: Salisbury and Tarr, ASME DSC 61, 1997.
Method halfCells(const FieldBlock& brick, double level)
{
  const auto isFree = [&brick, level](const Vec3& p)
  {
    const auto at = brick.sample(FieldBlockRole::Scalar, p);
    return !at || at->value >= level;
  };
  const auto march = [isFree](Vec3 free, const Vec3& to)
  {
    const int steps = static_cast<int>(std::ceil(2.0 * (to - free).norm()));
    const Vec3 step = steps > 0 ? Vec3((to - free) / steps) : Vec3(Vec3::Zero());
    for (int i = 0; i < steps; ++i)
    {
      if (isFree(free + step))
      {
        free += step;
        continue;
      }
      double low = 0.0, high = 1.0;
      constexpr int halvings = 40;
      for (int k = 0; k < halvings; ++k)
      {
        const double middle = 0.5 * (low + high);
        (isFree(free + middle * step) ? low : high) = middle;
      }
      return Vec3(free + low * step);
    }
    return to;
  };
  return [&brick, march, x = std::optional<Vec3>()](const Vec3& p) mutable -> Vec3
  {
    x = march(x.value_or(p), p);
    const auto met = *x != p ? brick.sample(FieldBlockRole::Scalar, *x) : std::nullopt;
    const double square = met ? met->gradient_W.squaredNorm() : 0.0;
    if (square > 0.0)
    {
      const Vec3 ahead = p - *x;
      x = march(*x, *x + ahead - ahead.dot(met->gradient_W) / square * met->gradient_W);
    }
    return *x - p;
  };
}

Method triangles(const Scalar& function, double level)
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = 1.0; // here a metre is a voxel
  parameters.safety = SafetyLimits::none();
  return [scene = test::sceneOf(meshContour()(points, function, level)), parameters, state = RendererState()](
           const Vec3& p) mutable
  {
    TickInput input;
    input.scene = scene.get();
    input.sample.pose_D.p = p;
    return renderTick(input, parameters, state).state.force_W;
  };
}

/// A path of the hand, and the force that is true at each of its places.
struct Play
{
  std::string name;
  std::vector<Vec3> way;
  std::function<Vec3(const Vec3& p)> truth;
};

/// Bounds of the error of a method, the least for a textbook method; neither: the error is told.
struct Limits
{
  std::optional<double> most = {}, least = {};
};
constexpr double felt = 1.0; ///< JND

/// The largest error in steps that a hand can feel, and the cost of a tick; a force that is gone went through.
void judge(const Play& play, const char* name, const Method& method, const Limits& limits, Table& table)
{
  double error = 0.0;
  Vec3 force = Vec3::Zero();
  const test::LeastCosts cost(costRuns,
    [&](auto call)
    {
      Method anew = method; // with the memory that it begins with
      for (const Vec3& p : play.way)
      {
        call([&] { force = anew(p); });
        const Vec3 truth = play.truth(p);
        error = truth.norm() > 0.0 ? std::max(error, (force - truth).norm() / (forceJnd * truth.norm())) : error;
      }
    });
  const bool gone = force.dot(play.truth(play.way.back())) <= 0.0;
  const Subject subject{ play.name, name, "error", "JND" };
  Row& row = limits.most ? table.atMost(subject, error, *limits.most) : table.info(subject, error);
  row.cost = Cost::of(cost);
  if (limits.least)
  {
    table.atLeast(subject, error, *limits.least);
  }
  const Subject outcome{ play.name, name, "outcome", outcomeUnit };
  const auto value = static_cast<double>(gone ? Outcome::Through : Outcome::Held);
  limits.most ? table.within(outcome, value, 0.0, 0.0) : table.info(outcome, value);
}

void judgeSurface(const Play& play, const Scalar& function, double level, double limit, const Limits& mapping,
  const Limits& stepping, Table& table)
{
  const FieldBlock brick = scalars(function);
  judge(play, "ours: isosurface", isosurface(brick, level), { limit }, table);
  judge(play, "force mapping", mapped(brick, level), mapping, table);
  judge(play, "steps of half a cell", halfCells(brick, level), stepping, table);
  if (meshContour() == nullptr)
  {
    table.absent({ play.name, "mesh of marching cubes", "error" });
    return;
  }
  judge(play, "mesh of marching cubes", triangles(function, level), {}, table);
}

/// The hand goes in and winds around the ball, 0.1 mm a tick.
Play ballPlay(int ticks)
{
  constexpr double depth = 1.5, step = 0.1;
  Play play{ "ball", { middle + Vec3(radius + 0.5, 0, 0) },
    [](const Vec3& p) -> Vec3
    {
      const Vec3 r = p - middle;
      return std::max(0.0, radius - r.norm()) * r.normalized();
    } };
  for (int i = 0; i < ticks; ++i)
  {
    const double turn = step * i / radius, tilt = 0.5 * std::sin(0.11 * turn);
    play.way.push_back(middle + (radius - depth) * Vec3(std::cos(turn) * std::cos(tilt),
                                                     std::sin(turn) * std::cos(tilt), std::sin(tilt)));
  }
  return play;
}

/// -1 in one layer of points and 0 in all others: the part below a level is a sheet around that layer.
double layer(const Vec3& i)
{
  return i.z() == 24.0 ? -1.0 : 0.0;
}

/// The hand goes 5 mm into that sheet from above: it is stopped at the upper side.
Play sheetPlay(const char* name, double level, int ticks)
{
  constexpr double deepest = 5.0;
  const double top = 25.0 + level;
  Play play{ name, {}, [top](const Vec3& p) -> Vec3 { return { 0, 0, std::max(0.0, top - p.z()) }; } };
  for (int i = 0; i <= ticks; ++i)
  {
    play.way.emplace_back(30.3, 31.2, top + 1.0 - (1.0 + deepest) * i / ticks);
  }
  return play;
}

Vec3 along(const Vec3& p)
{
  return Vec3(-p.y(), p.x(), 0.0).normalized();
}

/// A follower that stays beside the hand by steps along the line of directions through its last place; `slope` is the
/// direction of a step of that length from a place.
template<class Slope>
Method follower(const Slope& slope)
{
  return [slope, x = Vec3(radius, 0, 0)](const Vec3& p) mutable -> Vec3
  {
    constexpr int steps = 8;
    for (int i = 0; i < steps; ++i)
    {
      const double ahead = std::clamp((p - x).dot(along(x)), -1.0, 1.0);
      x += ahead * slope(x, ahead);
    }
    return x - p;
  };
}

/// Ten turns beside a circle of a flow that turns like a solid body, a millimetre outside.
void judgeVortex(int ticksATurn, Table& table)
{
  const Vec3 beside(radius + 1.0, 0, 0);
  Play play{ "ten turns", { Vec3(radius, 0, 0) }, [](const Vec3& p) -> Vec3 { return (radius / p.norm() - 1.0) * p; } };
  for (int i = 0; i <= 10 * ticksATurn; ++i)
  {
    play.way.push_back(Eigen::AngleAxisd(2.0 * std::numbers::pi * i / ticksATurn, Vec3::UnitZ()) * beside);
  }
  const GridIndex size{ points, points, points };
  const FieldBlockGrid grid{ size, Vec3::Ones(), { Vec3::Constant(-0.5 * (points - 1)), Quat::Identity() } };
  const FieldBlock brick(1, grid,
    { { FieldBlockRole::Vector, "v",
      test::sampledVectors(size,
        [&](const Vec3& i) -> Vec3
        {
          const Vec3 p = grid.toWorld(i);
          return { -p.y(), p.x(), 0.0 };
        }) } });
  FieldPlan plan;
  plan.follow_N = 1e3;
  judge(
    play, "ours: implicit midpoint",
    [&brick, plan, state = FieldState()](const Vec3& p) mutable
    { return moveFieldProxy(brick, plan, 1.0, p, state).pull_W; },
    { 1e-6 }, table);
  judge(play, "Euler", follower([](const Vec3& x, double) { return along(x); }), { {}, felt }, table);
  judge(play, "midpoint", follower([](const Vec3& x, double ahead) { return along(x + 0.5 * ahead * along(x)); }), {},
    table);
}

constexpr double mass_kg = 0.1, damping_Ns_per_m = 1.0, period_s = 1e-3;

/// Whether a small motion under a force held for a period, of the last two places, gets larger: by the longest steps of
/// the first and the last hundred ticks.
template<class Force>
bool grows(double damping, const Force& force_N, int ticks)
{
  constexpr int looked = 100;
  constexpr double far_m = 1e-4; // a hundred times the motion that it begins with
  const ExactStep step = ExactStep::of(mass_kg, damping, period_s);
  Eigen::Vector2d state(1e-6, 0.0);
  double last_m = 0.0, first_m = 0.0, end_m = 0.0;
  for (int i = 0; i < ticks; ++i)
  {
    const double force = force_N(state.x(), last_m);
    last_m = state.x();
    state = step.free * state + force * step.held;
    const double step_m = std::fabs(state.x() - last_m);
    if (!(step_m < far_m))
    {
      return true;
    }
    first_m = i < looked ? std::max(first_m, step_m) : first_m;
    end_m = i >= ticks - looked ? std::max(end_m, step_m) : end_m;
  }
  return end_m > first_m;
}

/// F = C grad f at the top of a Gaussian of height 1: its curvature is 1 / width^2.
void judgeForceMap(int ticks, Table& table)
{
  const ExactStep step = ExactStep::of(mass_kg, damping_Ns_per_m, period_s);
  const double most_N_per_m = threshold([&](double K) { return spectralRadius(step.onSpring(K)) > 1.0; }, 1e-9);
  for (const double width_m : { 0.002, 0.005, 0.02 })
  {
    const double scale = width_m * width_m; // so that the search is one of stiffness
    const double found =
      scale * threshold(
                [&](double C)
                {
                  return grows(
                    damping_Ns_per_m, [&](double x, double) { return -C * x * std::exp(-0.5 * x * x / scale); }, ticks);
                },
                1e-3);
    const Subject subject{ caseName({ { "width_mm", 1e3 * width_m } }), "force mapping", "shakes from C on", "N m" };
    table.within(subject, found, most_N_per_m * scale, 0.02 * most_N_per_m * scale);
  }
}

/// F = -B v of the last two places: stable to 2 m / T. The drag of a proxy is at most its strength at any rate.
void judgeViscosity(int ticks, Table& table)
{
  const double found = threshold(
    [&](double B)
    {
      return grows(
        0.0, [&](double x, double last) { return -B * (x - last) / period_s; }, ticks);
    },
    1e-3);
  const double truth = 2.0 * mass_kg / period_s;
  table.within({ "viscosity", "sampled", "shakes from B on", "N s/m" }, found, truth, 0.02 * truth);

  const GridIndex size{ 5, 5, 5 };
  const FieldBlockGrid grid{ size, Vec3::Ones(), { Vec3::Constant(-2.0), Quat::Identity() } };
  const FieldBlock brick(
    1, grid, { { FieldBlockRole::Scalar, "f", test::sampledValues(size, [](const Vec3& i) { return i.x(); }) } });
  FieldPlan plan;
  plan.drag_N = 1.0;
  FieldState field;
  const ExactStep step = ExactStep::of(mass_kg, damping_Ns_per_m, period_s);
  Eigen::Vector2d state(0.0, 1.0);
  double strongest_N = 0.0, fastest_m_per_s = 0.0;
  constexpr double K = 500.0;
  for (int i = 0; i < ticks; ++i)
  {
    const double force_N = K * moveFieldProxy(brick, plan, K, Vec3(state.x(), 0, 0), field).pull_W.x();
    state = step.free * state + force_N * step.held;
    strongest_N = std::max(strongest_N, std::fabs(force_N));
    fastest_m_per_s = std::max(fastest_m_per_s, std::fabs(state.y()));
  }
  table.within({ "viscosity", "ours: drag", "largest force", "N" }, strongest_N, 1.0, 1e-9);
  table.atMost({ "viscosity", "ours: drag", "fastest, thrown at 1 m/s", "m/s" }, fastest_m_per_s, 1.0);
  table.atMost({ "viscosity", "ours: drag", "speed at the end", "m/s" }, std::fabs(state.y()), 1e-6);
}

} // namespace fields_experiment

void runFields(const Conditions& conditions, Table& table)
{
  using namespace fields_experiment;
  const int ticks = conditions.pick(2000, 20000, 200000);
  // Trilinear values of a distance are larger by h^2 / 8 times its Laplacian, so the surface is h^2 / 4 R inside, and
  // its creases, of h / R, let the proxy slip by as much of the depth.
  judgeSurface(
    ballPlay(ticks), [](const Vec3& i) { return (i - middle).norm(); }, radius,
    (1.0 / (4.0 * radius * 1.5) + 1.0 / radius) / forceJnd, {}, {}, table);
  judgeSurface(sheetPlay("thin sheet", -0.5, ticks), layer, -0.5, 1e-6, { {}, felt }, {}, table);
  // A fiftieth of a voxel thick: between two steps of half a cell.
  judgeSurface(sheetPlay("thinner sheet", -0.99, ticks), layer, -0.99, 1e-6, { {}, felt }, { {}, felt }, table);
  judgeVortex(conditions.pick(400, 1250, 1250), table);
  judgeForceMap(conditions.pick(4000, 20000, 20000), table);
  judgeViscosity(conditions.pick(4000, 20000, 20000), table);
}

} // namespace palpate::lab
