// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFaceMesh_h
#define vtkHapticFaceMesh_h

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/// Lists of indices of points, one a face or strip.
struct vtkHapticFaceList
{
  std::vector<std::int64_t> Offsets = { 0 }; ///< list i is Connectivity[Offsets[i] .. Offsets[i + 1])
  std::vector<std::int64_t> Connectivity;    ///< each in [0, number of points) when the mesh has no Problem

  [[nodiscard]] std::int64_t Count() const { return static_cast<std::int64_t>(this->Offsets.size()) - 1; }
  /// How many indices were appended behind the last list.
  [[nodiscard]] std::int64_t Open() const
  {
    return static_cast<std::int64_t>(this->Connectivity.size()) - this->Offsets.back();
  }

  /// Ends the list whose indices were appended to Connectivity; throws std::runtime_error when it is no face.
  void Close()
  {
    if (this->Open() < 3)
    {
      throw std::runtime_error("a face has fewer than 3 corners");
    }
    this->Offsets.push_back(static_cast<std::int64_t>(this->Connectivity.size()));
  }
};

/// Points and faces as the parsers of text and PLY files give them. No VTK inside, so that the parsers can be
/// fuzzed on their own.
struct vtkHapticFaceMesh
{
  std::vector<double> Coordinates; ///< x, y, z of every point [scene units]; NaN is kept: cleaning reports it
  vtkHapticFaceList Faces;         ///< polygons
  vtkHapticFaceList Strips;        ///< of triangles, each of three points in a row, the second one turned around
  std::string Problem;             ///< empty, or why the file cannot be used

  [[nodiscard]] std::int64_t NumberOfPoints() const { return static_cast<std::int64_t>(this->Coordinates.size() / 3); }
};

#endif
