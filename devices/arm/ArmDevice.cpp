// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/ArmDevice.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "haptics/arm/ArmMeasures.h"

namespace palpate
{
namespace
{

constexpr int exchangePriority = 19; ///< just below the servo
constexpr int noDevice_ms = 5;
constexpr double forgottenAfter_s = 0.012; ///< an arm of which nothing new is heard; an answer is waited for 5 ms
constexpr auto longestWait = std::chrono::milliseconds(4);

void describe(const ArmPlan& plan, DeviceInfo& info)
{
  const Arm arm(plan);
  const bool planar = arm.directions() == 2;
  info.deviceClass = planar ? DeviceClass::Joystick2D : DeviceClass::Point3D;
  info.abilities.sensedAxes = planar ? 2 : arm.joints() == mostJoints ? 6 : 3;
  info.workspaceRadius_m = { plan.workSpace.radius_m, plan.workSpace.radius_m > 0.0 };
  info.maxForce_N = { plan.maxForce_N, std::isfinite(plan.maxForce_N) };
  info.maxStiffness_N_per_m = { plan.maxStiffness_N_per_m, std::isfinite(plan.maxStiffness_N_per_m) };
  info.maxDamping_Ns_per_m = { plan.maxDamping_Ns_per_m, std::isfinite(plan.maxDamping_Ns_per_m) };
  if (const std::optional<JointVector> middle = arm.inverse(plan.workSpace.centre_D))
  {
    const double motors_N = measure(arm, *middle).leastForce_N;
    info.resolution_m = { countStepOf(arm, *middle), true };
    const bool told = std::isfinite(motors_N) && motors_N > 0.0 && !info.maxForce_N.known;
    info.maxForce_N = told ? DeviceQuantity{ motors_N, true } : info.maxForce_N;
  }
}

} // namespace

DeviceInfo armInfo(const std::string& name, const HidEntry& entry, const ArmSetup& setup)
{
  DeviceInfo info;
  info.name = name;
  info.serial = entry.serial;
  info.pacing = setup.pacing;
  info.knowsAxes = true;
  info.abilities.sensedAxes = setup.turns ? 6 : 3;
  info.workspaceRadius_m = setup.radius_m;
  info.maxForce_N = setup.force_N;
  if (setup.plan)
  {
    describe(*setup.plan, info);
  }
  return info;
}

ArmDevice::ArmDevice(const std::string& name, const std::shared_ptr<ArmBus>& bus, const HidEntry& entry,
  const ArmSetup& setup, const ArmDeviceOptions& options)
  : info_(armInfo(name, entry, setup)), setup_(setup), options_(options), bell_(std::make_shared<AnswerBell>()),
    link_(options.clock,
      [bus, entry, setup](const Clock& clock) { return std::make_shared<ArmLink>(bus, entry, setup, clock); })
{
  this->info_.maxForce_N.value = std::min(this->info_.maxForce_N.value, unproven_N);
}

void ArmDevice::prove() noexcept
{
  this->info_.maxForce_N = armInfo(this->info_.name, {}, this->setup_).maxForce_N;
}

std::string ArmDevice::open()
{
  if (!this->setup_.problem.empty())
  {
    return "\"" + this->info_.name + "\": " + this->setup_.problem;
  }
  this->link_->limit(this->info_.maxForce_N.value);
  this->heardOf_ = this->link_->answers();
  if (!this->options_.threads)
  {
    return this->link_.open({});
  }
  const auto period = std::chrono::duration<double>(this->setup_.period_s);
  const auto work = [bell = this->bell_, period](ArmLink& link)
  {
    const auto pass = [&link, bell, period]
    {
      const auto next = std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::nanoseconds>(period);
      const std::uint64_t before = link.answers();
      const bool there = link.pass();
      if (link.answers() != before)
      {
        bell->ring();
      }
      if (there)
      {
        std::this_thread::sleep_until(next);
      }
      return there;
    };
    return ServedLink<ArmLink>::Work{ { pass, noDevice_ms, exchangePriority, [&link] { link.detach(); }, {} } };
  };
  return this->link_.open(work);
}

void ArmDevice::await() noexcept
{
  static_cast<void>(this->bell_->await(longestWait));
}

/// An exchange that hangs says nothing: the servo sees it by the time since the last answer.
DeviceStatus ArmDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  const std::uint64_t answers = this->link_->answers();
  if (answers != this->heardOf_ || tickTime_s < this->heardAt_s_)
  {
    this->heardOf_ = answers;
    this->heardAt_s_ = tickTime_s;
  }
  const HandExchange::Heard heard = this->link_->heard();
  const bool forgotten = tickTime_s - this->heardAt_s_ > forgottenAfter_s;
  if (!heard.there)
  {
    return DeviceStatus::Lost;
  }
  if (!heard.hand)
  {
    return DeviceStatus::Waiting;
  }
  sample = {};
  sample.time_s = tickTime_s;
  sample.pose_D = { heard.hand->p_D, heard.hand->q_D };
  sample.velocity_D = heard.hand->velocity_D;
  sample.buttons = heard.hand->buttons;
  sample.grip = heard.hand->grip;
  return forgotten ? DeviceStatus::Lost : DeviceStatus::Ok;
}

} // namespace palpate
