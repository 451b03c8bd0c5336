// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "devices/arm/protocol/WireProtocol.h"

namespace palpate
{

/// The messages of Haply's service for Inverse3, Inverse3X and Minverse, versions 3.0 to 3.5
/// (docs.haply.co/inverseSDK): JSON, a state for each command. The place and turn of the hand are those of the service;
/// forces of several programs would add.
class HaplyServiceWire final : public WireProtocol
{
public:
  /// `vector`: forces stand under "vector", which they do since 3.5; else under "values". `centre_D`: of the work
  /// space, where the service has its origin elsewhere [m]; places are counted from there. `session`: of this
  /// connection, as haplySession() has it; messages of another one are passed over.
  HaplyServiceWire(
    std::string device, bool vector, const Vec3& centre_D = Vec3::Zero(), std::string session = std::string())
    : device_(std::move(device)), vector_(vector), centre_D_(centre_D), session_(std::move(session))
  {
  }

  void encode(const WireOrder& order, WireBytes& bytes) const override;
  [[nodiscard]] std::optional<WireReading> decode(std::span<const std::uint8_t> answer) const override;
  /// Events, states of other devices and of other sessions, and messages about the device without a state of it.
  [[nodiscard]] bool isOthers(std::span<const std::uint8_t> message) const override;
  /// Names the program and sets the transform, which the service keeps of whoever set it before, to identity.
  [[nodiscard]] WireBytes greeting() const override;

private:
  std::string device_;
  bool vector_;
  Vec3 centre_D_;
  std::string session_; ///< empty: not known
};

/// A device in the message that the service begins with.
struct HaplyDevice
{
  std::string id, type;
  bool inUse = false;
  bool centred = false; ///< its origin is the middle of its work space
  bool ready = false, calibrated = false;
};
/// None: it is no such message.
[[nodiscard]] std::optional<std::vector<HaplyDevice>> haplyInventory(std::string_view message);

/// The session that a message belongs to, as JSON; empty: it says none.
[[nodiscard]] std::string haplySession(std::string_view message);

/// Forces stand under "vector" in the service whose answer to the question for its version that is; none: it says no
/// version.
[[nodiscard]] std::optional<bool> haplyHasVector(std::string_view versionAnswer);

/// The event for which a message of the channel of events stops this device; empty: none. Every event of safety does,
/// others unless they name another device.
[[nodiscard]] std::string haplyStop(std::string_view message, const std::string& device);

} // namespace palpate
