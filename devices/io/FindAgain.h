// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "devices/hid/HidConnection.h"

namespace palpate
{

/// Which of the devices that are there is meant, or why none is.
struct FoundDevice
{
  std::optional<HidEntry> entry;
  std::string problem;
};

/// Finds one device on a bus, and finds it again after it was lost. What has the same maker, product and serial number
/// looks alike, and another program may use it: one that was there beside the wanted one is never taken for it.
class DeviceSearch
{
public:
  explicit DeviceSearch(HidEntry wanted) : wanted_(std::move(wanted)) {}

  /// When a person asks for it: the one in its place, else the only one that looks alike.
  [[nodiscard]] FoundDevice first(HidBus& bus);
  /// After a loss. The first look must follow the loss at once: whatever is in other places then is not the one that
  /// was lost. Later it is what has come since, as long as the others stay where they are.
  [[nodiscard]] FoundDevice again(HidBus& bus);
  /// That one is used from now on.
  void found(HidBus& bus, const HidEntry& entry);

private:
  [[nodiscard]] std::vector<HidEntry> alike(HidBus& bus) const;
  [[nodiscard]] FoundDevice only(const std::vector<HidEntry>& alike) const;
  [[nodiscard]] FoundDevice newcomer(const std::vector<HidEntry>& alike) const;
  [[nodiscard]] std::string name() const;

  HidEntry wanted_;
  std::vector<std::uint8_t> descriptor_; ///< of the one that is used
  bool looking_ = false;                 ///< since it was lost
  std::vector<std::string> others_;      ///< the places of those that were there beside it then
};

} // namespace palpate
