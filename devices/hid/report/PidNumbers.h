// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "devices/hid/report/ReportDescriptor.h"

namespace palpate
{

/// Between shares, times and angles and the whole numbers of a field. Only logical ranges and the exponent of time
/// count: physical ranges are often left over from another field. Pure.

/// -1 .. 1 on a field: whole multiples of 1 / logicalMax, so that 0 is 0; a field without negative numbers is taken
/// from end to end.
[[nodiscard]] std::int64_t signedShareToField(const HidField& field, double share) noexcept;
[[nodiscard]] double fieldToSignedShare(const HidField& field, std::int64_t value) noexcept;

/// 0 .. 1 on a field: whole multiples of 1 / logicalMax.
[[nodiscard]] std::int64_t shareToField(const HidField& field, double share) noexcept;

/// A time; milliseconds where the field does not say. Never longer than asked for by misreading: values that do not fit
/// are the longest time the field has, and never all ones, which means forever.
[[nodiscard]] std::int64_t timeToField(const HidField& field, double time_ms) noexcept;

/// An angle, the field's range being a whole turn.
[[nodiscard]] std::int64_t angleToField(const HidField& field, double angle_deg) noexcept;

} // namespace palpate
