// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/kit/WireFile.h"

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "devices/arm/protocol/WoodenHapticsWire.h"
#include "haptics/arm/file/ArmFile.h"
#include "haptics/core/JsonNode.h"

namespace palpate
{
namespace
{

using Json = nlohmann::json;
using Node = JsonNode<Json>;

/// 0: it is not four hexadecimal digits.
std::uint16_t hexOf(std::string_view digits)
{
  std::uint16_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
  return digits.size() == 4 && error == std::errc() && end == digits.data() + digits.size() ? number : 0;
}

UsbIds usbOf(const Node& node)
{
  UsbIds ids;
  for (const std::string& text : node.texts("usb"))
  {
    const std::string_view id = text;
    const bool isPair = id.size() == 9 && id[4] == ':';
    const std::uint16_t maker = isPair ? hexOf(id.substr(0, 4)) : 0, product = isPair ? hexOf(id.substr(5)) : 0;
    if (maker == 0 || product == 0)
    {
      node.fail("usb", "each text must have the numbers of a device as lsusb shows them, such as \"2341:003e\"");
    }
    ids.emplace_back(maker, product);
  }
  node.accept("usb", ids.empty() ? "must name a device" : "");
  return ids;
}

void checkWireKeys(const Node& node, std::initializer_list<const char*> own)
{
  std::vector<const char*> keys{ "protocol", "usb", "serial", "pose" };
  keys.insert(keys.end(), own);
  node.knows(keys);
}

double toleranceOf(const Node& node, const char* key, double usual, double least, double most)
{
  const double tolerance = node.number(key, usual);
  if (!(tolerance >= least && tolerance <= most))
  {
    node.fail(key, "must be from " + std::to_string(std::lround(least)) + " to " + std::to_string(std::lround(most)));
  }
  return tolerance;
}

std::array<bool, 2> turnsOf(const Node& node, const char* key)
{
  const std::vector<bool> turns = node.flags(key, 2);
  return { turns[0], turns[1] };
}

void read2Diy(const Node& node, ArmWire& wire)
{
  checkWireKeys(node, { "pose_tolerance_deg", "device", "motors_turned", "encoders_turned" });
  wire.poseTolerance = toleranceOf(node, "pose_tolerance_deg", 3.0, 1.0, 30.0);
  TwoDiyBoard board;
  board.device = static_cast<std::uint8_t>(node.whole("device", board.device, 1, 255));
  board.motorTurned = turnsOf(node, "motors_turned");
  board.encoderTurned = turnsOf(node, "encoders_turned");
  wire.board = board;
}

void readWoodenHaptics(const Node& node, ArmWire& wire)
{
  checkWireKeys(node, { "pose_tolerance_counts", "report_bytes", "grip" });
  wire.poseTolerance = toleranceOf(node, "pose_tolerance_counts", 300.0, 1.0, 3000.0);
  constexpr int least = WoodenHapticsWire::length, most = 64; // of USB at full speed
  WoodenHapticsBoard board;
  board.reportBytes =
    node.has("report_bytes") ? static_cast<std::size_t>(node.whole("report_bytes", 0, least, most)) : 0;
  board.grips = node.flag("grip", false);
  wire.board = board;
}

/// The devices come first: they are told where a later key is wrong, too.
void readWire(const Node& node, std::optional<ArmWire>& wire)
{
  const std::string protocol = node.needed("protocol");
  const bool is2Diy = protocol == TwoDiyBoard::protocol;
  if (!is2Diy && protocol != WoodenHapticsBoard::protocol)
  {
    node.fail("protocol", "unknown protocol \"" + protocol + "\"; valid protocols: 2diy, woodenhaptics");
  }
  ArmWire read;
  read.devices = { usbOf(node), node.text("serial", "") };
  if (!is2Diy)
  {
    read.board = WoodenHapticsBoard{};
  }
  wire = read;
  (is2Diy ? read2Diy : readWoodenHaptics)(node, *wire);
  wire->pose = node.needed("pose");
}

} // namespace

Outcome<WiredArm> parseWiredArm(const std::string& text)
{
  Outcome<WiredArm> arm;
  const std::string problem = jsonProblemOf<Json>(
    [&]
    {
      const Json json = Json::parse(text);
      const Node root(json, "");
      if (root.has("wire"))
      {
        readWire(root.part("wire"), arm.value.wire);
      }
    });
  Outcome<ArmPlan> plan = parseArm(text);
  arm.value.plan = std::move(plan.value);
  arm.problem = plan.ok() ? problem : plan.problem;
  if (arm.ok() && arm.value.wire)
  {
    limitToWire(arm.value.plan, *arm.value.wire);
    arm.problem = refuse(arm.value.plan, *arm.value.wire);
  }
  return arm;
}

Outcome<WiredArm> wiredArmNamed(const std::string& nameOrFile)
{
  const Outcome<std::string> text = armText(nameOrFile);
  Outcome<WiredArm> arm = text.ok() ? parseWiredArm(text.value) : Outcome<WiredArm>{ {}, text.problem };
  arm.problem = arm.ok() ? "" : nameOrFile + ": " + arm.problem;
  return arm;
}

} // namespace palpate
