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
/// looks alike, and another program may use it: one that was there beside the wanted one is never taken for it, as far
/// as that can be seen: one that came later with the same serial number, and is there alone after the loss, is.
class DeviceSearch
{
public:
  explicit DeviceSearch(HidEntry wanted) : wanted_(std::move(wanted)) {}

  /// When a person asks for it: the one in its place, else the only one that looks alike.
  [[nodiscard]] FoundDevice first(DeviceListing& bus);
  /// At once after a loss, before anything that may hang: whatever is in other places then is not the one that was
  /// lost, unless its serial number says so. Again before it is found: nothing. Opens nothing.
  void lost(DeviceListing& bus);
  /// After lost(): what has come since, as long as the others stay where they are.
  [[nodiscard]] FoundDevice again(DeviceListing& bus);
  /// That one is used from now on.
  void found(DeviceListing& bus, const HidEntry& entry);

private:
  [[nodiscard]] std::vector<HidEntry> alike(DeviceListing& bus) const;
  [[nodiscard]] FoundDevice only(const std::vector<HidEntry>& alike) const;
  [[nodiscard]] FoundDevice newcomer(const std::vector<HidEntry>& alike) const;
  [[nodiscard]] std::string name() const;

  HidEntry wanted_;
  std::vector<std::uint8_t> descriptor_; ///< of the one that is used
  bool looking_ = false;                 ///< since it was lost
  bool hadTwin_ = false;                 ///< once when it was found: its serial number says nothing
  bool mayBeOwn_ = false;                ///< what was in another place after the loss
  std::vector<std::string> others_;      ///< the places of those that were there beside it then
};

} // namespace palpate
