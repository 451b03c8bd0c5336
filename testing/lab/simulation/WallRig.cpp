// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/simulation/WallRig.h"

#include <stdexcept>

#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate::lab
{
namespace
{

std::shared_ptr<const Scene> makeFloor()
{
  test::Random random(1); // one cell without jitter: only its diagonal is random
  return test::sceneOf(test::makeSheet({ 4.0, 4.0, 1, 1, 0.0 }, random));
}

} // namespace

HapticParameters plainSpring(double stiffness_N_per_m)
{
  HapticParameters parameters;
  parameters.safety = SafetyLimits::none();
  parameters.stiffness_N_per_m = stiffness_N_per_m;
  return parameters;
}

HapticParameters springDamper(double stiffness_N_per_m, double damping_Ns_per_m)
{
  HapticParameters parameters = plainSpring(stiffness_N_per_m);
  parameters.damping_Ns_per_m = damping_Ns_per_m;
  parameters.velocity.method = VelocityMethod::BackwardDifference;
  return parameters;
}

HapticParameters passiveSpring(double stiffness_N_per_m, double delay_ticks)
{
  HapticParameters parameters = plainSpring(stiffness_N_per_m);
  parameters.passivity.enabled = true;
  parameters.passivity.delay_ticks = delay_ticks;
  return parameters;
}

WallRig::WallRig(HapticDevice& device, const WallSetup& setup) : device_(device), setup_(setup), floor_(makeFloor())
{
  const std::string problem = device.open();
  if (!problem.empty())
  {
    throw std::runtime_error(problem);
  }
  if (this->setup_.parameters.velocity.resolution_m == 0.0)
  {
    this->setup_.parameters.velocity.resolution_m = device.info().resolution_m.value;
  }
  this->placeAbove();
}

/// A device may start on the floor or in it: the proxy is above all the same.
void WallRig::placeAbove()
{
  TickInput input;
  input.scene = this->floor_.get();
  input.sample.pose_D.p.z() = 1.0;
  static_cast<void>(renderTick(input, this->setup_.parameters, this->state_));
  this->state_.velocity = {};
  this->state_.tracked = false;
  this->state_.ownForce = false; // nor is the hand's force of before known
}

const HapticState& WallRig::tick()
{
  TickInput input;
  input.tick = ++this->tick_;
  input.dt_s = this->setup_.period_s;
  input.scene = this->floor_.get();
  input.status = this->device_.read(static_cast<double>(this->tick_ - 1) * this->setup_.period_s, input.sample);
  this->output_ = renderTick(input, this->setup_.parameters, this->state_);
  if (this->setup_.afterwards)
  {
    this->output_.state.force_D = this->output_.command.wrench_D.force = this->setup_.afterwards(this->output_.state);
  }
  this->device_.write(this->output_.command);
  return this->output_.state;
}

} // namespace palpate::lab
