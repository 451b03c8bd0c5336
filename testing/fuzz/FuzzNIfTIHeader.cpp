// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticNIfTIHeader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "testing/fuzz/Require.h"

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const vtkHapticNIfTIHeader header = vtkHapticParseNIfTI({ reinterpret_cast<const char*>(data), size });
  require(header.Problem.find('\n') == std::string::npos);
  if (!header.Problem.empty())
  {
    return 0;
  }
  // properties that the readers rely on without asking again
  require(size >= 348 && header.DataOffset >= 348);
  require(std::all_of(header.Size.begin(), header.Size.end(), [](int count) { return count >= 1; }));
  require(header.TimeSteps >= 1 && header.Vectors >= 1 && header.NumbersPerVoxel() >= 1);
  require(header.Type.Bytes == 1 || header.Type.Bytes == 2 || header.Type.Bytes == 4 || header.Type.Bytes == 8);
  require(header.TimeStep_s > 0.0 && std::isfinite(header.FirstTime_s) && std::isfinite(header.TimeStep_s));
  require(std::isfinite(header.Slope) && header.Slope != 0.0 && std::isfinite(header.Intercept));
  require(header.SpaceFromVoxel.matrix().allFinite());
  require(header.SpaceFromVoxel.linear().colwise().norm().minCoeff() > 0.0);
  return 0;
}
