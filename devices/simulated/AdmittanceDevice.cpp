// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/AdmittanceDevice.h"

#include <cmath>
#include <utility>

namespace palpate
{

double stiffestHold(const AdmittancePlan& plan) noexcept
{
  const double M = plan.mass_kg, B = plan.damping_Ns_per_m, lag_s = plan.lag_s + plan.period_s;
  return B * (M + B * lag_s) / (M * lag_s);
}

AdmittanceDevice::AdmittanceDevice(const AdmittancePlan& plan, HandModel hand, HandPath path)
  : plan_(plan), hand_(std::move(hand)), path_(std::move(path)),
    virtual_(plan.mass_kg, plan.damping_Ns_per_m, 0.0, plan.period_s), follow_(-std::expm1(-plan.period_s / plan.lag_s))
{
  this->info_.name = "simulated-admittance";
  this->info_.causality = Causality::Admittance;
  this->info_.simulated = true;
  this->info_.workspaceRadius_m = { plan.workspaceRadius_m, true };
  this->info_.mass_kg = { plan.mass_kg, true };
  this->info_.damping_Ns_per_m = { plan.damping_Ns_per_m, true };
}

std::string AdmittanceDevice::open()
{
  std::string problem = this->path_.refusal();
  if (!problem.empty())
  {
    return problem;
  }
  this->mass_D_ = this->handle_D_ = this->path_.start_D();
  this->massSpeed_D_.setZero();
  this->handleSpeed_D_.setZero();
  this->command_ = DeviceCommand{};
  this->command_.target.pose_D.p = this->mass_D_;
  this->hand_N_.setZero();
  this->noiseState_ = 1;
  this->time_s_ = 0.0;
  return {};
}

/// Uniform, by a linear congruence (Knuth, The Art of Computer Programming 2, 3.3.4): the same in every run.
Vec3 AdmittanceDevice::noise() noexcept
{
  Vec3 noise;
  for (double& component : noise)
  {
    this->noiseState_ = this->noiseState_ * 6364136223846793005ull + 1442695040888963407ull;
    component = this->plan_.noise_N * (std::ldexp(static_cast<double>(this->noiseState_ >> 11), -52) - 1.0);
  }
  return noise;
}

void AdmittanceDevice::advance() noexcept
{
  const double T = this->plan_.period_s;
  const Vec3 led_D = this->path_.at_D(this->time_s_).p;
  const Vec3 ledSpeed_D = (this->path_.at_D(this->time_s_ + T).p - led_D) / T;
  this->hand_N_ = this->hand_.stiffness_N_per_m * (led_D - this->handle_D_) +
                  this->hand_.damping_Ns_per_m * (ledSpeed_D - this->handleSpeed_D_);
  this->sensed_N_ = this->hand_N_ + this->noise();
  const Vec3 way = this->follow_ * (this->command_.target.pose_D.p - this->handle_D_);
  this->handle_D_ += way;
  this->handleSpeed_D_ = way / T;
  this->virtual_.step(this->mass_D_, this->massSpeed_D_, this->sensed_N_ + this->command_.wrench_D.force);
  this->time_s_ += T;
}

DeviceStatus AdmittanceDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  // Half a period of tolerance: tick times are multiples of the period, computed once more by the caller.
  constexpr int mostPeriods = 1000;
  for (int k = 0; k < mostPeriods && this->time_s_ + 0.5 * this->plan_.period_s < tickTime_s; ++k)
  {
    this->advance();
  }
  sample = DeviceSample{};
  sample.time_s = tickTime_s;
  sample.pose_D.p = this->mass_D_;
  sample.velocity_D.linear = this->massSpeed_D_;
  sample.sensed_D.force = this->sensed_N_;
  sample.grip = true;
  return DeviceStatus::Ok;
}

} // namespace palpate
