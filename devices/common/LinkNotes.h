// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "devices/common/LinkedDevice.h"

namespace palpate
{

/// How a link goes, in one line for a person. Pure.
[[nodiscard]] std::string describeLink(const LinkReport& link);

/// Why a device was lost whose write failed with that error: one that was unplugged may be missed by the writer before
/// the reader misses it. Pure.
[[nodiscard]] std::string describeFailedWrite(const std::string& error);

/// Reason for no force after the loss of a device, its return, and the remedy. Pure.
[[nodiscard]] std::string describeLoss(const LinkReport& link);

} // namespace palpate
