// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh ball in the hand is pressed into a soft pad, drawn across it and lifted: the cost of a tick and the error of
// the force by each method. The truth is the exact ball on the whole pad, solved in every tick.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "haptics/session/path/PathTouch.h"
#include "testing/haptics/mechanism/HeldMesh.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/Felt.h"
#include "testing/support/LeastCosts.h"

namespace palpate::lab
{
namespace bodies_meet_experiment
{

constexpr double radius_m = 0.03, coupling_N_per_m = 1000.0, tick_s = 1e-3;
constexpr int cells = 8, level = 3, period_ticks = 40;
constexpr double rate_Hz = 1.0 / (tick_s * period_ticks);

/// The force on the hand at a place, one call a tick [N].
using Method = std::function<Vec3(const Vec3& hand_W)>;

/// A soft body beside the exact ball, computed at that rate; 0: in every tick.
Method exactBall(double low_Hz)
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = coupling_N_per_m;
  parameters.contact.radius_u = radius_m;
  SoftBodyInput block = test::pad(cells);
  block.poisson = test::padPoisson;
  block.model = ElasticModel::Linear;
  std::string refusal;
  auto touch = std::make_shared<PathTouch>(nullptr, parameters, tick_s);
  touch->press(BodyMaker::make(block, "block", 0, refusal), low_Hz);
  return [touch, time_s = 0.0](const Vec3& hand_W) mutable {
    return touch->next(time_s += tick_s, { hand_W, Quat::Identity() }).force_W;
  };
}

/// Contacts of the mesh that are found with each computation of the body, and solved in every tick.
Method foundContacts(double low_Hz)
{
  MechanismHold hold = test::firmHold(low_Hz);
  hold.stiffness_N_per_m = coupling_N_per_m;
  auto touch = std::make_shared<test::MeshTouch>(test::meshOnPad(test::makeIcosphere(level, radius_m), cells), hold);
  return [touch](const Vec3& hand_W) { return touch->to(hand_W).exact_W.force; };
}

/// The force of the whole, as it was when the body was computed, a period before it arrives.
Method heldForce()
{
  return [whole = foundContacts(0.0), tick = 0, next_N = Vec3(Vec3::Zero()), now_N = Vec3(Vec3::Zero())](
           const Vec3& hand_W) mutable
  {
    if (tick++ % period_ticks == 0)
    {
      now_N = next_N;
      next_N = whole(hand_W);
    }
    return now_N;
  };
}

/// Contacts and compliance of the first touch, for all times.
Method linearisedOnce()
{
  struct Once
  {
    test::MeshTouch first{ test::meshOnPad(test::makeIcosphere(level, radius_m), cells), test::firmHold(0.0) };
    test::Range range{ test::makeIcosphere(level, radius_m), first.body(), 0.0 };
    ContactFinder finder{ range.meshes(), range.plan.held, range.most };
    std::array<const PressedBody*, 1> soft{ &range.body };
    MechanismTick tick;
    std::uint64_t ticks = 0;

    Once() { finder.add(1, range.body, test::padYoung_Pa); }
  };
  return [once = std::make_shared<Once>()](const Vec3& hand_W)
  {
    const Pose at_W{ hand_W, Quat::Identity() };
    if (hand_W.z() > test::middleOfPad().z() + radius_m || once->ticks == 0)
    {
      FinderView view;
      view.pose_W = { &at_W, 1 };
      view.held = { radius_m, tick_s };
      view.soft = once->soft;
      (void)once->finder.find(view);
    }
    MechanismInput input;
    input.tick = ++once->ticks;
    input.plan = &once->range.plan;
    input.hand_W = at_W;
    input.grip = { coupling_N_per_m, 10.0 };
    input.soft = once->soft;
    input.found = &once->finder.last();
    return once->tick.step(input).exact_W.force;
  };
}

/// Each vertex below the pad's rest is pushed out by its depth: a mattress of springs as stiff as the pad is where it
/// cannot widen (Johnson, Contact Mechanics, 1985, 4.3).
Method penalty()
{
  const double modulus_Pa =
    test::padYoung_Pa * (1.0 - test::padPoisson) / ((1.0 + test::padPoisson) * (1.0 - 2.0 * test::padPoisson));
  const double top_m = test::middleOfPad().z(), springs_N_per_m3 = modulus_Pa / top_m;
  const TriangleMesh mesh = test::makeIcosphere(level, radius_m);
  const double each_m2 = 4.0 * std::numbers::pi * radius_m * radius_m / static_cast<double>(mesh.vertices_W.size());
  return [=](const Vec3& hand_W)
  {
    double force_N = 0.0;
    for (const Vec3& v : mesh.vertices_W)
    {
      const double depth_m = std::max(0.0, top_m - (hand_W + v).z());
      force_N += springs_N_per_m3 * depth_m * each_m2 * std::max(0.0, -v.z() / radius_m);
    }
    return Vec3(0.0, 0.0, force_N);
  };
}

/// Down, a rest, across, a rest, and up, at one speed; not over a vertex of the pad.
std::vector<Vec3> pathAt(double speed_m_per_s)
{
  constexpr double above_m = 0.5e-3, below_m = 2.5e-3, across_m = 2e-3;
  constexpr int rest_ticks = 150;
  const Vec3 over = test::middleOfPad() + Vec3(1.1e-3, 0.8e-3, radius_m);
  std::vector<Vec3> path{ over + above_m * Vec3::UnitZ() };
  const auto goTo = [&](const Vec3& to_W)
  {
    const Vec3 from_W = path.back();
    const int ticks = static_cast<int>(std::ceil((to_W - from_W).norm() / (speed_m_per_s * tick_s)));
    for (int i = 1; i <= ticks; ++i)
    {
      path.push_back(from_W + (to_W - from_W) * i / ticks);
    }
    path.insert(path.end(), rest_ticks, to_W);
  };
  path.insert(path.end(), 2 * period_ticks, path.front()); // the first answers
  goTo(over - below_m * Vec3::UnitZ());
  goTo(over + Vec3(across_m, 0.0, -below_m));
  goTo(over + Vec3(across_m, 0.0, above_m));
  return path;
}

struct Run
{
  std::vector<Vec3> force_N;
  Cost cost;
};

/// `whole`: each tick computes the body, for so long that one run is enough. Else ticks with which an answer may come
/// are not timed, as another thread computes those.
Run run(const std::function<Method()>& make, const std::vector<Vec3>& path, bool whole)
{
  Run run;
  const test::LeastCosts cost(whole ? 1 : costRuns,
    [&](auto call)
    {
      const Method method = make();
      run.force_N.clear();
      for (std::size_t tick = 0; tick < path.size(); ++tick)
      {
        const auto servo = [&] { run.force_N.push_back(method(path[tick])); };
        const bool answers = (tick + 2) % period_ticks < 4;
        answers && !whole ? servo() : call(servo);
      }
    });
  run.cost = Cost::of(cost);
  return run;
}

class Judge
{
public:
  Judge(double speed_m_per_s, Table& table)
    : name_(caseName({ { "speed_mm_per_s", 1e3 * speed_m_per_s }, { "rate", rate_Hz } })), path_(pathAt(speed_m_per_s)),
      truth_(run([] { return exactBall(0.0); }, this->path_, true)), table_(table)
  {
    for (const Vec3& force_N : this->truth_.force_N)
    {
      this->most_N_ = std::max(this->most_N_, force_N.norm());
    }
    this->table_.info({ this->name_, "exact ball, whole body in every tick", "error", "JND" }, 0.0).cost =
      this->truth_.cost;
    this->tell("exact ball, whole body in every tick", 0.0);
  }

