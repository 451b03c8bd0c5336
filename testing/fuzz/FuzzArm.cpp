// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as an arm file: refused with one phrase, or an arm whose numbers are finite.
#include <cstdint>

#include "haptics/arm/file/ArmFile.h"
#include "haptics/arm/shown/ArmWorkSpaceMap.h"
#include "testing/fuzz/Require.h"

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto parsed = palpate::parseArm({ reinterpret_cast<const char*>(data), size });
  require(parsed.problem.find('\n') == std::string::npos);
  if (!parsed.ok())
  {
    return 0;
  }
  const palpate::Arm arm(parsed.value);
  const palpate::JointVector q = arm.jointsOf({ 100, -200, 300, -400, 500, -600 });
  const palpate::Posture posture = arm.posture(q);
  require(posture.tip.p.allFinite() && posture.jacobian.allFinite());
  const double fade = arm.forceFade(q, posture);
  require(fade >= 0.0 && fade <= 1.0);
  static_cast<void>(arm.inverse(parsed.value.workSpace.centre_D));
  return 0;
}
