// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that a writer takes from the servo after a loss of its device.
#include <gtest/gtest.h>

#include "devices/io/HandExchange.h"

namespace palpate
{
namespace
{

/// The torque that a writer sends for a command without force.
Vec3 sentFor(HandExchange& exchange, const Vec3& torque_D)
{
  DeviceCommand command;
  command.wrench_D.torque = torque_D;
  exchange.command(command);
  return exchange.wish().command.wrench_D.torque;
}

TEST(HandExchange, SendsNoTorqueAfterALossUntilTheServoHasAskedForNone)
{
  HandExchange exchange(HeldTrust{});
  exchange.tell(HandExchange::Hand{});
  const Vec3 turn_Nm(0.0, 0.0, 0.1);
  EXPECT_EQ(sentFor(exchange, turn_Nm), turn_Nm);
  exchange.mute();
  EXPECT_EQ(sentFor(exchange, turn_Nm), Vec3(Vec3::Zero()));
  EXPECT_EQ(sentFor(exchange, Vec3::Zero()), Vec3(Vec3::Zero()));
  EXPECT_EQ(sentFor(exchange, turn_Nm), turn_Nm);
}

} // namespace
} // namespace palpate
