// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as the answer of any arm: readings of them are finite, a frame lies within them, and an order of any
// numbers asks for no more than the wire's largest torque or for a force that is a number. First byte: whose wire it
// is.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "devices/arm/kit/WireFile.h"
#include "devices/arm/kit/WoodenHapticsFile.h"
#include "devices/arm/protocol/FalconWire.h"
#include "devices/arm/protocol/HaplyServiceWire.h"
#include "devices/arm/protocol/TwoDiyWire.h"
#include "devices/arm/protocol/WoodenHapticsWire.h"
#include "testing/fuzz/Require.h"

namespace
{

using palpate::WireBytes;
using palpate::WireOrder;
using palpate::WireProtocol;
using palpate::WireReading;

std::unique_ptr<WireProtocol> wireOf(unsigned which)
{
  switch (which % 4)
  {
    case 0:
      return std::make_unique<palpate::WoodenHapticsWire>(std::array<double, 3>{ 0.1, 0.2, 0.3 }, true);
    case 1:
      return std::make_unique<palpate::FalconWire>();
    case 2:
      return std::make_unique<palpate::TwoDiyWire>(
        palpate::TwoDiyWire::Setup{ 5, {}, {}, { 180.0, 0.0 }, { 13824.0, 13824.0 } });
    default:
      return std::make_unique<palpate::HaplyServiceWire>("049D", which % 8 < 4);
  }
}

/// Counters are whole numbers of 16 bits, angles are twenty turns at most, the service's numbers 1000.
void judgeReading(const WireReading& reading, unsigned which)
{
  for (const double encoder : reading.encoder)
  {
    const bool isCount = encoder == std::floor(encoder) && encoder >= -32768.0 && encoder <= 32767.0;
    require(which % 4 == 3 ? encoder == 0.0 : which % 4 == 2 ? std::fabs(encoder) <= 7200.0 : isCount);
  }
  require(reading.pose_D.has_value() == (which % 4 == 3));
  require(!reading.pose_D ||
          (reading.pose_D->p.cwiseAbs().maxCoeff() <= 1000.0 && std::fabs(reading.pose_D->q.norm() - 1.0) < 1e-12));
  require(!reading.velocity_D || reading.velocity_D->linear.cwiseAbs().maxCoeff() <= 1000.0);
}

void judgeAnswer(const WireProtocol& wire, unsigned which, std::span<const std::uint8_t> bytes)
{
  const palpate::WireFrame frame = wire.frame(bytes);
  require(frame.skip + frame.length <= bytes.size());
  for (const std::span<const std::uint8_t> answer : { bytes, bytes.subspan(frame.skip, frame.length) })
  {
    if (const std::optional<WireReading> reading = wire.decode(answer))
    {
      judgeReading(*reading, which);
      require(!wire.isOthers(answer)); // a reading is not passed over
    }
  }
}

/// An order whose numbers are the bytes.
WireOrder orderOf(std::span<const std::uint8_t> bytes)
{
  WireOrder order;
  std::array<double, 9> numbers{};
  std::memcpy(numbers.data(), bytes.data(), std::min(bytes.size(), sizeof numbers));
  for (std::size_t i = 0; i < 3; ++i)
  {
    order.joint_Nm[i] = numbers[i];
    order.motor_Nm[i] = numbers[3 + i];
    order.wrench_D.force[static_cast<int>(i)] = numbers[6 + i];
  }
  return order;
}

/// A motor's number in a Falcon's packet: four characters, the lowest nibble first.
int numberAt(const WireBytes& sent, std::size_t at)
{
  unsigned number = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    number |= static_cast<unsigned>(sent[at + i] - 0x41) << 4 * i;
  }
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(number));
}

void judgeOrder(const WireProtocol& wire, unsigned which, const WireOrder& order)
{
  WireBytes sent;
  wire.encode(order, sent);
  constexpr std::array<std::size_t, 3> lengths{ 14, 16, 10 };
  require(which % 4 == 3 ? sent.size() < 256 : sent.size() == lengths[which % 4]);
  if (which % 4 == 0)
  {
    for (std::size_t at = 0; at < 6; at += 2)
    {
      const auto current_mA = static_cast<std::int16_t>(static_cast<std::uint16_t>(sent[at] | sent[at + 1] << 8U));
      require(std::abs(current_mA) <= 2000);
    }
  }
  if (which % 4 == 1)
  {
    for (std::size_t at = 1; at < 13; at += 4)
    {
      require(std::abs(numberAt(sent, at)) <= 4096);
    }
  }
  if (which % 4 == 2)
  {
    for (std::size_t at = 2; at < 10; at += 4)
    {
      float torque_Nm = 0.0F;
      std::memcpy(&torque_Nm, sent.data() + at, sizeof torque_Nm);
      require(std::fabs(torque_Nm) <= 0.123F);
    }
  }
  if (which % 4 == 3)
  {
    const std::string_view text(reinterpret_cast<const char*>(sent.data()), sent.size());
    require(text.find("null") == std::string_view::npos && text.find("nan") == std::string_view::npos);
  }
}

/// Of an arm that is not refused every number that goes to its board can be sent.
void judgeFile(const palpate::Outcome<palpate::WiredArm>& arm)
{
  require(arm.problem.find('\n') == std::string::npos);
  if (!arm.ok() || !arm.value.wire)
  {
    return;
  }
  const palpate::ArmSetup setup = palpate::setupOf(arm.value);
  require(!setup.pose.empty() && setup.poseTolerance >= 1.0);
  for (const double constant_Nm_per_A : palpate::constantsOf(arm.value.plan))
  {
    require(setup.tellsAngles || constant_Nm_per_A > 0.0);
  }
  if (setup.tellsAngles)
  {
    const palpate::TwoDiyWire::Setup board = palpate::boardOf(arm.value);
    for (std::size_t i = 0; i < board.gear.size(); ++i)
    {
      require(std::fabs(board.offset_deg[i]) <= 360.0 && board.countsPerTurn[i] >= 0.0 && board.gear[i] != 0.0);
    }
  }
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  const std::span<const std::uint8_t> bytes(data + 1, size - 1);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::unique_ptr<WireProtocol> wire = wireOf(data[0]);
  judgeAnswer(*wire, data[0], bytes);
  judgeOrder(*wire, data[0], orderOf(bytes));
  static_cast<void>(palpate::haplyInventory(text));
  static_cast<void>(palpate::haplyHasVector(text));
  static_cast<void>(palpate::haplySession(text));
  static_cast<void>(palpate::haplyStop(text, "049D"));
  judgeFile(palpate::readWoodenHapticsFile(std::string(text)));
  judgeFile(palpate::parseWiredArm(std::string(text)));
  return 0;
}
