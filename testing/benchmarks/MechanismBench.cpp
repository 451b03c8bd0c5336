// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-mechanism-bench: cost of a tick of a mechanism for the servo, beside one of a point on a rigid surface.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <CLI/CLI.hpp>

#include "haptics/compliance/wire/WireCompliance.h"
#include "haptics/contact/GodObject.h"
#include "haptics/mechanism/found/ContactFinder.h"
#include "haptics/session/mechanism/MechanismTouch.h"
#include "haptics/session/mechanism/ToolOnBody.h"
#include "testing/haptics/compliance/Blocks.h"
#include "testing/haptics/session/WallAndLiver.h"
#include "testing/support/CostSample.h"
#include "testing/support/MechanismRig.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/WireScenes.h"
#include "testing/support/WireTube.h"

namespace palpate::test
{
namespace
{

/// Ticks of a point on a rigid surface that one of each may be: twice the number seen. A needle that the hand turns is
/// solved some five times a tick, until its constraints are met on the finite turn.
constexpr double mostOfTurned = 31.0, mostOfNeedle = 13.0, mostOfBlock = 125.0, mostOfSliding = 42.0;
/// Likewise for the stiffness, factor and compliance of wires.
constexpr double mostOfWire = 45.0, mostOfLongWire = 140.0;
/// Likewise for a whole tick of a wire of 64 beams in a tube.
constexpr double mostOfPushed = 950.0;
/// Ticks of a ball on tissue that one beside a bone may be, and answers: twice the numbers seen.
constexpr double mostBeside = 2.5, mostAnswersBeside = 20.0;

constexpr double beyond = 0.04, before = -0.006, speed_m = 2e-4; // a tick

struct Seen
{
  double p50_us = 0.0;
  double p99_us = 0.0;
  std::uint32_t mostWork = 0;
  int capped = 0;
};

void see(const MechanismResult& r, Seen& seen)
{
  seen.mostWork = std::max(seen.mostWork, r.work);
  seen.capped += r.capped ? 1 : 0;
}

Seen ended(const CostSample& cost, Seen seen)
{
  seen.p50_us = cost.quantile_us(0.5);
  seen.p99_us = cost.quantile_us(0.99);
  return seen;
}

/// Of a tip that goes in and out so far, a little askew.
Vec3 tipAt(int tick)
{
  const double length = beyond - before;
  const double gone = std::fmod(speed_m * tick, 2.0 * length);
  const double way = std::min(gone, 2.0 * length - gone);
  return { 1e-3 + 0.02 * way, 2e-3 - 0.03 * way, before + way };
}

/// Through wall and liver of tetrahedra, whose snapshots come at 25 Hz.
Seen needle(int strokes, double turning_Nm_per_rad)
{
  MechanismInputs inputs = wallAndLiver(2);
  std::string refusal;
  const auto bodies = MechanismBodies::make(inputs.soft, refusal);
  const MechanismPlan plan = planMechanism(inputs.mechanism, bodies->atRest(), 1);
  bodies->hold(inputs.mechanism, plan);
  bodies->pace(0.04);
  const int ticks = static_cast<int>(2.0 * strokes * (beyond - before) / speed_m);
  const ProcessorClock clock;
  CostSample cost(static_cast<std::size_t>(ticks), clock);
  MechanismTick servo;
  Seen seen;
  for (int tick = 0; tick < ticks; ++tick)
  {
    MechanismInput input;
    input.tick = static_cast<std::uint64_t>(tick) + 1;
    input.plan = &plan;
    input.hand_W = { tipAt(tick) - needle_m * Vec3::UnitZ(), Quat::Identity() };
    input.grip = { kc, turning_Nm_per_rad };
    input.soft = bodies->at(1e-3 * tick);
    const MechanismResult* r = nullptr;
    cost.time([&] { r = &servo.step(input); });
    see(*r, seen);
    MechanismHand hand;
    hand.tick = input.tick;
    hand.plan = plan.revision;
    hand.hand_W = input.hand_W.p;
    hand.tip_W = tipAt(tick);
    hand.press(*r);
    bodies->tell(hand);
  }
  return ended(cost, seen);
}

/// A block that only balance holds on four springs with friction, pushed to and fro by a needle that is fastened to it.
/// On a slope that its friction does not hold, without a needle, the block finds no place to rest.
Seen block(int ticks, double slope)
{
  constexpr double half = 0.05, high = 0.02, rod = 0.1, weight = 2.0;
  MechanismRig rig(rod);
  MechanismBody body;
  body.name = "block";
  body.kind = MechanismBodyKind::Rigid;
  body.halfSize_u = Vec3(half, half, high);
  body.load_W = weight * Vec3(std::sin(slope), 0.0, -std::cos(slope));
  rig.mechanism.bodies.push_back(body);
  for (int foot = 0; foot < 4; ++foot)
  {
    const Vec3 at(foot & 1 ? half : -half, foot & 2 ? half : -half, -high);
    const std::string name = "foot " + std::to_string(foot);
    rig.addSoft(name, springWall(name, at, Vec3::UnitZ(), 0.01, 1.0 / tissue));
    MechanismConstraint& law = rig.join(ConstraintKind::Friction, name, at, at);
    law.a = "block";
    law.axis_B = Vec3::UnitZ();
    law.friction = 0.3;
  }
  const Vec3 top(0.01, 0.0, high);
  if (slope == 0.0)
  {
    rig.join(ConstraintKind::Attachment, "block", Vec3(0.0, 0.0, rod), top);
  }
  const ProcessorClock clock;
  CostSample cost(static_cast<std::size_t>(ticks), clock);
  Seen seen;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const Vec3 led = top + Vec3(0.004 * std::sin(0.02 * tick), 0.003 * std::sin(0.013 * tick), rod);
    const MechanismResult* r = nullptr;
    cost.time([&] { r = &rig.step(Pose{ led, Quat(0.0, 1.0, 0.0, 0.0) }); });
    see(*r, seen);
  }
  return ended(cost, seen);
}

/// A point that slides over the wall as if it were rigid.
Seen rigidPoint(int ticks)
{
  MechanismInputs inputs = wallAndLiver(2);
  std::string refusal;
  const auto bodies = MechanismBodies::make({ inputs.soft.front() }, refusal);
  const Scene& scene = *bodies->atRest().front().body->scene;
  const ProcessorClock clock;
  CostSample cost(static_cast<std::size_t>(ticks), clock);
  GodObjectState state;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const double s = 1e-3 * tick;
    const Vec3 p_W(0.02 * std::sin(3.0 * s), 0.02 * std::sin(2.0 * s), tick == 0 ? -1e-3 : 1e-3);
    cost.time([&] { (void)moveGodObject(scene, ContactPlan(), p_W, state); });
  }
  return ended(cost, {});
}

