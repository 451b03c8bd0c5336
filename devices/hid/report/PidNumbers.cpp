// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/report/PidNumbers.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

/// The nearest whole number of the field's range; not a number is as near to 0 as the range goes.
std::int64_t inRange(const HidField& field, double value) noexcept
{
  const auto low = static_cast<double>(field.logicalMin), high = static_cast<double>(field.logicalMax);
  return std::llround(std::clamp(std::isnan(value) ? 0.0 : value, low, high));
}

} // namespace

std::int64_t signedShareToField(const HidField& field, double share) noexcept
{
  const auto low = static_cast<double>(field.logicalMin), high = static_cast<double>(field.logicalMax);
  const double known = std::isnan(share) ? 0.0 : share;
  return inRange(field, low < 0.0 ? known * high : low + 0.5 * (known + 1.0) * (high - low));
}

double fieldToSignedShare(const HidField& field, std::int64_t value) noexcept
{
  const auto low = static_cast<double>(field.logicalMin), high = static_cast<double>(field.logicalMax);
  const auto at = static_cast<double>(value);
  const double share = low < 0.0 ? at / std::max(high, 1.0) : 2.0 * (at - low) / std::max(high - low, 1.0) - 1.0;
  return std::clamp(share, -1.0, 1.0);
}

std::int64_t shareToField(const HidField& field, double share) noexcept
{
  return inRange(field, share * static_cast<double>(field.logicalMax));
}

std::int64_t timeToField(const HidField& field, double time_ms) noexcept
{
  constexpr int milli = -3;
  const bool said = field.unit != 0 && field.exponent != 0;
  const double value = time_ms * (said ? std::pow(10.0, milli - field.exponent) : 1.0);
  const std::int64_t forever = static_cast<std::int64_t>((std::uint64_t{ 1 } << std::min(field.bitCount, 62U)) - 1);
  return std::min(inRange(field, value), std::max(field.logicalMin, forever - 1));
}

std::int64_t angleToField(const HidField& field, double angle_deg) noexcept
{
  constexpr double turn_deg = 360.0;
  const auto low = static_cast<double>(field.logicalMin), high = static_cast<double>(field.logicalMax);
  return inRange(field, low + angle_deg / turn_deg * (high - low));
}

} // namespace palpate
