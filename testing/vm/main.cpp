// SPDX-License-Identifier: GPL-3.0-or-later
// The tests; with --push SERIAL the program that one of them kills: it pushes until it dies.
#include <iostream>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "testing/vm/Servo.h"

namespace
{

int push(const std::string& serial)
{
  palpate::test::Servo servo(serial);
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
  if (argc == 3 && std::string(argv[1]) == "--push")
  {
    return push(argv[2]);
  }
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
