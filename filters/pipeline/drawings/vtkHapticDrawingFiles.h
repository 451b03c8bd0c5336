// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticDrawingFiles_h
#define vtkHapticDrawingFiles_h

#include <string>

#include "vtkSmartPointer.h"

class vtkPolyData;

/// Drawings and pictures as lines in the plane z = 0, with the field arrays Start and Exit (3) double [u] where they
/// say where a maze begins and ends. Both throw std::runtime_error with one line; `note` receives the ignored elements.
namespace vtkHapticDrawingFiles
{
/// An SVG drawing, see vtkHapticParseSVG: user units, y upwards.
[[nodiscard]] vtkSmartPointer<vtkPolyData> ReadSVG(const std::string& path, std::string& note);

/// A picture in PNG: dark ink on light paper, its strokes thinned to middle lines that are simplified within a pixel.
/// The middle of all green pixels is the start, of all red ones the exit of a maze; they are no ink. Units: pixels, the
/// first one's centre at (0, 0), y upwards.
[[nodiscard]] vtkSmartPointer<vtkPolyData> ReadPNG(const std::string& path, std::string& note);
} // namespace vtkHapticDrawingFiles

#endif
