// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "devices/arm/ArmSetup.h"
#include "devices/arm/link/Plugs.h"
#include "devices/arm/protocol/TwoDiyWire.h"
#include "haptics/arm/ArmPlan.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

/// A board that speaks as that of a 2DIY does, on a serial line.
struct TwoDiyBoard
{
  static constexpr const char* protocol = "2diy";

  std::uint8_t device = 5;                            ///< its number
  std::array<bool, 2> motorTurned{}, encoderTurned{}; ///< wired the other way round
};

/// A board that speaks as that of a WoodenHaptics does, on USB HID.
struct WoodenHapticsBoard
{
  static constexpr const char* protocol = "woodenhaptics";

  std::size_t reportBytes = 0; ///< 0: as many as boards with its USB numbers have
  bool grips = false;          ///< its fourth counter tells whether it is gripped
};

/// The devices that are such an arm, and their protocol.
struct ArmWire
{
  UsbDevices devices;
  std::string pose;           ///< in which the counters are set, as a sentence to the person
  double poseTolerance = 0.0; ///< a hand that holds the pose moves the arm by less: degrees of a 2DIY, else counts
  std::variant<TwoDiyBoard, WoodenHapticsBoard> board;
};

/// An arm as a file describes it, with its wire.
struct WiredArm
{
  ArmPlan plan;
  std::optional<ArmWire> wire; ///< none: the file does not say how the arm is plugged in
};

/// 2diy, woodenhaptics.
[[nodiscard]] const char* protocolOf(const ArmWire& wire) noexcept;

/// Empty, or one sentence with the reason why an arm of that plan cannot be driven through that wire. The plan must be
/// one that refuse() accepts by itself.
[[nodiscard]] std::string refuse(const ArmPlan& plan, const ArmWire& wire);

/// Makes the largest torque of each motor one that the wire can ask for: beyond, a force would be turned, not made
/// smaller.
void limitToWire(ArmPlan& plan, const ArmWire& wire);

/// The properties of an arm with a wire, which refuse() accepts.
[[nodiscard]] ArmSetup setupOf(const WiredArm& arm);
/// The set-up of the board of such an arm, whose wire is a TwoDiyBoard.
[[nodiscard]] TwoDiyWire::Setup boardOf(const WiredArm& arm);
/// The torque of each motor for an ampere [N m/A]; 1 where the arm has no such motor.
[[nodiscard]] std::array<double, WireOrder::motors> constantsOf(const ArmPlan& plan);

} // namespace palpate
