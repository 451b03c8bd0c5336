// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "haptics/core/DeviceInfo.h"

namespace palpate
{

/// How the link to a device went so far.
struct LinkReport
{
  std::uint64_t inputs = 0;     ///< reports with the hand
  std::uint64_t strange = 0;    ///< neither that nor a state: another ID, or too short
  std::uint64_t outOfRange = 0; ///< positions beyond the range of the descriptor
  std::uint64_t outputs = 0;    ///< reports that the device took
  std::uint64_t restarts = 0;   ///< of these, effects that were armed again before they ended
  std::uint64_t stalls = 0;     ///< times a write hung for longer than a link may
  std::uint64_t losses = 0;     ///< times the device was lost, stalls included
  double inputRate_Hz = 0.0;    ///< of the last second or so; 0 before the first and of a lost arm
  bool attached = false;
  std::string message;  ///< the last fault, for a person; empty: none
  std::string lostFor;  ///< why it was lost last, whatever it says since; empty: it was not
  std::string endedFor; ///< why it ended its force though it stayed attached; empty: it did not, or was lost since
};

/// A device behind a link that can be slow, hang or go. Any thread but the servo's.
class LinkedDevice
{
public:
  virtual ~LinkedDevice() = default;

  [[nodiscard]] virtual LinkReport linkReport() const = 0;
  /// Its true abilities, as far as they are known only once it is open.
  [[nodiscard]] virtual DeviceAbilities abilitiesNow() const = 0;
};

} // namespace palpate
