// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 21, 22 and 25: surfaces that come at a resting hand, close on it or turn under it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "testing/lab/Experiments.h"
#include "testing/lab/methods/StaticFrameProxy.h"
#include "testing/support/Meshes.h"
#include "testing/support/Stage.h"

namespace palpate::lab
{
namespace moving_surfaces_experiment
{

constexpr double K = 1000.0, T = 1e-3; // scenes in metres
constexpr double degree = std::numbers::pi / 180;
const char* const staticName = "static-frame";

struct Ours
{
  const char* name;
  double radius_m;
};
constexpr Ours pointAndBall[] = { { "god-object r=0", 0.0 }, { "god-object r=1mm", 1e-3 } };

ContactPlan planOf(const Ours& ours, FrictionPlan friction = {})
{
  ContactPlan plan;
  plan.radius_u = ours.radius_m;
  plan.friction = friction;
  return plan;
}

Pose lifted(double z_m)
{
  return { { 0, 0, z_m }, Quat::Identity() };
}

/// A plate that rises at a constant speed and a hand that rests: free until the plate comes, or pressed into it.
struct Platform
{
  const char* hand;
  double start_m; ///< of the plate
  double depth_m; ///< of the hand below the height 0
};
constexpr Platform comes = { "free", -0.002, 0.0 }, lifts = { "pressed", 0.0, 2e-3 };

std::string nameOf(const Platform& platform, double speed)
{
  return std::string("platform hand=") + platform.hand + " " + caseName({ { "speed", speed } }) + "m/s";
}

int ticksFor(double speed)
{
  return std::min(400, static_cast<int>(0.05 / speed / T));
}

struct Ride
{
  double falls = 0.0;
  double wrong_N = 0.0; ///< largest error of the force
};

/// `tick` gives the proxy's height above the plate's plane less its radius, and the height the plate has.
template<class Tick>
Ride ride(const Platform& platform, double speed, Tick tick)
{
  Ride seen;
  for (int i = 1; i <= ticksFor(speed); ++i)
  {
    const double plate_m = platform.start_m + speed * i * T;
    const double height_m = tick(plate_m);
    const double truth_m = std::max(plate_m, -platform.depth_m);
    seen.falls = std::max(seen.falls, height_m < plate_m - 1e-9 ? 1.0 : 0.0);
    seen.wrong_N = std::max(seen.wrong_N, K * std::abs(height_m - truth_m));
  }
  return seen;
}

void ridesOfOurs(const TriangleMesh& plate, const Platform& platform, double speed, Table& table)
{
  for (const Ours& ours : pointAndBall)
  {
    test::Stage stage;
    stage.add(plate, [&](double t_s) { return lifted(platform.start_m + speed * t_s); });
    const Vec3 hand_W(0, 0, ours.radius_m - platform.depth_m);
    test::Actor actor(stage, planOf(ours), hand_W + Vec3(0, 0, 2 * platform.depth_m));
    const Ride seen = ride(platform, speed,
      [&](double)
      {
        actor.tick(hand_W);
        return actor.state.x_W.z() - ours.radius_m;
      });
    table.within({ nameOf(platform, speed), ours.name, "falls" }, seen.falls, 0.0, 0.0);
    table.atMost({ nameOf(platform, speed), ours.name, "error of the force", "N" }, seen.wrong_N, 1e-9);
  }
}

Ride staticRide(const TriangleMesh& plate, const Platform& platform, double speed)
{
  const Vec3 hand_W(0, 0, -platform.depth_m);
  StaticFrameProxy proxy({ plate }, hand_W + Vec3(0, 0, 2 * platform.depth_m));
  proxy.tick({ lifted(platform.start_m) }, hand_W);
  return ride(platform, speed, [&](double plate_m) { return proxy.tick({ lifted(plate_m) }, hand_W).z(); });
}

void platforms(const TriangleMesh& plate, Table& table)
{
  for (const Platform& platform : { comes, lifts })
  {
    for (const double speed : { 0.01, 0.5, 5.0 })
    {
      ridesOfOurs(plate, platform, speed, table);
    }
  }
  // One that rests at the device looks at no segment at all: any plate passes it.
  table.within({ nameOf(comes, 0.01), staticName, "falls" }, staticRide(plate, comes, 0.01).falls, 1.0, 0.0);
  // One that is pressed has its gap, 0.1 mm: a plate faster than that in a tick has passed it.
  const double limit = StaticFrameProxy::gap_u / T;
  table.within(
    { nameOf(lifts, 0.9 * limit), staticName, "falls" }, staticRide(plate, lifts, 0.9 * limit).falls, 0.0, 0.0);
  for (const double speed : { 1.1 * limit, 0.5, 5.0 })
  {
    table.within({ nameOf(lifts, speed), staticName, "falls" }, staticRide(plate, lifts, speed).falls, 1.0, 0.0);
  }
}

/// Two blades hinged on the y axis at x = -0.2 that close on a hand between them.
struct Scissors
{
  std::string name;
  Vec3 hand_W;
  double speed_rad_per_s;

