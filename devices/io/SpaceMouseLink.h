// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "devices/common/LinkedDevice.h"
#include "devices/hid/HidConnection.h"
#include "devices/hid/SpaceMouseInput.h"
#include "devices/io/AttachedDevice.h"
#include "devices/io/FindAgain.h"
#include "devices/io/LinkCounts.h"
#include "devices/io/Presence.h"
#include "haptics/core/Clock.h"
#include "haptics/realtime/TripleBuffer.h"

namespace palpate
{

/// The link between a SpaceMouse, a reader, which may block in its pass, and the servo, which never waits. After a loss
/// the reader opens the device again.
class SpaceMouseLink
{
public:
  /// `clock` must outlive the link.
  SpaceMouseLink(std::shared_ptr<HidBus> bus, HidEntry entry, const Clock& clock);

  /// Finds and opens the device. Empty, or the reason for the failure. Reader thread, or before there is one.
  [[nodiscard]] std::string attach();
  /// Releases the device. Reader thread, or after it.
  void detach() noexcept;
  /// Waits for input and keeps the newest; without a device tries to find it again. False: there is none. Reader
  /// thread.
  bool readPass(int timeout_ms);

  struct News
  {
    Cap cap;
    std::uint64_t reports = 0; ///< number of valid reports so far
  };
  /// The newest state of the cap; none: the device is lost, or was since the last call. Servo thread; wait-free.
  [[nodiscard]] std::optional<News> news() noexcept;

  /// Any thread but the servo's.
  [[nodiscard]] LinkReport report() const;

private:
  struct Attached
  {
    std::unique_ptr<HidConnection> connection;
    ReportDescriptor descriptor;
    std::optional<SpaceMouseInput> input;
  };

  [[nodiscard]] std::string prepare(const FoundDevice& found);
  [[nodiscard]] std::string begin(const HidEntry& entry, Attached& device);
  void reattach(std::int64_t now_ns);
  void take(const Attached& device, std::span<const std::uint8_t> report) noexcept;

  std::shared_ptr<HidBus> bus_;
  DeviceSearch search_; ///< reader's, and the owner's before
  const Clock& clock_;

  AttachedDevice<Attached> held_; ///< reader and owner only

  TripleBuffer<News> newsToServo_; ///< reader -> servo
  alignas(64) Presence presence_;  ///< on a cache line of its own: the servo reads it every tick
  LinkCounts counts_;
  News news_;         ///< reader's
  SearchPause pause_; ///< reader's
};

} // namespace palpate
