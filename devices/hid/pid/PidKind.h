// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "devices/hid/pid/PidEngine.h"
#include "haptics/core/DeviceInfo.h"

namespace palpate
{

/// The kind of a force-feedback device from its descriptor. A wheel with pedals senses more axes than it pushes, and
/// a pad that only shakes senses a stick that it does not push.
struct PidKind
{
  DeviceClass deviceClass = DeviceClass::Joystick2D;
  std::size_t sensedAxes = 2;      ///< 1: x; 2: x and y
  std::size_t pushedAxes = 2;      ///< 0: it only shakes
  std::optional<HidUsage> shaking; ///< the kind of effect that shakes best; none: it cannot
  ConditionAbilities conditions;
  bool damper = false; ///< one whose force it can limit
  std::string problem; ///< empty, or why it cannot be driven
};
[[nodiscard]] PidKind pidKind(const ReportDescriptor& descriptor);

/// Its abilities according to its descriptor.
[[nodiscard]] DeviceAbilities promised(const PidKind& kind) noexcept;

} // namespace palpate
