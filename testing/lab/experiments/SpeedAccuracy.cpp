// SPDX-License-Identifier: GPL-3.0-or-later
// Every method on every scene: the cost of a tick, and the error of its force, in units of the just noticeable
// difference: 7 % of a force, 18 degrees of its direction.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "testing/lab/Experiments.h"
#include "testing/lab/Felt.h"
#include "testing/lab/methods/ContactMethod.h"
#include "testing/lab/methods/TouchScenes.h"

namespace palpate::lab
{
namespace speed_accuracy_experiment
{

constexpr double unbounded_JND = 1e6;

struct Way
{
  std::vector<Vec3> device_W, force_u;
};

Way wayOf(const TouchScene& scene, double r_u, int ticks)
{
  Way way;
  for (int tick = 0; tick <= ticks; ++tick)
  {
    way.device_W.push_back(scene.device_W(tick, r_u));
    way.force_u.push_back(scene.force_u(way.device_W.back(), r_u));
  }
  return way;
}

/// The figures of a method on a path.
class Judge
{
public:
  explicit Judge(double depth_u) : depth_u_(depth_u) {}

  void see(const Vec3& force_u, const Vec3& truth_u)
  {
    if (!force_u.allFinite())
    {
      this->unstable_ = true;
      this->worst_JND_ = unbounded_JND;
      return;
    }
    const bool shouldTouch = truth_u.norm() > 1e-9 * this->depth_u_;
    const bool touches = force_u.norm() > forceJnd * (shouldTouch ? truth_u.norm() : this->depth_u_);
    this->lost_ = shouldTouch && !touches ? this->lost_ + 1 : 0;
    this->stuck_ = !shouldTouch && touches ? this->stuck_ + 1 : 0;
    this->longestLost_ = std::max(this->longestLost_, this->lost_);
    this->longestStuck_ = std::max(this->longestStuck_, this->stuck_);
    const double error = shouldTouch ? this->inContact(force_u, truth_u) : force_u.norm() / (forceJnd * this->depth_u_);
    this->worst_JND_ = std::max(this->worst_JND_, std::min(error, unbounded_JND));
  }

  [[nodiscard]] double worst_JND() const { return this->worst_JND_; }

  [[nodiscard]] Outcome outcome() const
  {
    constexpr int frame = 16; // ticks: a fault no longer than a picture is a wrong force, not another place
    if (this->unstable_)
    {
      return Outcome::Unstable;
    }
    if (this->longestLost_ > frame)
    {
      return Outcome::Through;
    }
    if (this->longestStuck_ > frame)
    {
      return Outcome::Stuck;
    }
    return this->worst_JND_ > 1.0 ? Outcome::Wrong : Outcome::Held;
  }

private:
  [[nodiscard]] double inContact(const Vec3& force_u, const Vec3& truth_u) const
  {
    const double angle_rad = std::atan2(force_u.cross(truth_u).norm(), force_u.dot(truth_u));
    return std::max((force_u - truth_u).norm() / (forceJnd * truth_u.norm()), angle_rad / directionJnd_rad);
  }

  double depth_u_;
  double worst_JND_ = 0.0;
  int lost_ = 0, longestLost_ = 0;
  int stuck_ = 0, longestStuck_ = 0;
  bool unstable_ = false;
};

void judge(const TouchScene& scene, const World& world, const MethodKind& kind, const Way& way, Table& table)
{
  const auto method = kind.make(world);
  Judge seen(scene.depth_u);
  const test::LeastCosts cost(costRuns,
    [&](auto call)
    {
      seen = Judge(scene.depth_u);
      method->start(way.device_W.front());
      for (std::size_t tick = 1; tick < way.device_W.size(); ++tick)
      {
        MethodTick result;
        call([&] { result = method->tick(way.device_W[tick]); });
        seen.see(result.force_u, way.force_u[tick]);
      }
    });
  const Subject error{ scene.name, kind.name, "error", "JND" },
    outcome{ scene.name, kind.name, "outcome", outcomeUnit };
  const auto ended = static_cast<double>(seen.outcome());
  if (scene.fails(kind.name))
  {
    table.atLeast(error, seen.worst_JND(), 1.0).cost = Cost::of(cost);
    table.atLeast(outcome, ended, 1.0);
  }
  else
  {
    table.atMost(error, seen.worst_JND(), 1.0).cost = Cost::of(cost);
    table.atMost(outcome, ended, 0.0);
  }
}

} // namespace speed_accuracy_experiment

void runSpeedAccuracy(const Conditions& conditions, Table& table)
{
  using namespace speed_accuracy_experiment;
  test::Random random(conditions.seed + 100);
  const int ticks = conditions.pick(400, 4000, 40000);
  const std::vector<TouchScene> scenes = touchScenes(random);
  for (std::size_t i = 0; i < scenes.size(); ++i)
  {
    const TouchScene& scene = scenes[i];
    const World world(scene.mesh, scene.metre_u);
    std::map<double, Way> ways;
    for (const MethodKind& kind : methods())
    {
      if (!kind.make)
      {
        table.absent({ scene.name, kind.name, "error", "JND" });
        continue;
      }
      const double r_u = kind.radius_m * scene.metre_u;
      const auto [way, isNew] = ways.try_emplace(r_u);
      if (isNew)
      {
        way->second = wayOf(scene, r_u, ticks);
      }
      judge(scene, world, kind, way->second, table);
    }
    conditions.progress((static_cast<double>(i) + 1) / static_cast<double>(scenes.size()));
  }
}

} // namespace palpate::lab
