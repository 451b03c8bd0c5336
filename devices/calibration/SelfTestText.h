// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "devices/calibration/SelfTest.h"
#include "devices/common/LinkedDevice.h"

namespace palpate
{

/// The present instruction, in one sentence; empty once there is a verdict.
[[nodiscard]] std::string askOf(const SelfTestPlan& plan, const SelfTestState& state);

/// The result, in lines; empty before there is a verdict. `link`: how the link to the device went meanwhile.
[[nodiscard]] std::string resultOf(const SelfTestPlan& plan, const SelfTestState& state, const LinkReport& link = {});

} // namespace palpate
