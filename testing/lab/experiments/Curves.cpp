// SPDX-License-Identifier: GPL-3.0-or-later
// Curves in space: fibres, the inside of a bend, a net, a spring at speed.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/support/Curves.h"

namespace palpate::lab
{
namespace curves_experiment
{

using test::Tubes;

constexpr double stiffness_N_per_m = 1000.0, tick_s = 1e-3;

/// A hand in a scene of tubes, by either method.
class Touch
{
public:
  virtual ~Touch() = default;
  /// Force for a device at p [N].
  virtual Vec3 to(const Vec3& p_W) = 0;
};

class GodObjectTouch final : public Touch
{
public:
  GodObjectTouch(const std::vector<Tubes>& tubes, double radius_m) : scene_(test::sceneOf(tubes))
  {
    this->plan_.radius_u = radius_m;
  }
  Vec3 to(const Vec3& p_W) override
  {
    const ContactResult result = moveGodObject(*this->scene_, this->plan_, p_W, this->state_, this->sink);
    return stiffness_N_per_m * (result.proxy_W - p_W);
  }
  [[nodiscard]] const Vec3& proxy_W() const { return this->state_.x_W; }

  PathSink* sink = nullptr;

private:
  std::shared_ptr<const Scene> scene_;
  ContactPlan plan_;
  GodObjectState state_;
};

/// The force of a distance field: out of the nearest piece, as far as the device is inside.
class PenaltyTouch final : public Touch
{
public:
  PenaltyTouch(const std::vector<Tubes>& tubes, double radius_m) : tubes_(tubes), radius_m_(radius_m) {}
  Vec3 to(const Vec3& p_W) override
  {
    const double inside_m = this->radius_m_ - test::clearance(this->tubes_, p_W);
    if (inside_m <= 0.0)
    {
      return Vec3::Zero();
    }
    constexpr double h = 1e-7; // the field's slope by central differences, as from a sampled field
    Vec3 slope;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3 step = h * Vec3::Unit(k);
      slope[k] = (test::clearance(this->tubes_, p_W + step) - test::clearance(this->tubes_, p_W - step)) / (2 * h);
    }
    return stiffness_N_per_m * inside_m * slope;
  }

private:
  const std::vector<Tubes>& tubes_;
  double radius_m_;
};

std::unique_ptr<Touch> makeTouch(const std::string& method, const std::vector<Tubes>& tubes, double radius_m)
{
  if (method == "penalty")
  {
    return std::make_unique<PenaltyTouch>(tubes, radius_m);
  }
  return std::make_unique<GodObjectTouch>(tubes, radius_m);
}

/// Round and along a straight fibre: K (R - distance from the axis), straight out.
void judgeFibre(double radius_m, Table& table)
{
  const double thick_m = 1e-3, R = thick_m + std::max(radius_m, 1e-3 * thick_m);
  const std::vector<Tubes> fibre{ test::tubeThrough({ { -0.05, 0, 0 }, { 0.05, 0, 0 } }, thick_m) };
  GodObjectTouch touch(fibre, radius_m);
  touch.to({ -0.04, 0, 2 * R });
  double worst_N = 0.0;
  for (int i = 0; i <= 2000; ++i)
  {
    const double angle_rad = 4 * std::numbers::pi * i / 2000, depth_m = 0.9 * R * i / 2000;
    const Vec3 out(0, std::sin(angle_rad), std::cos(angle_rad)), along(-0.04 + 4e-5 * i, 0, 0);
    const Vec3 force_N = touch.to(along + (R - depth_m) * out);
    worst_N = std::max(worst_N, (force_N - stiffness_N_per_m * depth_m * out).norm());
  }
  const std::string method = radius_m > 0.0 ? "god-object r=1mm" : "god-object r=0";
  table.atMost({ "fibre", method, "force error", "N" }, worst_N, 1e-9);
}

/// Across the bisector of a right bend, from inside: two cylinders at once, (R - a, R - b); a field knows one of them.
double largestStepInBend_N(const std::string& method, double radius_m, double thick_m, double R, double step_m)
{
  const std::vector<Tubes> bend{ test::tubeThrough({ { -0.05, 0, 0 }, { 0, 0, 0 }, { 0, 0.05, 0 } }, thick_m) };
  const auto touch = makeTouch(method, bend, radius_m);
  touch->to({ -2 * R, 2 * R, 0 });
  double largest_N = 0.0;
  Vec3 before_N = touch->to({ -0.7 * R, 0.3 * R, 0 });
  for (int i = 1; 0.3 * R + step_m * i < 0.7 * R; ++i)
  {
    const double way = step_m * (i - 0.5); // never on the bisector itself, where a field has no slope
    const Vec3 force_N = touch->to({ -0.7 * R + way, 0.3 * R + way, 0 });
    largest_N = std::max(largest_N, (force_N - before_N).norm());
    before_N = force_N;
  }
  return largest_N;
}

void judgeBend(Table& table)
{
  constexpr double step_m = 1e-6, thick_m = 1e-3;
  const double along_N = stiffness_N_per_m * step_m * std::numbers::sqrt2; // of a step that is as long
  for (const double radius_m : { 0.0, 1e-3 })
  {
    const double R = thick_m + std::max(radius_m, 1e-3 * thick_m);
    table.within(
      { "bend from inside", radius_m > 0.0 ? "god-object r=1mm" : "god-object r=0", "largest force step", "N" },
      largestStepInBend_N("god-object", radius_m, thick_m, R, step_m), along_N, 1e-9);
  }
  // At the bisector, half a radius deep in both, the force K R / 2 turns from one cylinder's direction to the other's.
  const double R = 2e-3;
  table.within({ "bend from inside", "penalty", "largest force step", "N" },
    largestStepInBend_N("penalty", 1e-3, thick_m, R, step_m), stiffness_N_per_m * 0.5 * R * std::numbers::sqrt2,
    4 * along_N);
}

/// A square net of fibres in the plane z = 0.
std::vector<Tubes> net(double spacing_m, int fibres, double thick_m)
{
  std::vector<Tubes> tubes(1);
  tubes[0].radius_u = thick_m;
  PolyLines& lines = tubes[0].curves;
  const double half = 0.5 * spacing_m * (fibres - 1);
  for (int i = 0; i < fibres; ++i)
  {
    const double at = -half + spacing_m * i;
    const auto first = static_cast<std::uint32_t>(lines.points_W.size());
    lines.points_W.insert(
      lines.points_W.end(), { { at, -half, 0 }, { at, half, 0 }, { -half, at, 0 }, { half, at, 0 } });
    lines.lines.insert(lines.lines.end(), { { first, first + 1 }, { first + 2, first + 3 } });
  }
  return tubes;
}

struct Shots
{
  int passed = 0, felt = 0;
};

/// Straight through the net at a speed, anywhere, in any phase of the ticks; the device stays 5 mm behind it.
Shots shoot(const std::string& method, const std::vector<Tubes>& tubes, double radius_m, double speed_m_per_s,
  int count, test::Random& random)
{
  Shots shots;
  const double step_m = speed_m_per_s * tick_s;
  for (int i = 0; i < count; ++i)
  {
    const auto touch = makeTouch(method, tubes, radius_m);
    const double x = random.uniform(-3e-3, 3e-3), y = random.uniform(-3e-3, 3e-3), phase = (i + 0.5) / count;
    const double start = 4e-3 + step_m * phase;
    bool felt = false;
    Vec3 force_N = Vec3::Zero();
    for (int tick = 0; start - step_m * (tick - 1) > -5e-3; ++tick)
    {
      force_N = touch->to({ x, y, std::max(-5e-3, start - step_m * tick) });
      felt = felt || force_N.norm() > 1e-9;
    }
    shots.passed += force_N.z() > 0.0 ? 0 : 1; // nothing pushes back from behind
    shots.felt += felt ? 1 : 0;
  }
  return shots;
}

void judgeNet(const Conditions& conditions, Table& table)
{
  // The widest hole lets a ball through whose radius is half the spacing less the fibre: 0.65 mm; this one has 1 mm.
  constexpr double spacing_m = 1.5e-3, thick_m = 0.1e-3, radius_m = 1e-3;
  const std::vector<Tubes> tubes = net(spacing_m, 15, thick_m);
  const int count = conditions.pick(100, 400, 4000);
  test::Random random(conditions.seed);
  for (const double speed_m_per_s : { 0.1, 1.0, 10.0 })
  {
    const std::string caseName = "net at " + std::to_string(speed_m_per_s).substr(0, 4) + "m/s";
    const auto share = [count](int shots) { return static_cast<double>(shots) / count; };
    const Shots held = shoot("god-object", tubes, radius_m, speed_m_per_s, count, random);
    table.within({ caseName, "god-object r=1mm", "share through", "" }, share(held.passed), 0.0, 0.0);
    table.within({ caseName, "god-object r=1mm", "share felt", "" }, share(held.felt), 1.0, 0.0);
    const Shots fell = shoot("penalty", tubes, radius_m, speed_m_per_s, count, random);
    table.within({ caseName, "penalty", "share through", "" }, share(fell.passed), 1.0, 0.0);
    // Nowhere is the field thicker than 2 R: of ticks v T apart at most that share is inside.
    const double most = std::min(1.0, 2 * (radius_m + thick_m) / (speed_m_per_s * tick_s));
    table.atMost({ caseName, "penalty", "share felt", "" }, share(fell.felt), most + share(1));
  }
}

/// Random dashes at 10 m/s through a spring: no piece of the path comes nearer to the wire than touching it.
void judgeSpring(const Conditions& conditions, Table& table)
{
  constexpr double thick_m = 0.3e-3;
  const std::vector<Tubes> spring{ test::helix(0.01, 0.006, 4, 24, thick_m) };
  for (const double radius_m : { 0.0, 1e-3 })
  {
    const double r = std::max(radius_m, 1e-3 * thick_m);
    GodObjectTouch touch(spring, radius_m);
    test::TubeChecker checker(spring);
    touch.sink = &checker;
    test::TubeHand hand(spring, 0.012, 10.0 * tick_s, conditions.seed);
    touch.to(hand.next());
    double deepest_m = 0.0, apart_m = 0.0, pressedTicks = 0.0;
    const int ticks = conditions.pick(5000, 50000, 1000000);
    for (int i = 0; i < ticks; ++i)
    {
      const Vec3 before_W = touch.proxy_W();
      const bool pressed = touch.to(hand.next()).norm() > 1e-9;
      deepest_m = std::max(deepest_m, r - checker.leastClearance(before_W, touch.proxy_W()));
      pressedTicks += pressed ? 1.0 : 0.0;
      apart_m = pressed ? std::max(apart_m, test::clearance(spring, touch.proxy_W()) - r) : apart_m;
    }
    const std::string method = radius_m > 0.0 ? "god-object r=1mm" : "god-object r=0";
    table.atMost({ "spring at 10m/s", method, "deepest in the wire", "m" }, deepest_m, 1e-12);
    table.atLeast({ "spring at 10m/s", method, "share of ticks pressed", "" }, pressedTicks / ticks, 0.1);
    table.atMost({ "spring at 10m/s", method, "pressed but apart", "m" }, apart_m, 1e-9);
  }
}

} // namespace curves_experiment

void runCurves(const Conditions& conditions, Table& table)
{
  using namespace curves_experiment;
  judgeFibre(0.0, table);
  judgeFibre(1e-3, table);
  judgeBend(table);
  judgeNet(conditions, table);
  judgeSpring(conditions, table);
}

} // namespace palpate::lab
