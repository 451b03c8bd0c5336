// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "devices/hid/report/ReportDescriptor.h"
#include "testing/devices/hid/PidHabits.h"

namespace palpate::test
{

/// A number in a report: which, how wide, from where to where.
struct PidNumber
{
  std::uint8_t usage = 0;
  std::uint32_t bitCount = 16;
  std::int64_t min = 0;
  std::int64_t max = 0;
};

/// How one force-feedback device arranges its reports; ID 0 stands for a report that it does not have.
struct PidLayout
{
  std::string name;
  std::uint8_t inputId = 0x01, stateId = 0x02;
  PidNumber axis{ 0x30, 16, -32767, 32767 };
  std::uint32_t axes = 2;      ///< that it senses
  std::uint32_t forceAxes = 2; ///< that its effects may act along
  std::uint8_t setEffectId = 0x11, conditionId = 0x13, periodicId = 0x14, constantId = 0x15, operationId = 0x1A,
               freeId = 0x1B, controlId = 0x1C, gainId = 0x1D, createId = 0x21, loadId = 0x22, poolId = 0x23;
  std::vector<std::uint8_t> effects{ 0x26, 0x27, 0x30, 0x31, 0x32, 0x33, 0x34, 0x40, 0x41, 0x42, 0x43 };
  std::vector<std::uint8_t> operations{ 0x79, 0x7A, 0x7B };
  std::vector<std::uint8_t> controls{ 0x97, 0x98, 0x99, 0x9A, 0x9B, 0x9C };
  bool controlBits = false;             ///< a bit each instead of a number
  std::int64_t longestDuration = 65535; ///< ms
  bool hasStartDelay = true, hasEffectGain = true;
  int firstTrigger = 0;
  std::int64_t wholeTurn = 36000;
  std::vector<PidNumber> condition{ { 0x60, 16, -10000, 10000 }, { 0x61, 16, -10000, 10000 },
    { 0x62, 16, -10000, 10000 }, { 0x63, 16, 0, 10000 }, { 0x64, 16, 0, 10000 }, { 0x65, 16, 0, 10000 } };
  PidNumber magnitude{ 0x70, 16, -10000, 10000 };
  bool deviceManaged = true;
  bool sloppy = false; ///< a maximum of 255 in one byte, a value declared an array, constant pool fields, wide usages
  int slots = 40;
  PidHabits habits;

  /// The number with that usage, or null.
  [[nodiscard]] const PidNumber* conditionNumber(std::uint8_t usage) const noexcept;
};

/// A layout's report descriptor.
[[nodiscard]] std::vector<std::uint8_t> descriptorOf(const PidLayout& layout);

/// Layouts with the ranges, orders and gaps of devices people have, each in our own words.
[[nodiscard]] PidLayout plainLayout();         ///< everything, with unusual IDs
[[nodiscard]] PidLayout adapterLayout();       ///< an old stick behind an adapter: one coefficient, nothing else
[[nodiscard]] PidLayout hobbyLayout();         ///< a microcontroller library: low IDs, no start delay, a 1-byte turn
[[nodiscard]] PidLayout driverManagedLayout(); ///< an office stick whose pool the host would manage
[[nodiscard]] PidLayout officeLayout();        ///< its small unlike ranges, with a pool of its own
[[nodiscard]] PidLayout flightLayout();        ///< a flight-simulator base: IDs from 101, +-4096
[[nodiscard]] PidLayout openBoardLayout();     ///< an open controller board: +-32767
[[nodiscard]] PidLayout oneSidedLayout();      ///< two coefficients, no dead band
[[nodiscard]] PidLayout wheelLayout();         ///< one axis
[[nodiscard]] PidLayout pedalWheelLayout();    ///< a wheel whose pedals call themselves y
[[nodiscard]] PidLayout rumbleLayout();        ///< a pad with a stick and periodic effects only
[[nodiscard]] PidLayout buzzerLayout();        ///< the same with constant ones only, along no axis of the stick
[[nodiscard]] PidLayout bitControlLayout();    ///< device control as bits
[[nodiscard]] std::vector<PidLayout> allLayouts(); ///< whose pool the device manages

} // namespace palpate::test
