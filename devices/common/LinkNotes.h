// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "devices/common/LinkedDevice.h"
#include "haptics/core/Fault.h"

namespace palpate
{

/// How a link goes, in one line for a person. Pure.
[[nodiscard]] std::string describeLink(const LinkReport& link);

/// Why a device was lost whose write failed with that error: one that was unplugged may be missed by the writer before
/// the reader misses it. Pure.
[[nodiscard]] std::string describeFailedWrite(const std::string& error);

/// Reason for no force, and the remedy: after the loss of a device whether it is back, before its first position the
/// step that it waits for. Without a full stop. Pure.
[[nodiscard]] std::string describeFault(Fault fault, const LinkReport& link);

} // namespace palpate
