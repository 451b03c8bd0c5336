// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a recording of each session in today's format: palpate-make-fixtures FOLDER. Files in fixtures/ stay.
#include <iostream>
#include <string>

#include "haptics/recording/Recording.h"
#include "testing/haptics/recording/FixtureSessions.h"

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "one argument is needed: the folder to write to\n";
    return 1;
  }
  const std::string start = std::string(argv[1]) + "/format-" + std::to_string(palpate::Recording::formatVersion);
  const std::string problem =
    palpate::test::recordSolid(start + "-solid.palpate") + palpate::test::recordPlane(start + "-plane.palpate");
  std::cerr << problem;
  return problem.empty() ? 0 : 1;
}
