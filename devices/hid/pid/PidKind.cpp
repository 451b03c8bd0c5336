// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/pid/PidKind.h"

#include <algorithm>

#include "devices/hid/pid/PidInput.h"

namespace palpate
{
namespace
{

bool creates(const ReportDescriptor& descriptor, HidUsage type) noexcept
{
  const HidReport* const report = descriptor.report(HidReportKind::Feature, pid::createEffect);
  return report != nullptr && static_cast<bool>(findSelector(*report, type));
}

bool pushes(const ReportDescriptor& descriptor) noexcept
{
  return creates(descriptor, pid::constantForce) &&
         descriptor.report(HidReportKind::Output, pid::setConstantForce) != nullptr;
}

/// Which axes an effect may act along. A device that lists none at all means all it has.
struct Actuated
{
  bool x = true, y = true;
};
Actuated actuated(const ReportDescriptor& descriptor) noexcept
{
  const HidReport* const report = descriptor.report(HidReportKind::Output, pid::setEffect);
  const auto listsAxes = [](const HidField& field) { return field.isWithin(pid::axesEnable); };
  if (report == nullptr || std::none_of(report->fields.begin(), report->fields.end(), listsAxes))
  {
    return {};
  }
  return { static_cast<bool>(findControl(*report, pid::axisX, pid::axesEnable)),
    static_cast<bool>(findControl(*report, pid::axisY, pid::axesEnable)) };
}

/// Of the effects that shake the one that is felt best; a constant one shakes only devices that cannot push.
std::optional<HidUsage> shaking(const ReportDescriptor& descriptor, bool constant) noexcept
{
  if (descriptor.report(HidReportKind::Output, pid::setPeriodic) != nullptr)
  {
    for (const HidUsage type : { pid::sine, pid::square, pid::triangle, pid::sawtoothUp, pid::sawtoothDown })
    {
      if (creates(descriptor, type))
      {
        return type;
      }
    }
  }
  return constant ? std::optional(pid::constantForce) : std::nullopt;
}

DeviceClass classOf(std::size_t pushedAxes) noexcept
{
  return pushedAxes == 0 ? DeviceClass::Vibration0D : pushedAxes == 1 ? DeviceClass::Wheel1D : DeviceClass::Joystick2D;
}

} // namespace

PidKind pidKind(const ReportDescriptor& descriptor)
{
  const PidInput input(descriptor);
  const Actuated along = actuated(descriptor);
  const bool force = pushes(descriptor);
  PidKind kind;
  kind.sensedAxes = input.hasTwoAxes() ? 2 : input.usable() ? 1 : 0;
  kind.pushedAxes = !force || !along.x ? 0 : along.y && input.hasTwoAxes() ? 2 : 1;
  kind.deviceClass = classOf(kind.pushedAxes);
  kind.shaking = shaking(descriptor, force && kind.pushedAxes == 0);
  const bool springs = kind.pushedAxes > 0 && creates(descriptor, pid::spring);
  const ConditionAbilities conditions = conditionAbilities(descriptor);
  kind.conditions = springs ? conditions : ConditionAbilities{};
  kind.damper = kind.pushedAxes > 0 && creates(descriptor, pid::damper) && conditions.saturation;
  if (kind.sensedAxes == 0)
  {
    kind.problem = "the device has no axis that reports the position of the hand";
  }
  else if (force && !along.x && along.y)
  {
    kind.problem = "not supported: the device renders force along y only";
  }
  else if (kind.pushedAxes == 0 && !kind.shaking)
  {
    kind.problem = "the device has neither a constant force nor vibration";
  }
  else if (kind.pushedAxes == 1)
  {
    kind.sensedAxes = 1; // the other axis is a pedal or a throttle
  }
  return kind;
}

DeviceAbilities promised(const PidKind& kind) noexcept
{
  const ConditionAbilities& conditions = kind.conditions;
  const bool walls = conditions.saturation && (conditions.deadBand || conditions.twoCoefficients);
  return { static_cast<std::uint8_t>(kind.sensedAxes), walls, kind.damper, kind.shaking.has_value() };
}

} // namespace palpate
