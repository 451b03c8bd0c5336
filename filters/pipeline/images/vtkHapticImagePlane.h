// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticImagePlane_h
#define vtkHapticImagePlane_h

#include <cstdint>
#include <string>

#include "haptics/core/Types.h"
#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkImageData;

/**
 * A flat image with one value per pixel, wherever it lies in space: a slice along any two of the axes of its grid, with
 * any origin, spacing and direction. Pixel coordinates (i, j) count from the first pixel.
 */
class vtkHapticImagePlane
{
public:
  /// Throws std::runtime_error with one line on the fault of the image. Colours (three or four values a
  /// pixel) become their luminance, unless `coloursCount` is false: then they are refused.
  vtkHapticImagePlane(vtkImageData* image, vtkDataArray* values, bool coloursCount);

  [[nodiscard]] std::uint32_t GetWidth() const { return this->Size[0]; }
  [[nodiscard]] std::uint32_t GetHeight() const { return this->Size[1]; }

  [[nodiscard]] double GetValue(std::int64_t i, std::int64_t j) const;
  /// Least and largest finite value; throws if all pixels have the same, or none is finite.
  void GetRange(double range[2]) const;

  /// Where pixel coordinates are in space [u].
  [[nodiscard]] palpate::Vec3 ToWorld(double i, double j) const;
  /// Distances of neighbouring pixels along i and j [u].
  [[nodiscard]] double GetSpacing(int axis) const;

private:
  vtkImageData* Image;
  vtkSmartPointer<vtkDataArray> Values;
  int Axes[2] = { 0, 1 };
  std::uint32_t Size[2] = { 0, 0 };
};

#endif
