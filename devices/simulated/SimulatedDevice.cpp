// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/SimulatedDevice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "devices/common/BareSprings.h"
#include "devices/simulated/ArmPlant.h"
#include "devices/simulated/MassPart.h"

namespace palpate
{
namespace
{

int passesOf(const DeviceModel& model, const SimulationOptions& options)
{
  constexpr double rounding = 1e-9;
  return model.loop_s > 0.0
           ? std::max(1, static_cast<int>(std::ceil(options.period_s / model.loop_s * (1.0 - rounding))))
           : 1;
}

std::unique_ptr<MovingPart> partOf(const DeviceModel& model, const HandModel& hand, double period_s)
{
  if (model.arm)
  {
    return std::make_unique<ArmPlant>(*model.arm, hand, period_s);
  }
  return std::make_unique<MassPart>(model, hand, period_s);
}

} // namespace

SimulatedDevice::SimulatedDevice(DeviceModel model, HandModel hand, HandPath path, const SimulationOptions& options)
  : info_(infoOf(model)), model_(std::move(model)), hand_(std::move(hand)), path_(std::move(path)), options_(options),
    parts_(passesOf(model_, options)), part_(partOf(model_, hand_, options.period_s / parts_)),
    link_(model_.link_B_per_s)
{
  if (this->model_.turns())
  {
    this->turning_.emplace(this->model_.turning, this->hand_.turning, options.period_s);
  }
}

std::string SimulatedDevice::refusal() const
{
  std::string path = this->path_.refusal();
  if (!path.empty())
  {
    return path;
  }
  if (!(this->options_.period_s > 0.0))
  {
    return "the simulated device's period [s] must be above zero";
  }
  if (this->options_.delay_ticks < 0 || this->options_.delay_ticks > SimulationOptions::longestDelay_ticks)
  {
    return "the simulated device's delay must be 0 to 16 ticks";
  }
  return {};
}

std::string SimulatedDevice::open()
{
  std::string problem = this->refusal();
  if (!problem.empty())
  {
    return problem;
  }
  Vec3 p_D = this->path_.start_D(), v_D = this->options_.velocity_D;
  if (this->model_.planar)
  {
    p_D.z() = v_D.z() = 0.0;
  }
  if (!this->part_->begin(p_D, v_D))
  {
    return "the simulated hand's path begins out of the reach of the arm";
  }
  if (this->turning_)
  {
    this->turning_->begin(Quat::Identity());
  }
  this->commands_.fill(DeviceCommand{});
  this->link_ = SerialLink(this->model_.link_B_per_s);
  this->time_s_ = 0.0;
  return {};
}

void SimulatedDevice::lead(const Vec3& target_D) noexcept
{
  this->lead(Pose{ target_D, this->led_ ? this->programmed_D_.q : this->path_.at_D(this->time_s_).q });
}

void SimulatedDevice::lead(const Pose& target_D) noexcept
{
  if (!this->led_)
  {
    this->reached_D_ = this->path_.at_D(this->time_s_);
  }
  this->led_ = true;
  this->programmed_D_ = target_D;
}

std::pair<Pose, Pose> SimulatedDevice::ledAlong() noexcept
{
  if (!this->led_)
  {
    return { this->path_.at_D(this->time_s_), this->path_.at_D(this->time_s_ + this->options_.period_s) };
  }
  return { std::exchange(this->reached_D_, this->programmed_D_), this->programmed_D_ };
}

void SimulatedDevice::write(const DeviceCommand& command) noexcept
{
  DeviceCommand& newest = this->commands_[static_cast<std::size_t>(this->newest_)];
  newest = command;
  if (this->model_.bareSprings)
  {
    switchSprings(this->part_->shown_D(), newest);
  }
}

DeviceCommand SimulatedDevice::due() noexcept
{
  constexpr int slots = SimulationOptions::longestDelay_ticks + 1;
  const DeviceCommand due =
    this->commands_[static_cast<std::size_t>((this->newest_ - this->options_.delay_ticks + slots) % slots)];
  const int latest = this->newest_;
  // The last command holds until another one is written.
  this->newest_ = (this->newest_ + 1) % slots;
  this->commands_[static_cast<std::size_t>(this->newest_)] = this->commands_[static_cast<std::size_t>(latest)];
  return due;
}

Condition SimulatedDevice::springOf(const DeviceWall& wall) const noexcept
{
  const double stiffness_N_per_m = std::min(wall.stiffness_N_per_m, this->info_.heldStiffness_N_per_m.value);
  if (this->model_.bareSprings)
  {
    return bareSpring(wall.offset_m, stiffness_N_per_m);
  }
  Condition spring = lowerWall(wall.offset_m, stiffness_N_per_m);
  spring.negativeSaturation = wall.largest_N;
  return spring;
}

Vec3 SimulatedDevice::motorForce(const DeviceCommand& command) const noexcept
{
  Vec3 force = command.wrench_D.force;
  const std::size_t walls =
    this->model_.loop_s > 0.0 ? std::min<std::size_t>(command.wallCount, command.walls.size()) : 0;
  for (std::size_t i = 0; i < walls; ++i)
  {
    const DeviceWall& wall = command.walls[i];
    force += conditionForce(this->springOf(wall), wall.normal_D.dot(this->part_->shown_D())) * wall.normal_D;
  }
  if (this->model_.loop_s > 0.0)
  {
    Condition braking = damper(command.viscosity_Ns_per_m);
    braking.positiveSaturation = braking.negativeSaturation = command.brakeLargest_N;
    const Vec3 speed_D = this->speed_D(); // the true one: firmware has a finer clock than its encoder has steps
    for (int axis = 0; axis < 3; ++axis)
    {
      force[axis] += conditionForce(braking, speed_D[axis]);
    }
  }
  if (this->model_.planar)
  {
    force.z() = 0.0; // no motor along z, so that z takes no part of the largest force
  }
  const double magnitude = force.norm();
  return magnitude > this->model_.maxForce_N ? Vec3(this->model_.maxForce_N / magnitude * force) : force;
}

void SimulatedDevice::advance() noexcept
{
  const double T = this->options_.period_s;
  const auto [before, after] = this->ledAlong();
  const Vec3 led = this->hand_.stiffness_N_per_m * after.p + this->hand_.damping_Ns_per_m / T * (after.p - before.p);
  const DeviceCommand command = this->link_.carry(this->due(), this->time_s_);
  for (int pass = 0; pass < this->parts_; ++pass)
  {
    this->part_->step(led + this->options_.push_D, { this->motorForce(command), Vec3::Zero() });
  }
  if (this->turning_)
  {
    this->turning_->step(before.q, after.q, command.wrench_D.torque);
  }
  this->time_s_ += T;
}

DeviceStatus SimulatedDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  // Half a period of tolerance: tick times are multiples of the period, computed once more by the caller.
  constexpr int mostPeriods = 1000;
  for (int k = 0; k < mostPeriods && this->time_s_ + 0.5 * this->options_.period_s < tickTime_s; ++k)
  {
    this->advance();
  }
  sample = DeviceSample{};
  sample.time_s = tickTime_s;
  sample.pose_D = { this->part_->shown_D(), this->turning_ ? this->turning_->shown_D() : Quat::Identity() };
  sample.velocity_D.linear = this->model_.encoderStep_m > 0.0 ? Vec3(Vec3::Zero()) : this->speed_D();
  const bool showsRate = this->turning_ && this->model_.turning.step_rad == 0.0;
  sample.velocity_D.angular = showsRate ? this->turning_->rate_D() : Vec3(Vec3::Zero());
  sample.grip = true;
  sample.buttons = this->buttons_;
  return DeviceStatus::Ok;
}

} // namespace palpate
