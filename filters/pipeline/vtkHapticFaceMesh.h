// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFaceMesh_h
#define vtkHapticFaceMesh_h

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/// Points and faces as the parsers of text and PLY files give them. No VTK inside, so that the parsers can be
/// fuzzed on their own.
struct vtkHapticFaceMesh
{
  std::vector<double> Coordinates;           ///< x, y, z of every point [scene units]; NaN is kept: cleaning reports it
  std::vector<std::int64_t> Offsets = { 0 }; ///< face i is Connectivity[Offsets[i] .. Offsets[i + 1])
  std::vector<std::int64_t> Connectivity; ///< indices of points, each in [0, NumberOfPoints()) when there is no Problem
  std::string Problem;                    ///< empty, or why the file cannot be used

  [[nodiscard]] std::int64_t NumberOfPoints() const { return static_cast<std::int64_t>(this->Coordinates.size() / 3); }
  [[nodiscard]] std::int64_t NumberOfFaces() const { return static_cast<std::int64_t>(this->Offsets.size()) - 1; }

  /// Ends the face whose corners were appended to Connectivity; throws std::runtime_error when it is no face.
  void CloseFace()
  {
    const auto end = static_cast<std::int64_t>(this->Connectivity.size());
    if (end - this->Offsets.back() < 3)
    {
      throw std::runtime_error("a face has fewer than 3 corners");
    }
    this->Offsets.push_back(end);
  }
};

#endif