/// Costs of a ball that is drawn over tissue to and fro, with answers of the finder at 30 Hz.
struct Drawn
{
  Seen tick;
  double p50_us = 0.0; ///< that of a tick
  double answer_us = 0.0;
};

Drawn drawnOverTissue(int ticks, const std::vector<MechanismBody>& beside)
{
  constexpr int ticksAnAnswer = 33;
  constexpr double ball_m = 0.015, deep_m = 2e-3;
  SoftBodyInput soft = pad(8);
  soft.poisson = 0.4;
  soft.model = ElasticModel::Linear;
  const MechanismSoftInput body{ "block", std::make_shared<const SoftBodyInput>(soft) };
  const auto made = toolOnBody("ball", makeIcosphere(3, ball_m), body, 0.3, beside);
  const Mechanism& mechanism = made.value->mechanism;
  std::string refusal;
  const auto bodies = MechanismBodies::make(made.value->soft, refusal);
  const MechanismPlan plan = planMechanism(mechanism, bodies->atRest(), 1);
  std::vector<FinderMesh> meshes;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b)
  {
    if (mechanism.bodies[b].mesh)
    {
      meshes.push_back({ static_cast<int>(b), mechanism.bodies[b].mesh, 0.3 });
    }
  }
  ContactFinder finder(std::move(meshes), plan.held, static_cast<std::size_t>(roomForFound(mechanism)));
  finder.add(1, *bodies->first().front(), soft.young_Pa.front());
  const std::array<const PressedBody*, 1> bent{ bodies->first().front().get() };
  const ProcessorClock clock;
  CostSample cost(static_cast<std::size_t>(ticks), clock), answers(static_cast<std::size_t>(ticks), clock);
  MechanismTick servo;
  MechanismResult result;
  Drawn drawn;
  for (int tick = 0; tick < ticks; ++tick)
  {
    MechanismInput input;
    input.tick = static_cast<std::uint64_t>(tick) + 1;
    input.plan = &plan;
    const double way_m = 0.06 * std::sin(1e-3 * tick); // at most 60 mm/s
    input.hand_W = { middleOfPad() + Vec3(0.04 + way_m, 0.0, ball_m - deep_m), Quat::Identity() };
    input.grip = { kc, 1.0 };
    input.soft = bent;
    if (tick % ticksAnAnswer == 0)
    {
      result.pose_W[0] = tick == 0 ? input.hand_W : result.pose_W[0];
      FinderView view;
      view.pose_W = result.pose_W;
      view.held = { 0.015, 0.005 };
      view.standing = { 0.01, 5e-4 };
      view.soft = bent;
      view.presses = { result.presses.data(), static_cast<std::size_t>(result.pressCount) };
      answers.time([&] { (void)finder.find(view); });
    }
    input.found = &finder.last();
    cost.time([&] { result = servo.step(input); });
    see(result, drawn.tick);
  }
  drawn.tick = ended(cost, drawn.tick);
  drawn.p50_us = drawn.tick.p50_us;
  drawn.answer_us = answers.quantile_us(0.5);
  return drawn;
}

