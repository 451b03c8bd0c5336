// SPDX-License-Identifier: GPL-3.0-or-later
// The small languages in the attributes of a drawing; expat stands before them and is not ours. The first byte says
// which.
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "testing/fuzz/Require.h"
#include "vtkHapticSVGPath.h"

namespace
{
void parsePath(std::string_view text)
{
  vtkHapticPlaneLines lines;
  lines.SetTolerance(0.05);
  vtkHapticSVGPath::Append(text, lines);
  for (const vtkHapticPlaneLines::Line& line : lines.Take())
  {
    require(line.size() > 1);
    for (const vtkHapticPlaneLines::Point& p : line)
    {
      require(p.allFinite());
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
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try
  {
    switch (data[0] % 3)
    {
      case 0:
        parsePath(text);
        break;
      case 1:
        require(vtkHapticSVGPath::ParsePoints(text).size() <= size);
        break;
      default:
        static_cast<void>(vtkHapticSVGPath::ParseTransform(text));
    }
  }
  catch (const std::runtime_error& error)
  {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
