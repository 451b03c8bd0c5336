// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/servo/SoftReturn.h"

#include <algorithm>

#include "haptics/core/PoseMath.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

/// Work of soft bodies on the others in one tick.
class SoftWork
{
public:
  SoftWork(const MechanismPlan& plan, const SettledConstraints& laws, const PosesOfBodies& before_W,
    const MechanismState& state) noexcept
    : plan_(plan), laws_(laws), before_W_(before_W), state_(state)
  {
    for (int l = 0; l < plan.lawCount; ++l)
    {
      if (laws.rowsOf(l) > 0 && state.laws[l].force_W != Vec3::Zero())
      {
        this->add(l);
      }
    }
  }

  /// Elastic energy of the soft bodies under the forces after the tick, by their compliance.
  [[nodiscard]] double held_Nu() const noexcept { return std::max(this->held_Nu_, 0.0); }
  /// Work on a body, above 0 where it is pushed away.
  [[nodiscard]] double on(int body) const noexcept { return this->on_Nu_[static_cast<std::size_t>(body)]; }
  /// Force and moment on a loose body, whitened.
  [[nodiscard]] const Vec6& press(int body) const noexcept { return this->press_[static_cast<std::size_t>(body)]; }

private:
  void add(int l) noexcept
  {
    const auto& [a, b] = this->laws_.rows().ends[l];
    const Vec3& force_W = this->state_.laws[l].force_W;
    if (a.soft >= 0 || b.soft >= 0)
    {
      const Vec3 free_W = (a.soft >= 0 ? a.x_W : Vec3(Vec3::Zero())) - (b.soft >= 0 ? b.x_W : Vec3(Vec3::Zero()));
      this->held_Nu_ += 0.5 * force_W.dot(this->state_.laws[l].apart_W - free_W);
    }
    if (b.soft >= 0 && a.soft < 0)
    {
      this->addTo(l, 0, force_W);
    }
    if (a.soft >= 0 && b.soft < 0)
    {
      this->addTo(l, 1, -force_W);
    }
  }

  void addTo(int l, int side, const Vec3& force_W) noexcept
  {
    const ConstraintEnd& end = this->laws_.rows().ends[l][side];
    const auto body = static_cast<std::size_t>(end.body);
    if (isLoose(this->plan_.bodies[body]))
    {
      Vec6 press;
      press << force_W,
        armOf(this->laws_.scene(), this->laws_.rows(), l, side).cross(force_W) / this->plan_.characteristic_u;
      this->press_[body] += press;
      this->on_Nu_[body] += press.dot(this->laws_.motion(end.body));
      return;
    }
    const Vec3 at_B = into(this->laws_.reference_W(end.body), end.x_W);
    this->on_Nu_[body] += force_W.dot(this->state_.pose_W[body] * at_B - this->before_W_[body] * at_B);
  }

  const MechanismPlan& plan_;
  const SettledConstraints& laws_;
  const PosesOfBodies& before_W_;
  const MechanismState& state_;
  double held_Nu_ = 0.0;
  std::array<double, Mechanism::mostBodies> on_Nu_{};
  std::array<Vec6, Mechanism::mostBodies> press_{ Vec6::Zero(), Vec6::Zero(), Vec6::Zero(), Vec6::Zero(), Vec6::Zero(),
    Vec6::Zero(), Vec6::Zero(), Vec6::Zero() };
};

/// So fast a loose body leaves a soft one that was given nothing, of the lever in a second.
constexpr double slowOfLever_per_s = 0.2;

/// Takes a share of the push of a tick back, in place and speed, but for a slow way. The work that is left.
double pushLess(const SoftWork& work, const LooseYield& yield, int body, double share, const MechanismPlan& plan,
  double dt_s, MechanismState& state) noexcept
{
  const Vec6& press = work.press(body);
  const Vec6 pushed_u = yield.compliance * press;
  const double square = press.dot(pushed_u), along = work.on(body);
  const double slow = slowOfLever_per_s * plan.characteristic_u * dt_s * press.norm();
  const double less = square > 0.0 ? std::clamp((along - slow) / square, 0.0, share) : 0.0;
  LooseMotion& motion = state.loose[static_cast<std::size_t>(body)];
  Pose& pose_W = state.pose_W[static_cast<std::size_t>(body)];
  const Vec3 turn_rad = less / plan.characteristic_u * pushed_u.tail<3>();
  pose_W.p -= less * pushed_u.head<3>();
  pose_W.q = (turnBy(-turn_rad) * pose_W.q).normalized();
  motion.speed_W -= less / dt_s * pushed_u.head<3>();
  motion.spin_B -= pose_W.q.conjugate() * turn_rad / dt_s;
  return (1.0 - less) * (along - less * square);
}

} // namespace

void returnNoMore(const MechanismPlan& plan, const SettledConstraints& laws, const PosesOfBodies& before_W, double dt_s,
  MechanismState& state) noexcept
{
  if (laws.scene().loose.empty() || laws.scene().soft.empty())
  {
    return;
  }
  const SoftWork work(plan, laws, before_W, state);
  double taken_Nu = 0.0, given_Nu = 0.0;
  for (int b = 0; b < plan.bodyCount; ++b)
  {
    taken_Nu += std::max(-work.on(b), 0.0);
    given_Nu += std::max(work.on(b), 0.0);
  }
  SoftEnergy& soft = state.soft;
  const double had_Nu = std::max(soft.held_Nu + taken_Nu, work.held_Nu() + given_Nu);
  const double share = had_Nu > 0.0 ? std::clamp((soft.given_Nu + taken_Nu) / had_Nu, 0.0, 1.0) : 1.0;
  for (int b = 0; b < plan.bodyCount; ++b)
  {
    if (isLoose(plan.bodies[b]) && work.on(b) > 0.0 && !state.loose[b].asleep)
    {
      const LooseYield& yield = laws.scene().loose[static_cast<std::size_t>(b)];
      given_Nu += pushLess(work, yield, b, 1.0 - share, plan, dt_s, state) - work.on(b);
    }
  }
  soft.given_Nu = std::min(soft.given_Nu + taken_Nu - given_Nu, work.held_Nu());
  soft.held_Nu = work.held_Nu();
}

} // namespace palpate
