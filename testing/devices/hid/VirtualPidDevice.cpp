// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/VirtualPidDevice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "devices/hid/report/PidUsages.h"
#include "devices/hid/report/ReportBits.h"
#include "testing/devices/hid/ReportWithId.h"

namespace palpate::test
{
namespace
{

constexpr std::uint8_t constantType = 0x26, sineType = 0x31, springType = 0x40, damperType = 0x41;
constexpr std::uint8_t success = 1, full = 2, error = 3;
constexpr std::size_t longestQueue = 64;
constexpr HidUsage ramPoolAvailable = pid::page | 0xAC;

/// Of a number, its share of the largest.
double share(const PidNumber* number, std::int64_t value, double otherwise)
{
  return number == nullptr ? otherwise : static_cast<double>(value) / static_cast<double>(number->max);
}

} // namespace

VirtualPidDevice::VirtualPidDevice(const PidLayout& layout)
  : layout_(layout), descriptor_(parseReportDescriptor(descriptorOf(layout))),
    effects_(static_cast<std::size_t>(layout.slots)), centring_(layout.habits.wakesCentred)
{
}

std::int64_t VirtualPidDevice::number(
  const HidReport& report, std::span<const std::uint8_t> bytes, HidUsage usage, HidUsage parent) const
{
  const HidControl control = findControl(report, usage, parent);
  return control ? readControl(control, bytes) : 0;
}

std::uint8_t VirtualPidDevice::chosen(const std::vector<std::uint8_t>& order, std::int64_t number) const
{
  return number >= 1 && number <= static_cast<std::int64_t>(order.size()) ? order[static_cast<std::size_t>(number - 1)]
                                                                          : 0;
}

bool VirtualPidDevice::take(HidReportKind kind, std::span<const std::uint8_t> bytes)
{
  const HidReport* report = bytes.empty() ? nullptr : reportWithId(this->descriptor_, kind, bytes[0]);
  if (report == nullptr || bytes.size() != report->bytes())
  {
    ++this->badReports;
    return false;
  }
  if (kind == HidReportKind::Feature)
  {
    this->create(*report, bytes);
    return true;
  }
  ++this->outputs;
  if (bytes[0] == this->layout_.controlId)
  {
    this->control(*report, bytes);
    return true;
  }
  if (bytes[0] == this->layout_.gainId)
  {
    this->gain = static_cast<double>(this->number(*report, bytes, pid::deviceGain)) / 255.0;
    return true;
  }
  const bool good = this->takeEffect(*report, bytes);
  this->badReports += good ? 0 : 1;
  return good;
}

void VirtualPidDevice::create(const HidReport& report, std::span<const std::uint8_t> bytes)
{
  const HidControl type = findControl(report, 0x0F0000U | this->layout_.effects.front());
  this->create(this->chosen(this->layout_.effects, readControl({ &report, type.field, 0 }, bytes)));
}

void VirtualPidDevice::create(std::uint8_t wanted)
{
  const auto slot =
    std::find_if(this->effects_.begin(), this->effects_.end(), [](const Effect& effect) { return !effect.allocated; });
  this->lastBlock_ = 0;
  this->lastStatus_ = wanted == 0 ? error : slot == this->effects_.end() ? full : success;
  if (this->lastStatus_ == success)
  {
    *slot = {};
    slot->allocated = true;
    slot->type = wanted;
    this->lastBlock_ = static_cast<int>(slot - this->effects_.begin()) + 1;
  }
}

bool VirtualPidDevice::takeEffect(const HidReport& report, std::span<const std::uint8_t> bytes)
{
  const std::int64_t block = this->number(report, bytes, pid::blockIndex);
  if (block < 1 || block > this->layout_.slots || !this->effects_[static_cast<std::size_t>(block - 1)].allocated)
  {
    return false;
  }
  Effect& effect = this->effects_[static_cast<std::size_t>(block - 1)];
  const std::uint8_t id = report.id;
  if (id == this->layout_.setEffectId)
  {
    this->setEffect(effect, report, bytes);
  }
  else if (id == this->layout_.conditionId)
  {
    return this->setCondition(effect, report, bytes);
  }
  else if (id == this->layout_.constantId)
  {
    ++this->constantForces;
    effect.constant = share(&this->layout_.magnitude, this->number(report, bytes, pid::magnitude), 0.0);
  }
  else if (id == this->layout_.periodicId)
  {
    effect.magnitude = static_cast<double>(this->number(report, bytes, pid::magnitude)) / 10000.0;
    effect.period_ms = static_cast<double>(std::max<std::int64_t>(1, this->number(report, bytes, pid::period)));
  }
  else if (id == this->layout_.operationId)
  {
    this->operate(effect, report, bytes);
  }
  else if (id == this->layout_.freeId)
  {
    effect = {};
  }
  return true;
}

void VirtualPidDevice::setEffect(Effect& effect, const HidReport& report, std::span<const std::uint8_t> bytes)
{
  effect.duration_ms = this->number(report, bytes, pid::duration);
  effect.gain =
    this->layout_.hasEffectGain ? static_cast<double>(this->number(report, bytes, pid::effectGain)) / 255.0 : 1.0;
  effect.axes = { this->number(report, bytes, pid::axisX, pid::axesEnable) != 0,
    this->number(report, bytes, pid::axisY, pid::axesEnable) != 0 };
  effect.directed = this->number(report, bytes, pid::directionEnable) != 0;
  const std::int64_t turned = this->number(report, bytes, pid::firstOrdinal, pid::direction);
  effect.direction_deg = 360.0 * static_cast<double>(turned) / static_cast<double>(this->layout_.wholeTurn);
  effect.trigger = this->number(report, bytes, pid::triggerButton);
  effect.set = true;
  this->settle(effect);
}

/// Of a firmware that counts conditions from here on, the factor of each axis is 1 at 90 degrees with the direction
/// enabled, and -1 at 0 without.
void VirtualPidDevice::settle(Effect& effect)
{
  effect.conditions = effect.told;
  if (this->layout_.habits.conditions == ConditionOrder::OnlyWithSetEffect)
  {
    const bool right = effect.directed && std::fabs(effect.direction_deg - 90.0) < 2.0;
    effect.signs.fill(right ? 1.0 : -1.0);
  }
}

bool VirtualPidDevice::setCondition(Effect& effect, const HidReport& report, std::span<const std::uint8_t> bytes)
{
  const std::int64_t axis = this->number(report, bytes, pid::parameterOffset);
  if (axis < 0 || axis > 1)
  {
    return false;
  }
  ++this->conditions;
  const ConditionOrder order = this->layout_.habits.conditions;
  if (order == ConditionOrder::OnlyAfterSetEffect && !effect.set)
  {
    return true;
  }
  const auto of = [&](std::uint8_t usage, double otherwise)
  { return share(this->layout_.conditionNumber(usage), this->number(report, bytes, 0x0F0000U | usage), otherwise); };
  Condition& condition = effect.told[static_cast<std::size_t>(axis)];
  condition.centre = of(0x60, 0.0);
  condition.positiveCoefficient = of(0x61, 0.0);
  condition.negativeCoefficient = of(0x62, condition.positiveCoefficient);
  condition.positiveSaturation = of(0x63, 1.0);
  condition.negativeSaturation = of(0x64, 1.0);
  condition.deadBand = of(0x65, 0.0);
  if (order != ConditionOrder::OnlyWithSetEffect)
  {
    effect.conditions = effect.told;
  }
  return true;
}

void VirtualPidDevice::operate(Effect& effect, const HidReport& report, std::span<const std::uint8_t> bytes)
{
  const HidControl choice = findControl(report, pid::start);
  const std::uint8_t wanted = this->chosen(this->layout_.operations, readControl({ &report, choice.field, 0 }, bytes));
  if (wanted == 0x7A)
  {
    for (Effect& other : this->effects_)
    {
      this->play(other, false);
    }
  }
  this->play(effect, wanted != 0x7B);
}

void VirtualPidDevice::play(Effect& effect, bool playing)
{
  effect.age_ms = 0;
  if (effect.playing != playing)
  {
    effect.playing = playing;
    this->showState(static_cast<int>(&effect - this->effects_.data()) + 1, playing);
  }
}

void VirtualPidDevice::control(const HidReport& report, std::span<const std::uint8_t> bytes)
{
  if (!this->layout_.controlBits)
  {
    const HidControl choice = findControl(report, pid::stopAll);
    this->control(this->chosen(this->layout_.controls, readControl({ &report, choice.field, 0 }, bytes)));
    return;
  }
  for (const std::uint8_t usage : this->layout_.controls)
  {
    if (this->number(report, bytes, 0x0F0000U | usage) != 0)
    {
      this->control(usage);
    }
  }
}

void VirtualPidDevice::control(std::uint8_t usage)
{
  switch (usage)
  {
    case 0x97:
    case 0x98:
      this->actuators = usage == 0x97;
      this->showState(0, false);
      break;
    case 0x99:
      this->stopAll();
      break;
    case 0x9A:
      this->reset();
      break;
    default:
      break;
  }
}

void VirtualPidDevice::stopAll()
{
  ++this->stopAlls;
  this->centring_ = false;
  if (this->layout_.habits.stopAllDisables)
  {
    this->actuators = false;
    this->showState(0, false);
    return;
  }
  for (Effect& effect : this->effects_)
  {
    this->play(effect, false);
  }
}

void VirtualPidDevice::reset()
{
  ++this->resets;
  this->centring_ = this->layout_.habits.wakesCentred;
  if (!this->layout_.habits.wipesSilently)
  {
    for (Effect& effect : this->effects_)
    {
      this->play(effect, false);
    }
  }
  this->effects_.assign(this->effects_.size(), {});
  this->actuators = !this->layout_.habits.stopAllDisables;
  this->showState(0, false);
}

void VirtualPidDevice::uploadFromElsewhere()
{
  this->reset();
  this->actuators = true;
  this->create(constantType);
}

/// A button that goes down plays the effects that are bound to it, whoever bound them and whenever.
void VirtualPidDevice::pullTrigger()
{
  const unsigned pressed = this->buttons & ~unsigned{ this->buttonsBefore_ };
  this->buttonsBefore_ = this->buttons;
  for (Effect& effect : this->effects_)
  {
    const bool bound = this->layout_.habits.bindsTrigger && effect.set && effect.trigger < 8;
    if (bound && (pressed >> effect.trigger & 1U) != 0)
    {
      this->play(effect, true);
    }
  }
}

std::vector<std::uint8_t> VirtualPidDevice::feature(std::uint8_t id)
{
  const HidReport* report = reportWithId(this->descriptor_, HidReportKind::Feature, id);
  if (report == nullptr || id == 0)
  {
    return {};
  }
  std::vector<std::uint8_t> bytes(report->bytes());
  bytes[0] = id;
  const auto put = [&](HidUsage usage, std::int64_t value) { writeControl(findControl(*report, usage), bytes, value); };
  if (id == this->layout_.poolId)
  {
    put(pid::largestEffectCount, this->layout_.slots);
    put(pid::deviceManaged, this->layout_.deviceManaged ? 1 : 0);
  }
  else if (id == this->layout_.loadId)
  {
    if (this->wrongLoad)
    {
      return *this->wrongLoad;
    }
    if (this->slowLoads > 0)
    {
      --this->slowLoads;
      return bytes;
    }
    put(pid::blockIndex, this->lastBlock_);
    put(ramPoolAvailable, this->layout_.slots - this->effectsUsed());
    writeControl({ report, findControl(*report, pid::loaded).field, 0 }, bytes, this->lastStatus_);
  }
  return bytes;
}

std::vector<std::uint8_t> VirtualPidDevice::nextInput()
{
  if (this->inputs_.empty())
  {
    return {};
  }
  std::vector<std::uint8_t> oldest = std::move(this->inputs_.front());
  this->inputs_.pop_front();
  return oldest;
}

void VirtualPidDevice::showState(int block, bool playing)
{
  const HidReport* report = reportWithId(this->descriptor_, HidReportKind::Input, this->layout_.stateId);
  if (this->layout_.stateId == 0 || report == nullptr)
  {
    return;
  }
  std::vector<std::uint8_t> bytes(report->bytes());
  bytes[0] = report->id;
  writeControl(findControl(*report, pid::actuatorsEnabled), bytes, this->actuators ? 1 : 0);
  writeControl(findControl(*report, pid::actuatorPower), bytes, 1);
  writeControl(findControl(*report, pid::effectPlaying), bytes, playing ? 1 : 0);
  writeRaw(findControl(*report, pid::blockIndex), bytes, block);
  this->inputs_.push_back(std::move(bytes));
}

void VirtualPidDevice::showInput()
{
  if (this->silent)
  {
    return;
  }
  const HidReport* report = reportWithId(this->descriptor_, HidReportKind::Input, this->layout_.inputId);
  std::vector<std::uint8_t> bytes(report->bytes());
  bytes[0] = report->id;
  const auto low = static_cast<double>(this->layout_.axis.min), high = static_cast<double>(this->layout_.axis.max);
  for (std::size_t axis = 0; axis < this->layout_.axes; ++axis)
  {
    const double at = this->position[axis];
    const double shown = low < 0.0 ? at * high : low + 0.5 * (at + 1.0) * (high - low);
    writeControl(findControl(*report, axis == 0 ? pid::axisX : pid::axisY), bytes, std::llround(shown));
  }
  for (std::uint32_t button = 0; button < 8; ++button)
  {
    writeControl(findControl(*report, pid::buttonPage + 1 + button), bytes, (this->buttons >> button) & 1);
  }
  this->inputs_.push_back(std::move(bytes));
  while (this->inputs_.size() > longestQueue)
  {
    this->inputs_.pop_front();
  }
}

void VirtualPidDevice::advance(int duration_ms)
{
  for (int i = 0; i < duration_ms; ++i)
  {
    this->pullTrigger();
    this->advanceHandle([this] { return this->force(); });
    this->showInput();
    for (Effect& effect : this->effects_)
    {
      ++effect.age_ms;
      if (effect.playing && effect.age_ms > effect.duration_ms)
      {
        this->play(effect, false);
      }
    }
  }
}

VirtualPidDevice::Axes VirtualPidDevice::force() const
{
  Axes sum{};
  for (const Effect& effect : this->effects_)
  {
    for (std::size_t axis = 0; effect.playing && axis < 2; ++axis)
    {
      sum[axis] += this->effectForce(effect, axis);
    }
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const bool moved = axis == 0 || !this->layout_.habits.oneMotor;
    const double centring = this->centring_ ? -centringGain * this->position[axis] : 0.0;
    const double effects = this->actuators ? this->gain * std::clamp(sum[axis], -1.0, 1.0) : 0.0;
    sum[axis] = moved ? effects + centring : 0.0;
  }
  return sum;
}

double VirtualPidDevice::effectForce(const Effect& effect, std::size_t axis) const
{
  if (effect.type == springType || effect.type == damperType)
  {
    const double metric = effect.type == springType ? this->position[axis] : damperMetric * this->velocity[axis];
    if (this->layout_.habits.deadConditions)
    {
      return 0.0;
    }
    Condition scaled = effect.conditions[axis];
    scaled.positiveCoefficient *= springGain;
    scaled.negativeCoefficient *= springGain;
    return effect.gain * effect.signs[axis] * conditionForce(scaled, metric);
  }
  const double turn = effect.direction_deg * std::numbers::pi / 180.0;
  const double from = !effect.directed ? (effect.axes[axis] ? -1.0 : 0.0)
                      : axis == 0      ? std::sin(turn)
                                       : -std::cos(turn);
  const double along = this->layout_.habits.pointsTo ? from : -from;
  if (effect.type == constantType)
  {
    return effect.gain * effect.constant * along;
  }
  const double age = static_cast<double>(effect.age_ms) / effect.period_ms;
  return effect.type == sineType ? effect.gain * effect.magnitude * std::sin(2.0 * std::numbers::pi * age) * along
                                 : 0.0;
}

int VirtualPidDevice::effectsUsed() const
{
  return static_cast<int>(
    std::count_if(this->effects_.begin(), this->effects_.end(), [](const Effect& effect) { return effect.allocated; }));
}

int VirtualPidDevice::effectsPlaying() const
{
  return static_cast<int>(
    std::count_if(this->effects_.begin(), this->effects_.end(), [](const Effect& effect) { return effect.playing; }));
}

const Condition& VirtualPidDevice::condition(int block, int axis) const
{
  return this->effects_.at(static_cast<std::size_t>(block - 1)).told.at(static_cast<std::size_t>(axis));
}

} // namespace palpate::test
