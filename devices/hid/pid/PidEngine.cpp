// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/pid/PidEngine.h"

#include <algorithm>

#include "devices/hid/pid/PidFields.h"
#include "devices/hid/pid/PidKind.h"
#include "devices/hid/report/PidNumbers.h"
#include "devices/hid/report/ReportBits.h"

namespace palpate
{
namespace
{

constexpr int afterReset_ms = 20;
constexpr int blockLoadTries = 60; // some firmwares take their time

} // namespace

PidEngine::PidEngine(HidConnection& connection, const ReportDescriptor& descriptor) noexcept
  : connection_(connection), descriptor_(descriptor)
{
}

std::string PidEngine::refusal(const ReportDescriptor& descriptor)
{
  if (!descriptor.problem.empty())
  {
    return descriptor.problem;
  }
  const auto output = [&](HidUsage usage) { return descriptor.report(HidReportKind::Output, usage) != nullptr; };
  const auto feature = [&](HidUsage usage) { return descriptor.report(HidReportKind::Feature, usage) != nullptr; };
  if (!output(pid::setEffect) || !output(pid::effectOperation))
  {
    return "no force: the device is not of the USB PID class";
  }
  if (!feature(pid::createEffect) || !feature(pid::blockLoad))
  {
    return "not supported: the device keeps its effects in a driver-managed pool, with memory managed by the host";
  }
  if (!findControl(*descriptor.report(HidReportKind::Output, pid::setEffect), pid::duration))
  {
    return "not supported: the effects of the device have no duration, so that forces would not end with the program";
  }
  return pidKind(descriptor).problem;
}

std::string PidEngine::open()
{
  std::string problem = refusal(this->descriptor_);
  if (problem.empty())
  {
    problem = this->askForPool();
  }
  if (!problem.empty())
  {
    return problem;
  }
  const bool reset = this->control(pid::reset);
  this->connection_.wait(afterReset_ms);
  if (!reset || !this->control(pid::stopAll) || !this->control(pid::enableActuators) || !this->setGain(1.0))
  {
    return "the device rejects commands: " + this->connection_.error();
  }
  this->blocks_.clear();
  return {};
}

std::string PidEngine::askForPool()
{
  const HidReport* pool = this->descriptor_.report(HidReportKind::Feature, pid::pool);
  std::vector<std::uint8_t> bytes;
  if (pool == nullptr)
  {
    return {};
  }
  if (const std::string problem = this->getFeature(*pool, bytes); !problem.empty())
  {
    return "the device does not report its effect types: " + problem;
  }
  return pid::get(*pool, bytes, pid::deviceManaged, 1) != 0
           ? ""
           : "not supported: the device keeps its effects in a driver-managed pool, with memory managed by the host";
}

void PidEngine::close() noexcept
{
  static_cast<void>(this->control(pid::stopAll));
  while (!this->blocks_.empty())
  {
    static_cast<void>(this->free(this->blocks_.back()));
  }
  static_cast<void>(this->control(pid::disableActuators));
  static_cast<void>(this->control(pid::reset));
}

bool PidEngine::supports(HidUsage type) const noexcept
{
  const HidReport* report = this->descriptor_.report(HidReportKind::Feature, pid::createEffect);
  return report != nullptr && static_cast<bool>(findSelector(*report, type));
}

ConditionAbilities conditionAbilities(const ReportDescriptor& descriptor) noexcept
{
  const HidReport* report = descriptor.report(HidReportKind::Output, pid::setCondition);
  if (report == nullptr)
  {
    return {};
  }
  const auto has = [report](HidUsage usage) { return static_cast<bool>(findControl(*report, usage)); };
  return { has(pid::positiveCoefficient) && has(pid::negativeCoefficient), has(pid::deadBand),
    has(pid::positiveSaturation) };
}

PidEngine::Created PidEngine::create(HidUsage type)
{
  std::string problem = this->request(type);
  if (!problem.empty())
  {
    return { 0, std::move(problem) };
  }
  Created created = this->awaitBlock();
  if (created.value > 0)
  {
    this->blocks_.push_back(created.value);
  }
  return created;
}

std::string PidEngine::request(HidUsage type)
{
  const HidReport* report = this->descriptor_.report(HidReportKind::Feature, pid::createEffect);
  if (report == nullptr || !this->supports(type))
  {
    return "the device does not support this type of effect";
  }
  std::vector<std::uint8_t> bytes(report->bytes());
  bytes[0] = report->id;
  static_cast<void>(pid::select(*report, bytes, type));
  return this->connection_.setFeature(bytes) ? "" : "the device rejects a new effect: " + this->connection_.error();
}

PidEngine::Created PidEngine::awaitBlock()
{
  const HidReport* report = this->descriptor_.report(HidReportKind::Feature, pid::blockLoad);
  std::vector<std::uint8_t> bytes;
  for (int tries = 0; tries < blockLoadTries; ++tries)
  {
    if (const std::string problem = this->getFeature(*report, bytes); !problem.empty())
    {
      return { 0, "the device does not report the index of a new effect: " + problem };
    }
    if (pid::says(*report, bytes, pid::full))
    {
      return { 0,
        "the effect memory of the device is full: close other programs that use the device, or plug it in again" };
    }
    if (pid::says(*report, bytes, pid::loadError))
    {
      return { 0, "the device rejects the effect" };
    }
    const auto block = static_cast<int>(pid::get(*report, bytes, pid::blockIndex, 0));
    if (pid::says(*report, bytes, pid::loaded) && block > 0)
    {
      return { block, {} };
    }
    this->connection_.wait(1);
  }
  return { 0, "the device does not confirm the effect" };
}

std::vector<std::uint8_t> PidEngine::lastLoad() noexcept
{
  const HidReport* report = this->descriptor_.report(HidReportKind::Feature, pid::blockLoad);
  std::vector<std::uint8_t> bytes(report->bytes());
  bytes[0] = report->id;
  const int length = this->connection_.getFeature(bytes);
  bytes.resize(static_cast<std::size_t>(std::clamp(length, 0, static_cast<int>(bytes.size()))));
  if (!bytes.empty())
  {
    bytes.erase(bytes.begin());
  }
  return bytes;
}

std::string PidEngine::getFeature(const HidReport& report, std::vector<std::uint8_t>& bytes)
{
  bytes.assign(report.bytes(), 0);
  bytes[0] = report.id;
  const int length = this->connection_.getFeature(bytes);
  if (length < 0)
  {
    return this->connection_.error();
  }
  if (length < static_cast<int>(report.bytes()) || bytes[0] != report.id)
  {
    return "report " + std::to_string(report.id) + " came as " + std::to_string(bytes[0]) + " with " +
           std::to_string(length) + " bytes instead of " + std::to_string(report.bytes());
  }
  return {};
}

PidEngine::Draft PidEngine::draft(HidUsage collection, int block) const
{
  Draft draft{ this->descriptor_.report(HidReportKind::Output, collection), {} };
  if (draft.report != nullptr)
  {
    draft.bytes.assign(draft.report->bytes(), 0);
    draft.bytes[0] = draft.report->id;
    pid::put(*draft.report, draft.bytes, pid::blockIndex, block);
  }
  return draft;
}

bool PidEngine::send(const Draft& draft) noexcept
{
  return draft.report != nullptr && this->connection_.write(draft.bytes);
}

bool PidEngine::setEffect(int block, const EffectSettings& settings) noexcept
{
  Draft draft = this->draft(pid::setEffect, block);
  if (draft.report == nullptr)
  {
    return false;
  }
  const HidReport& report = *draft.report;
  static_cast<void>(pid::select(report, draft.bytes, settings.type));
  pid::putTime(report, draft.bytes, pid::duration, settings.duration_ms);
  for (const HidUsage unused : { pid::repeatInterval, pid::samplePeriod, pid::startDelay })
  {
    pid::put(report, draft.bytes, unused, 0);
  }
  pid::putShare(report, draft.bytes, pid::effectGain, settings.gain);
  pid::putAllOnes(report, draft.bytes, pid::triggerButton);
  const HidControl directed = findControl(report, pid::directionEnable);
  if (directed)
  {
    writeRaw(directed, draft.bytes, 1); // a board of one axis has 0 left over as its largest number
  }
  pid::put(report, draft.bytes, pid::axisX, directed ? 0 : 1, pid::axesEnable);
  pid::put(report, draft.bytes, pid::axisY, directed ? 0 : 1, pid::axesEnable);
  if (const HidControl angle = findControl(report, pid::firstOrdinal, pid::direction))
  {
    writeControl(angle, draft.bytes, angleToField(*angle.field, settings.comesFrom_deg));
  }
  return this->send(draft);
}

bool PidEngine::setCondition(int block, int axis, const Condition& condition) noexcept
{
  Draft draft = this->draft(pid::setCondition, block);
  if (draft.report == nullptr)
  {
    return false;
  }
  const HidReport& report = *draft.report;
  pid::put(report, draft.bytes, pid::parameterOffset, axis);
  pid::putSignedShare(report, draft.bytes, pid::centreOffset, condition.centre);
  pid::putShare(report, draft.bytes, pid::positiveCoefficient, condition.positiveCoefficient);
  pid::putShare(report, draft.bytes, pid::negativeCoefficient, condition.negativeCoefficient);
  pid::putShare(report, draft.bytes, pid::positiveSaturation, condition.positiveSaturation);
  pid::putShare(report, draft.bytes, pid::negativeSaturation, condition.negativeSaturation);
  pid::putShare(report, draft.bytes, pid::deadBand, condition.deadBand);
  return this->send(draft);
}

bool PidEngine::setConstantForce(int block, double share) noexcept
{
  Draft draft = this->draft(pid::setConstantForce, block);
  if (draft.report != nullptr)
  {
    pid::putSignedShare(*draft.report, draft.bytes, pid::magnitude, share);
  }
  return this->send(draft);
}

bool PidEngine::setPeriodic(int block, double magnitude, double period_ms) noexcept
{
  Draft draft = this->draft(pid::setPeriodic, block);
  if (draft.report != nullptr)
  {
    pid::putShare(*draft.report, draft.bytes, pid::magnitude, magnitude);
    pid::putSignedShare(*draft.report, draft.bytes, pid::offset, 0.0);
    pid::put(*draft.report, draft.bytes, pid::phase, 0);
    pid::putTime(*draft.report, draft.bytes, pid::period, period_ms);
  }
  return this->send(draft);
}

bool PidEngine::operate(int block, HidUsage what) noexcept
{
  Draft draft = this->draft(pid::effectOperation, block);
  if (draft.report == nullptr || !pid::select(*draft.report, draft.bytes, what))
  {
    return false;
  }
  pid::put(*draft.report, draft.bytes, pid::loopCount, 1);
  return this->send(draft);
}

bool PidEngine::free(int block) noexcept
{
  std::erase(this->blocks_, block);
  return this->send(this->draft(pid::blockFree, block));
}

bool PidEngine::control(HidUsage what) noexcept
{
  Draft draft = this->draft(pid::deviceControl, 0);
  if (draft.report == nullptr)
  {
    draft = this->draft(pid::deviceControlReport, 0);
  }
  return draft.report == nullptr || !pid::select(*draft.report, draft.bytes, what) || this->send(draft);
}

bool PidEngine::setGain(double share) noexcept
{
  Draft draft = this->draft(pid::deviceGainReport, 0);
  if (draft.report == nullptr)
  {
    return true;
  }
  pid::putShare(*draft.report, draft.bytes, pid::deviceGain, share);
  return this->send(draft);
}

std::optional<PidState> PidEngine::state(std::span<const std::uint8_t> report) const noexcept
{
  const HidReport* layout = this->descriptor_.report(HidReportKind::Input, pid::stateReport);
  if (layout == nullptr || report.empty() || report[0] != layout->id || report.size() < layout->bytes())
  {
    return std::nullopt;
  }
  PidState state;
  state.actuatorsEnabled = pid::get(*layout, report, pid::actuatorsEnabled, 1) != 0;
  state.paused = pid::get(*layout, report, pid::paused, 0) != 0;
  state.power = pid::get(*layout, report, pid::actuatorPower, 1) != 0;
  state.safetyClosed = pid::get(*layout, report, pid::safetySwitch, 0) != 0;
  state.overrideOn = pid::get(*layout, report, pid::overrideSwitch, 0) != 0;
  state.playing = pid::get(*layout, report, pid::effectPlaying, 0) != 0;
  state.block = static_cast<int>(pid::get(*layout, report, pid::blockIndex, 0));
  return state;
}

bool PidEngine::hasSafetySwitch(const ReportDescriptor& descriptor) noexcept
{
  const HidReport* layout = descriptor.report(HidReportKind::Input, pid::stateReport);
  return layout != nullptr && static_cast<bool>(findControl(*layout, pid::safetySwitch));
}

std::int64_t PidEngine::constantForceSteps(double share) const noexcept
{
  const HidReport* report = this->descriptor_.report(HidReportKind::Output, pid::setConstantForce);
  const HidControl control = report == nullptr ? HidControl{} : findControl(*report, pid::magnitude);
  return control ? signedShareToField(*control.field, share) : 0;
}

} // namespace palpate