/// Of a hundred thousand triangles, its top level with the tissue's.
std::vector<MechanismBody> boneBeside()
{
  const NoisySphere sphere(100000, 1e-3);
  MechanismBody bone;
  bone.name = "bone";
  bone.mesh = makeStandingMesh(
    std::make_shared<const SurfaceTree>(cleanMesh(shifted(sphere.mesh(), Vec3(0.155, 0.05, 0.0))).mesh))
                .value;
  return { bone };
}

/// Beside a bone a tick solves as many contacts as without it.
bool tellBeside(int ticks)
{
  const std::vector<MechanismBody> bone = boneBeside();
  const auto [beside, alone] =
    costsInTurn([&] { return drawnOverTissue(ticks, bone); }, [&] { return drawnOverTissue(ticks, {}); });
  const double ratio = beside.p50_us / alone.p50_us, answers = beside.answer_us / alone.answer_us;
  std::printf(
    "a mesh drawn over tissue, a bone of %zu triangles beside it: p50 %.1f p99 %.1f us, without it %.1f and %.1f,"
    " ratios %.2f (at most %.1f) and %.2f; an answer %.2f ms, %.2f ms without it (at most %.0f times)\n",
    bone.front().mesh->tree->mesh().triangles.size(), beside.tick.p50_us, beside.tick.p99_us, alone.tick.p50_us,
    alone.tick.p99_us, ratio, mostBeside, beside.tick.p99_us / alone.tick.p99_us, 1e-3 * beside.answer_us,
    1e-3 * alone.answer_us, mostAnswersBeside);
  return ratio <= mostBeside && answers <= mostAnswersBeside;
}

