// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticNIfTIImage_h
#define vtkHapticNIfTIImage_h

#include <cstdint>
#include <string>

#include "vtkHapticNIfTIHeader.h"
#include "vtkSmartPointer.h"

class vtkImageData;

/// A NIfTI file as an image at the place that its header gives it. Both throw std::runtime_error with a sentence.
namespace vtkHapticNIfTIImage
{
/// Of a file that is long enough for its header, as far as its size can tell.
[[nodiscard]] vtkHapticNIfTIHeader ReadHeader(const std::string& path);

/// The image of one time step, 0 or above. Origin, spacing and direction are those of the header; a shear of the header
/// is in the direction's columns. Point array "NIFTI", active: values as stored, or rescaled as the header says, then
/// in double precision, or in single where the stored numbers have no more than 16 bits or are single themselves.
[[nodiscard]] vtkSmartPointer<vtkImageData> Read(
  const std::string& path, const vtkHapticNIfTIHeader& header, std::int64_t step);

/// Gives an image the origin, spacing and direction of the header.
void Place(const vtkHapticNIfTIHeader& header, vtkImageData* image);

/// VTK's number for the type of the values that Read() gives.
[[nodiscard]] int ScalarTypeOf(const vtkHapticNIfTIHeader& header);
} // namespace vtkHapticNIfTIImage

#endif
