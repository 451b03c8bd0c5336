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

/// The device that is meant among those that are there, or why none is.
struct FoundDevice
{
  std::optional<HidEntry> entry;
  std::string problem;
};

/// Finds one device on a bus, and finds it again after it was lost. Devices of the same maker, product and serial
/// number look alike, and another program may use one of them. A device that was there beside the wanted one is never
/// taken for it. One that came later with the same serial number, and is there alone after the loss, cannot be told
/// from it and is taken.
class DeviceSearch
{
public:
  explicit DeviceSearch(HidEntry wanted) : wanted_(std::move(wanted)) {}

  /// When a person asks for the device: the one in its place, else the only one that looks alike.
  [[nodiscard]] FoundDevice first(DeviceListing& bus);
  /// To be called at once after a loss, before anything that may hang: what is in other places at that time is not the
  /// lost device, unless its serial number says so. Called again before the device is found: nothing. Opens nothing.
  void lost(DeviceListing& bus);
  /// After lost(): the device that has come since, as long as the others stay where they are.
  [[nodiscard]] FoundDevice again(DeviceListing& bus);
  /// `entry` is used from now on.
  void found(DeviceListing& bus, const HidEntry& entry);

private:
  [[nodiscard]] std::vector<HidEntry> alike(DeviceListing& bus) const;
  [[nodiscard]] FoundDevice only(const std::vector<HidEntry>& alike) const;
  [[nodiscard]] FoundDevice newcomer(const std::vector<HidEntry>& alike) const;
  [[nodiscard]] std::string name() const;

  HidEntry wanted_;
  std::vector<std::uint8_t> descriptor_; ///< of the one that is used
  bool looking_ = false;                 ///< since it was lost
  bool hadTwin_ = false;                 ///< when it was found, so its serial number says nothing
  bool mayBeOwn_ = false;                ///< the device that was in another place after the loss
  std::vector<std::string> others_;      ///< places of the devices that were there beside it then
};

} // namespace palpate