/// Stiffness, factor and compliance between contacts of a wire that is bent at rest, as a tick needs them.
Seen wire(int ticks, int beams, int contacts)
{
  WireRig rig(arcPoints(beams, 50.0, 2.0), PinnedColumn::section());
  rig.loads.held[0] = WireLoads::clamped;
  std::vector<WireTouch> touches;
  for (int i = 0; i < contacts; ++i)
  {
    touches.push_back({ beams * (i + 1) / contacts - 1, 0.5, Vec3(0.0, 0.25, 0.0) });
  }
  const auto w = std::make_unique<ContactProblem::Square>(3 * contacts, 3 * contacts);
  const ProcessorClock clock;
  CostSample cost(static_cast<std::size_t>(ticks), clock);
  for (int tick = 0; tick < ticks; ++tick)
  {
    cost.time(
      [&]
      {
        (void)rig.newton->linearise(rig.wire, rig.places_W, rig.loads);
        rig.newton->factor().invert();
        w->setZero();
        addWireCompliance(rig.newton->factor(), touches, *w);
      });
  }
  return ended(cost, {});
}

/// A wire of 64 beams that is pushed through a tube with a bend, within a session's budget.
Seen pushedWire(double friction)
{
  constexpr int ticks = 1700;
  constexpr double way_mm = 0.1;
  const Tube tube{ .angle_rad = 2.36, .last_mm = 60.0, .around = 24, .ring_mm = 0.5 };
  PushedWire pushed(nitinolWire(250.0, 64, friction), tube.mesh());
  pushed.budget = ContactPlan().workBudget;
  const ProcessorClock clock;
  CostSample cost(ticks, clock);
  Seen seen;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const WireResult* r = nullptr;
    cost.time([&] { r = &pushed.tick(way_mm * tick); });
    seen.mostWork = std::max(seen.mostWork, r->work);
    seen.capped += r->capped ? 1 : 0;
  }
  return ended(cost, seen);
}

bool tell(const char* name, const Seen& seen, const Seen& rigid, double mostOfRigid)
{
  const double ratio = seen.p50_us / rigid.p50_us;
  std::printf("%-44s p50 %7.1f us p99 %7.1f us, ratio %6.1f (at most %.0f); work up to %u, %d capped\n", name,
    seen.p50_us, seen.p99_us, ratio, mostOfRigid, seen.mostWork, seen.capped);
  return ratio <= mostOfRigid;
}

} // namespace
} // namespace palpate::test

int main(int argc, char** argv)
{
  using namespace palpate::test;
  int strokes = 20;
  bool withAssertions = false;
  CLI::App app("what a tick of a mechanism costs the servo");
  app.add_option("--strokes", strokes, "of the needle");
  app.add_flag("--assert", withAssertions, "fail if a tick costs more ticks of a point than it may");
  CLI11_PARSE(app, argc, argv);
  const Seen rigid = rigidPoint(20000);
  std::printf(
    "%-44s p50 %7.1f us p99 %7.1f us\n", "a point on the wall as if it were rigid", rigid.p50_us, rigid.p99_us);
  bool within = tell("needle in wall and liver, turned by the hand", needle(strokes, kr), rigid, mostOfTurned);
  within = tell("the same, its turn free", needle(strokes, 0.0), rigid, mostOfNeedle) && within;
  within = tell("a block that rubs on four springs", block(5000, 0.0), rigid, mostOfBlock) && within;
  within = tell("the same, sliding without end", block(500, 0.6), rigid, mostOfSliding) && within;
  within = tell("wire of 20 beams with 9 contacts: its rows", wire(5000, 20, 9), rigid, mostOfWire) && within;
  within = tell("wire of 64 beams with 20 contacts: its rows", wire(2000, 64, 20), rigid, mostOfLongWire) && within;
  within = tell("wire of 64 beams pushed through a bend", pushedWire(0.0), rigid, mostOfPushed) && within;
  within = tell("the same with friction", pushedWire(0.1), rigid, mostOfPushed) && within;
  within = tellBeside(6000) && within;
  return within || !withAssertions ? 0 : 1;
}
