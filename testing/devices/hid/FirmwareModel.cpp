// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/FirmwareModel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "devices/hid/report/PidUsages.h"
#include "devices/hid/report/ReportBits.h"
#include "testing/devices/hid/VirtualPidDevice.h"

namespace palpate::test
{
namespace
{

enum Report : std::uint8_t
{
  Settings = 1,
  SetCondition = 3,
  Periodic = 4,
  ConstantForce = 5,
  Operation = 10,
  Free = 11,
  Control = 12,
  Gain = 13,
};

std::uint16_t word(std::span<const std::uint8_t> bytes, std::size_t at)
{
  return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
}

double signedWord(std::span<const std::uint8_t> bytes, std::size_t at)
{
  return static_cast<std::int16_t>(word(bytes, at));
}

} // namespace

FirmwareModel::FirmwareModel(std::span<const std::uint8_t> descriptor, const ModelWire& wire)
  : descriptor_(parseReportDescriptor(descriptor)), wire_(wire),
    effects_(static_cast<std::size_t>(wire.firstBlock + wire.blocks))
{
}

bool FirmwareModel::take(HidReportKind kind, std::span<const std::uint8_t> bytes)
{
  if (kind == HidReportKind::Feature)
  {
    this->create(bytes[1]);
    return true;
  }
  const std::size_t block = bytes[1];
  if (bytes[0] == Control)
  {
    this->control(bytes[1]);
  }
  else if (bytes[0] == Gain)
  {
    this->gain = bytes[1] / 255.0;
  }
  else if (block >= this->effects_.size() || !this->effects_[block].used)
  {
    ++this->badReports;
  }
  else if (bytes[0] == Settings)
  {
    this->settings(this->effects_[block], bytes);
  }
  else if (bytes[0] == SetCondition)
  {
    this->condition(this->effects_[block], bytes);
  }
  else if (bytes[0] == Periodic)
  {
    this->effects_[block].magnitude =
      this->wire_.oneCoefficient ? bytes[2] / 255.0 : word(bytes, 2) / this->wire_.forces;
    this->effects_[block].period_ms =
      std::max(1.0, static_cast<double>(word(bytes, this->wire_.oneCoefficient ? 5 : 8)));
  }
  else if (bytes[0] == ConstantForce)
  {
    this->effects_[block].magnitude = signedWord(bytes, 2) / this->wire_.forces;
  }
  else if (bytes[0] == Operation)
  {
    this->operate(this->effects_[block], bytes[2]);
  }
  else if (bytes[0] == Free)
  {
    this->effects_[block] = {};
  }
  return true;
}

void FirmwareModel::create(std::uint8_t type)
{
  const auto free = std::find_if(this->effects_.begin() + this->wire_.firstBlock, this->effects_.end(),
    [](const Effect& effect) { return !effect.used; });
  this->lastBlock_ = free == this->effects_.end() ? 0 : static_cast<int>(free - this->effects_.begin());
  if (this->lastBlock_ > 0)
  {
    *free = {};
    free->used = true;
    free->type = type;
  }
}

void FirmwareModel::settings(Effect& effect, std::span<const std::uint8_t> bytes)
{
  const std::size_t at = this->wire_.startDelay ? 11 : 9;
  effect.type = bytes[2];
  effect.duration_ms = word(bytes, 3);
  effect.gain = bytes[at] / 255.0;
  effect.trigger = bytes[at + 1];
  effect.axes = bytes[at + 2];
  const double turned = this->wire_.directionBytes == 1 ? bytes[at + 3] : word(bytes, at + 3);
  effect.angle_rad = 2.0 * std::numbers::pi * turned / this->wire_.turn;
  this->settingsCame(effect);
}

void FirmwareModel::condition(Effect& effect, std::span<const std::uint8_t> bytes)
{
  const std::size_t axis = std::min(bytes[2] & 15, 1);
  Condition& told = effect.conditions[axis];
  const double all = this->wire_.conditions;
  if (this->wire_.oneCoefficient)
  {
    told.centre = static_cast<std::int8_t>(bytes[3]) / 127.0;
    told.positiveCoefficient = told.negativeCoefficient = static_cast<std::int8_t>(bytes[4]) / 127.0;
  }
  else
  {
    told = { signedWord(bytes, 3) / all, word(bytes, 13) / all, signedWord(bytes, 5) / all, signedWord(bytes, 7) / all,
      word(bytes, 9) / all, word(bytes, 11) / all };
  }
  effect.conditionsSeen |= 1U << axis;
  this->conditionCame(effect, axis);
}

void FirmwareModel::operate(Effect& effect, int operation)
{
  if (operation == 2)
  {
    this->stopAll();
  }
  effect.age_ms = 0;
  effect.playing = false;
  if (operation != 3)
  {
    this->started(effect);
  }
}

void FirmwareModel::stopAll()
{
  for (Effect& effect : this->effects_)
  {
    effect.playing = false;
  }
}

void FirmwareModel::wipe()
{
  std::fill(this->effects_.begin(), this->effects_.end(), Effect{});
}

std::vector<std::uint8_t> FirmwareModel::feature(std::uint8_t id)
{
  if (id == this->wire_.pool)
  {
    this->wipe(); // so do two of them
    return { id, 0xFF, 0xFF, static_cast<std::uint8_t>(this->wire_.blocks), 3 };
  }
  const std::uint8_t success = 1, full = 2;
  return { id, static_cast<std::uint8_t>(this->lastBlock_), this->lastBlock_ > 0 ? success : full, 0xFF, 0xFF };
}

std::vector<std::uint8_t> FirmwareModel::nextInput()
{
  if (this->inputs_.empty())
  {
    return {};
  }
  std::vector<std::uint8_t> oldest = std::move(this->inputs_.front());
  this->inputs_.pop_front();
  return oldest;
}

void FirmwareModel::showInput()
{
  constexpr std::size_t longestQueue = 64;
  for (const HidReport& report : this->descriptor_.reports)
  {
    const HidControl x = findControl(report, pid::axisX);
    if (report.kind != HidReportKind::Input || !x)
    {
      continue;
    }
    std::vector<std::uint8_t> bytes(report.bytes());
    bytes[0] = report.id;
    for (const std::size_t axis : { 0U, 1U })
    {
      const HidControl control = findControl(report, axis == 0 ? pid::axisX : pid::axisY);
      const auto high = static_cast<double>(x.field->logicalMax);
      writeControl(control, bytes, std::llround(this->position[axis] * high));
    }
    this->inputs_.push_back(std::move(bytes));
    break;
  }
  while (this->inputs_.size() > longestQueue)
  {
    this->inputs_.pop_front();
  }
}

void FirmwareModel::advance(int duration_ms)
{
  for (int ms = 0; ms < duration_ms; ++ms)
  {
    this->advanceHandle([this] { return this->force(); });
    this->showInput();
    for (Effect& effect : this->effects_)
    {
      ++effect.age_ms;
      effect.playing = effect.playing && effect.age_ms <= effect.duration_ms;
      this->tick(effect);
    }
  }
}

FirmwareModel::Axes FirmwareModel::force() const
{
  Axes sum{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    for (const Effect& effect : this->effects_)
    {
      sum[axis] += effect.playing ? this->forceOf(effect, axis) : 0.0;
    }
    sum[axis] = this->givesForce() ? this->gain * std::clamp(sum[axis], -1.0, 1.0) : 0.0;
    sum[axis] += this->ownForce(axis);
  }
  return sum;
}

double FirmwareModel::strength(const Effect& effect)
{
  const double wave = effect.type == Sine
                        ? std::sin(2.0 * std::numbers::pi * static_cast<double>(effect.age_ms) / effect.period_ms)
                        : 1.0;
  return effect.type == Constant || effect.type == Sine ? effect.gain * effect.magnitude * wave : 0.0;
}

double FirmwareModel::metric(const Effect& effect, std::size_t axis) const
{
  return effect.type == Spring ? this->position[axis] : VirtualPidDevice::damperMetric * this->velocity[axis];
}

} // namespace palpate::test
