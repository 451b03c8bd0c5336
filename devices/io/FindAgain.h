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

/// The wanted device among those on the bus, or the reason why there is none.
struct FoundDevice
{
  std::optional<HidEntry> entry;
  std::string problem;
};

/// Finds one device on a bus, and finds it again after a loss. Devices of the same maker, product and serial number
/// look alike, and another program may use one of them. A device that was present beside the wanted one is never taken
/// for that one. A device that came later with the same serial number, and is alone after the loss, cannot be
/// distinguished from the wanted one and is taken.
class DeviceSearch
{
public:
  explicit DeviceSearch(HidEntry wanted) : wanted_(std::move(wanted)) {}

  /// When the user asks for the device: the one at its path, else the only one that looks alike.
  [[nodiscard]] FoundDevice first(DeviceListing& bus);
  /// To be called at once after a loss, before any call that may hang: a device at another path at that time is not the
  /// lost one, unless its serial number says so. No effect when called again before the device is found. Opens nothing.
  void lost(DeviceListing& bus);
  /// After lost(): the device that has appeared since, as long as the others stay at their paths.
  [[nodiscard]] FoundDevice again(DeviceListing& bus);
  /// `entry` is the device in use from now on.
  void found(DeviceListing& bus, const HidEntry& entry);

private:
  [[nodiscard]] std::vector<HidEntry> alike(DeviceListing& bus) const;
  [[nodiscard]] FoundDevice only(const std::vector<HidEntry>& alike) const;
  [[nodiscard]] FoundDevice newcomer(const std::vector<HidEntry>& alike) const;
  [[nodiscard]] std::string name() const;

  HidEntry wanted_;
  std::vector<std::uint8_t> descriptor_; ///< of the device in use
  bool looking_ = false;                 ///< since a loss
  bool hadTwin_ = false;                 ///< when found it had a twin, so that its serial number identifies nothing
  bool mayBeOwn_ = false;                ///< the device at another path after the loss may be the lost one
  std::vector<std::string> others_;      ///< paths of the other devices at that time
};

} // namespace palpate