  static constexpr double hinge_m = -0.2, open_rad = 40 * degree;

  [[nodiscard]] double angle_rad(double t_s) const { return open_rad - this->speed_rad_per_s * t_s; }
  /// Turned up (1) or down (-1) from the plane z = 0 about the hinge.
  [[nodiscard]] Pose blade(double up, double t_s) const
  {
    const Vec3 hinge_W(hinge_m, 0, 0);
    const Quat q(Eigen::AngleAxisd(-up * this->angle_rad(t_s), Vec3::UnitY()));
    return { hinge_W - q * hinge_W, q };
  }
  /// Blades closed to a fifth of a degree.
  [[nodiscard]] int ticks() const { return static_cast<int>((open_rad - 0.2 * degree) / (this->speed_rad_per_s * T)); }
  /// The place nearest to the hand at which a ball fits between the blades, the lower one posed so and the upper one
  /// its mirror image. Not the even turn about the hinge: a pose between two snapshots is not quite that.
  [[nodiscard]] Vec3 truth_W(const Pose& lower_WS, double radius_m) const
  {
    const Vec3 lower = lower_WS.q * Vec3::UnitZ(), upper(lower.x(), 0, -lower.z()); // normals into the gap
    const double reach_m = lower.dot(lower_WS.p) + radius_m;
    const Vec3 x_W = this->hand_W + std::max(0.0, reach_m - upper.dot(this->hand_W)) * upper;
    const Vec3 apex_W(reach_m / lower.x(), 0, 0); // where the ball touches both
    return lower.dot(x_W) < reach_m ? apex_W : x_W;
  }
};

void cutOurs(const TriangleMesh& plate, const Scissors& scissors, const Ours& ours, Table& table)
{
  test::Stage stage;
  stage.add(plate, [&](double t_s) { return scissors.blade(1.0, t_s); });
  stage.add(plate, [&](double t_s) { return scissors.blade(-1.0, t_s); });
  test::Actor actor(stage, planOf(ours), scissors.hand_W);
  double falls = 0.0, wrong_N = 0.0;
  for (int i = 0; i < scissors.ticks(); ++i)
  {
    actor.tick(scissors.hand_W);
    falls += actor.inSurface(0).z() > 1e-9 || actor.inSurface(1).z() < -1e-9;
    const Vec3 truth_W = scissors.truth_W(actor.pose(1), ours.radius_m);
    wrong_N = std::max(wrong_N, K * (actor.state.x_W - truth_W).norm());
  }
  table.within({ scissors.name, ours.name, "ticks beyond a blade" }, falls, 0.0, 0.0);
  table.atMost({ scissors.name, ours.name, "error of the force", "N" }, wrong_N, 1e-6);
}

void cutStatic(const TriangleMesh& plate, const Scissors& scissors, Table& table)
{
  StaticFrameProxy proxy({ plate, plate }, scissors.hand_W);
  double falls = 0.0;
  for (int i = 1; i <= scissors.ticks(); ++i)
  {
    const std::vector<Pose> poses = { scissors.blade(1.0, i * T), scissors.blade(-1.0, i * T) };
    const Vec3 x_W = proxy.tick(poses, scissors.hand_W);
    falls += (poses[0].q.conjugate() * (x_W - poses[0].p)).z() > 1e-9;
  }
  table.atLeast({ scissors.name, staticName, "ticks beyond a blade" }, falls, 1.0);
}

void scissors(const TriangleMesh& plate, Table& table)
{
  for (const double speed : { 20.0, 200.0 })
  {
    const std::string suffix = " " + caseName({ { "speed", speed } }) + "deg/s";
    const Scissors between{ "scissors hand=between" + suffix, { -0.19, 0, 0 }, speed * degree };
    const Scissors beyond{ "scissors hand=20mm-up" + suffix, { -0.1, 0, 0.02 }, speed * degree };
    for (const Ours& ours : pointAndBall)
    {
      cutOurs(plate, between, ours, table);
      cutOurs(plate, beyond, ours, table);
    }
    cutStatic(plate, beyond, table);
  }
}

constexpr double depth_m = 2e-3, mu_s = 0.5, mu_k = 0.3;

/// Effect on a pressed hand of a plate that is drawn or turned under it.
struct Rubbing
{
  double wrong_N = 0.0; ///< largest error of the force once the plate slips
  double gains = 0.0;   ///< slipping ticks in which the plate got work out of friction
  double slips = 0.0;
};

Rubbing rub(test::Actor& actor, const Vec3& hand_W, int ticks)
{
  Rubbing seen;
  bool slipped = false;
  for (int i = 0; i < ticks; ++i)
  {
    const Vec3 before_S = actor.inSurface(0);
    const bool slips = actor.tick(hand_W).friction == FrictionState::Slips;
    const Vec3 force_N = K * (actor.state.x_W - hand_W);
    // The contact's displacement over the plate, in W: friction on the hand is against it.
    const Vec3 way_W = actor.pose(0).q * (actor.inSurface(0) - before_S);
    if (slips && slipped)
    {
      seen.slips += 1.0;
      seen.gains += force_N.head<2>().dot(way_W.head<2>()) > 0.0;
      seen.wrong_N = std::max(
        { seen.wrong_N, std::abs(force_N.head<2>().norm() - mu_k * K * depth_m), std::abs(force_N.z() - K * depth_m) });
    }
    slipped = slips;
  }
  return seen;
}

struct Turning
{
  std::string name;
  test::Stage::Path path;
  double hand_m; ///< along x
};

void rubbed(const TriangleMesh& plate, const Turning& turning, Table& table)
{
  constexpr int ticks = 150;
  for (const Ours& ours : pointAndBall)
  {
    test::Stage stage;
    stage.add(plate, turning.path);
    const Vec3 hand_W(turning.hand_m, 0, ours.radius_m - depth_m);
    test::Actor actor(stage, planOf(ours, { mu_s, mu_k }), hand_W + Vec3(0, 0, 0.01));
    const Rubbing seen = rub(actor, hand_W, ticks);
    table.atLeast({ turning.name, ours.name, "slipping ticks" }, seen.slips, 10.0);
    table.atMost({ turning.name, ours.name, "error of the force", "N" }, seen.wrong_N, 1e-6);
    table.within({ turning.name, ours.name, "ticks in which friction gives work" }, seen.gains, 0.0, 0.0);
  }
  // Friction that only sees a plane which is the same in every tick feels no slip at all.
  test::Stage stage;
  stage.add(plate, turning.path);
  const Vec3 hand_W(turning.hand_m, 0, -depth_m);
  test::Actor actor(stage, planOf(pointAndBall[0], { mu_s, mu_k }), hand_W + Vec3(0, 0, 0.01));
  actor.carries = false;
  for (int i = 0; i < ticks; ++i)
  {
    actor.tick(hand_W);
  }
  const double sideways_N = K * (actor.state.x_W - hand_W).head<2>().norm();
  table.atLeast({ turning.name, "world-frame friction", "error of the force", "N" },
    std::abs(sideways_N - mu_k * K * depth_m), 0.5);
}

void turntables(const TriangleMesh& plate, Table& table)
{
  for (const double speed : { 0.02, 0.3, 1.0 })
  {
    rubbed(plate,
      { "drawn " + caseName({ { "speed", speed } }) + "m/s",
        [speed](double t_s) {
          return Pose{ { speed * t_s - 0.1, 0, 0 }, Quat::Identity() };
        },
        0.0 },
      table);
  }
  for (const double turns : { 0.4, 20.0 })
  {
    rubbed(plate,
      { "turntable " + caseName({ { "speed", turns } }) + "rad/s",
        [turns](double t_s) {
          return Pose{ Vec3::Zero(), Quat(Eigen::AngleAxisd(turns * t_s, Vec3::UnitZ())) };
        },
        0.05 },
      table);
  }
}

} // namespace moving_surfaces_experiment

void runMoving(const Conditions& conditions, Table& table)
{
  using namespace moving_surfaces_experiment;
  test::Random random(conditions.seed);
  const TriangleMesh plate = test::makeSheet({ 0.4, 0.4, 12, 12, 0.3 }, random);
  platforms(plate, table);
  conditions.progress(0.3);
  scissors(plate, table);
  conditions.progress(0.8);
  turntables(plate, table);
}

} // namespace palpate::lab