  /// `most_JND`: that the method may have; infinite: it is told.
  void see(const char* method, const std::function<Method()>& make, bool whole, double most_JND)
  {
    const Run seen = run(make, this->path_, whole);
    double worst_N = 0.0;
    for (std::size_t i = 0; i < seen.force_N.size(); ++i)
    {
      worst_N = std::max(worst_N, (seen.force_N[i] - this->truth_.force_N[i]).norm());
    }
    const double error_JND = worst_N / (forceJnd * this->most_N_);
    const Subject error{ this->name_, method, "error", "JND" };
    (std::isinf(most_JND) ? this->table_.info(error, error_JND) : this->table_.atMost(error, error_JND, most_JND))
      .cost = seen.cost;
    this->tell(method, error_JND);
  }

private:
  void tell(const char* method, double error_JND)
  {
    const Outcome outcome = error_JND > 1.0 ? Outcome::Wrong : Outcome::Held;
    this->table_.info({ this->name_, method, "outcome", outcomeUnit }, static_cast<double>(outcome));
  }

  std::string name_;
  std::vector<Vec3> path_;
  Run truth_;
  double most_N_ = 0.0;
  Table& table_;
};

} // namespace bodies_meet_experiment

void runBodiesMeet(const Conditions& conditions, Table& table)
{
  using namespace bodies_meet_experiment;
  constexpr double told = std::numeric_limits<double>::infinity();
  const std::vector<double> speeds_m_per_s{ 0.005, 0.04 };
  for (std::size_t i = 0; i < speeds_m_per_s.size(); ++i)
  {
    const bool slow = i == 0;
    Judge judge(speeds_m_per_s[i], table);
    judge.see(
      "ours: exact ball", [] { return exactBall(rate_Hz); }, false, slow ? 1.0 : told);
    judge.see(
      "ours: found contacts", [] { return foundContacts(rate_Hz); }, false, slow ? 1.0 : told);
    if (!slow) // the answer of every tick knows no speed, and takes long
    {
      judge.see(
        "found contacts, whole body in every tick", [] { return foundContacts(0.0); }, true, 1.0);
    }
    judge.see("held force", heldForce, false, told);
    judge.see("linearised once", linearisedOnce, false, told);
    judge.see("penalty", penalty, false, told);
    conditions.progress((static_cast<double>(i) + 1) / static_cast<double>(speeds_m_per_s.size()));
  }
}

} // namespace palpate::lab
