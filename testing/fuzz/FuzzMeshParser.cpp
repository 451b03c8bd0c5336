// SPDX-License-Identifier: GPL-3.0-or-later
// One harness for the parsers of untrusted mesh files; PARSER and PARSER_HEADER are given by the build.
#include PARSER_HEADER

#include <cstdint>

#include "testing/fuzz/Require.h"

namespace
{
/// The properties that the readers rely on without asking again.
void requireConsistent(const vtkHapticFaceList& list, std::int64_t points)
{
  require(!list.Offsets.empty() && list.Offsets.front() == 0);
  require(list.Offsets.back() == static_cast<std::int64_t>(list.Connectivity.size()));
  for (std::size_t i = 1; i < list.Offsets.size(); ++i)
  {
    require(list.Offsets[i] - list.Offsets[i - 1] >= 3);
  }
  for (const std::int64_t index : list.Connectivity)
  {
    require(index >= 0 && index < points);
  }
}
} // namespace

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const vtkHapticFaceMesh mesh = PARSER({ reinterpret_cast<const char*>(data), size });
  require(mesh.Coordinates.size() % 3 == 0);
  requireConsistent(mesh.Faces, mesh.NumberOfPoints());
  requireConsistent(mesh.Strips, mesh.NumberOfPoints());
  require(mesh.Problem.empty() || mesh.NumberOfPoints() == 0);
  require(mesh.Problem.find('\n') == std::string::npos);
  // a header's promise costs nothing: memory follows the length of the file
  require(mesh.Coordinates.capacity() <= 3 * size + 64);
  require(mesh.Faces.Connectivity.capacity() + mesh.Strips.Connectivity.capacity() <= 2 * size + 64);
  return 0;
}
