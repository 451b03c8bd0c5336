// SPDX-License-Identifier: GPL-3.0-or-later
// The tests; with --push SERIAL, --push-evdev PRODUCT, --push-wheel or --push-arm ROAD SERIAL the program that one of
// them kills: it pushes until it dies.
#include <iostream>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "testing/vm/EventServo.h"
#include "testing/vm/Servo.h"
#include "testing/vm/UinputStick.h"
#include "testing/vm/arm/ArmServo.h"

namespace
{

template<class Servo>
int push(Servo&& servo)
{
  if (const std::string problem = servo.device.open(); !problem.empty())
  {
    std::cerr << problem << "\n";
    return 1;
  }
  servo.command.wrench_D.force = { 2.0, 0.0, 0.0 };
  servo.run(std::numeric_limits<int>::max());
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  using namespace palpate::test;
  const std::string what = argc > 1 ? argv[1] : "";
  if (argc == 3 && what == "--push")
  {
    return push(Servo(argv[2]));
  }
  if (argc == 3 && what == "--push-evdev")
  {
    return push(EventServo(UinputStick::vendor, static_cast<std::uint16_t>(std::stoi(argv[2]))));
  }
  if (argc == 2 && what == "--push-wheel")
  {
    return push(EventServo(0x046D, 0xC24F));
  }
  if (argc == 4 && what == "--push-arm")
  {
    std::cerr << pushArm(argv[2], argv[3]) << "\n";
    return 1;
  }
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
