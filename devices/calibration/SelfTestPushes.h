// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/calibration/SelfTest.h"

namespace palpate
{

// The pushes of a self-test, from the first Settle to the verdict. Real-time safe.

/// The device may push in this stage.
[[nodiscard]] bool givesForce(const SelfTestState& state) noexcept;
/// One tick of the stages Settle to Shake.
void advancePushes(const SelfTestPlan& plan, SelfTestState& state) noexcept;
/// The command to the device in this tick.
[[nodiscard]] DeviceCommand pushCommand(const SelfTestPlan& plan, const SelfTestState& state) noexcept;
/// The device's own walls may move the hand away: then they are switched off, and the test continues.
/// Everything else that is unexpected ends it.
void judgeDanger(const SelfTestPlan& plan, SelfTestReason danger, SelfTestState& state) noexcept;

} // namespace palpate
