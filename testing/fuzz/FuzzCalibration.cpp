// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a calibration: refused with one phrase, or a calibration that may be applied and that comes back the
// same when it is written and read again.
#include <cstdint>

#include "devices/calibration/Calibration.h"
#include "testing/fuzz/Require.h"

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto parsed = palpate::parseCalibration({ reinterpret_cast<const char*>(data), size });
  require(parsed.problem.empty() == parsed.value.has_value());
  require(parsed.problem.find('\n') == std::string::npos);
  if (parsed.value)
  {
    require(parsed.value->refusal().empty());
    require(
      palpate::parseCalibration(palpate::writeCalibration(*parsed.value)).value == parsed.value);
  }
  return 0;
}
