// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a value along a path: refused with one phrase, or a world whose forces are numbers everywhere.
#include <cmath>
#include <cstdint>
#include <limits>

#include "haptics/line/LineFile.h"
#include "testing/fuzz/Require.h"

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto parsed = palpate::parseLine({ reinterpret_cast<const char*>(data), size });
  require(parsed.problem.empty() == !parsed.value.empty());
  require(parsed.problem.find('\n') == std::string::npos);
  palpate::LineWorld world;
  world.places = parsed.value;
  palpate::scaleToHardest(world.places, 0.3);
  if (parsed.problem.empty() && world.refusal(std::numeric_limits<double>::infinity()).empty())
  {
    for (const palpate::LinePlace& place : world.places)
    {
      double anchor_m = 0.0;
      require(std::isfinite(palpate::lineForce(world, place.s_m)));
      require(std::isfinite(palpate::lineFriction(world, place.s_m, anchor_m)));
    }
  }
  return 0;
}
