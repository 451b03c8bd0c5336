// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/simulation/InfiniteWalls.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace palpate::lab
{
namespace
{

SimulatedDevice deviceOf(const AtWall& start)
{
  DeviceModel model = start.model;
  model.friction_N = 0.0;
  model.maxForce_N = model.travel_m = DeviceModel::unlimited;
  SimulationOptions options;
  options.period_s = start.period_s;
  options.push_D = { start.push_N, 0, 0 };
  options.velocity_D = { start.speed_m_per_s, 0, 0 };
  return { model, *handModel("none"), { { Vec3(start.x_m, 0, 0) } }, options };
}

} // namespace

double IntegralWall::operator()(double depth_m)
{
  constexpr double leak_s = 0.05;
  if (depth_m <= 0.0 && !this->bothSides)
  {
    this->integral_N *= std::exp(-this->period_s / leak_s);
    return 0.0;
  }
  this->integral_N += this->integral_N_per_ms * this->period_s * depth_m;
  if (!this->bothSides)
  {
    this->integral_N = std::clamp(this->integral_N, 0.0, this->most_N);
  }
  return this->stiffness_N_per_m * depth_m + this->integral_N;
}

double BrakingWall::operator()(double depth_m)
{
  const double before_m = std::exchange(this->before_m, depth_m).value_or(depth_m);
  if (depth_m <= 0.0)
  {
    return 0.0;
  }
  const double speed_m_per_s = (depth_m - before_m) / this->period_s;
  const double pulse_N = before_m <= 0.0 ? this->mass_kg * speed_m_per_s / this->period_s : 0.0;
  return std::min(this->most_N, this->stiffness_N_per_m * depth_m + pulse_N);
}

double TransientWall::operator()(double depth_m)
{
  const double before_m = std::exchange(this->before_m, depth_m).value_or(depth_m);
  if (depth_m > 0.0 && before_m <= 0.0)
  {
    this->speed_m_per_s = (depth_m - before_m) / this->period_s;
    this->since_s = 0.0;
  }
  const double transient_N = this->height_Ns_per_m * this->speed_m_per_s * std::exp(-this->since_s / this->decay_s) *
                             std::cos(2 * std::numbers::pi * this->frequency_Hz * this->since_s);
  this->since_s += this->period_s;
  return this->stiffness_N_per_m * std::max(0.0, depth_m) + transient_N;
}

WallTicks::WallTicks(const AtWall& start, WallLaw law)
  : device_(deviceOf(start)), law_(std::move(law)), period_s_(start.period_s)
{
  if (const std::string problem = this->device_.open(); !problem.empty())
  {
    throw std::invalid_argument(problem);
  }
}

double WallTicks::tick()
{
  DeviceSample sample;
  static_cast<void>(this->device_.read(this->ticks_++ * this->period_s_, sample));
  const double force_N = this->law_(sample.pose_D.p.x());
  DeviceCommand command;
  command.wrench_D.force.x() = -force_N;
  this->device_.write(command);
  // The period that follows, so that place and speed are those at its end.
  static_cast<void>(this->device_.read(this->ticks_ * this->period_s_, sample));
  return force_N;
}

} // namespace palpate::lab
