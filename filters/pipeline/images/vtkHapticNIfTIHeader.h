// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticNIfTIHeader_h
#define vtkHapticNIfTIHeader_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "haptics/core/Types.h"

/// Storage types of the values of a NIfTI image. No VTK inside, so that the parser can be fuzzed on its own.
struct vtkHapticNIfTIType
{
  enum class Number : std::uint8_t
  {
    Unsigned,
    Signed,
    Real
  };
  int Code = 0;
  Number Kind = Number::Unsigned;
  int Bytes = 0;       ///< of one number: 1, 2, 4 or 8
  int PerVoxel = 1;    ///< numbers side by side: 2 of a complex one, 3 or 4 of a colour
  bool Colour = false; ///< is never rescaled
};

/// The header of a NIfTI-1 or NIfTI-2 file (Cox et al. 2004; https://nifti.nimh.nih.gov), of either byte order.
struct vtkHapticNIfTIHeader
{
  static constexpr std::size_t LargestBytes = 540; ///< all that the parser looks at

  bool BigEndian = false;
  std::array<int, 3> Size{};  ///< voxels along i, j, k, each at least 1
  std::int64_t TimeSteps = 1; ///< images after one another
  int Vectors = 1;            ///< of each image, stored one whole image after another
  double FirstTime_s = 0.0;
  double TimeStep_s = 1.0; ///< above 0
  vtkHapticNIfTIType Type;
  std::uint64_t DataOffset = 0; ///< bytes in the file, unpacked, before the first value
  double Slope = 1.0;           ///< real value = Slope stored value + Intercept
  double Intercept = 0.0;
  /// Voxel (i, j, k) to the space of the scanner or atlas, in the file's unit of length: sform, else qform, else
  /// spacing alone. Finite and not singular.
  Eigen::Affine3d SpaceFromVoxel = Eigen::Affine3d::Identity();
  std::string Problem; ///< one line: why the file cannot be used; else empty

  [[nodiscard]] bool Rescales() const { return this->Slope != 1.0 || this->Intercept != 0.0; }
  [[nodiscard]] int NumbersPerVoxel() const { return this->Type.PerVoxel * this->Vectors; }
  /// Of one time step; a double since a header may promise anything.
  [[nodiscard]] double BytesPerVoxel() const
  {
    return static_cast<double>(this->Type.Bytes) * this->Type.PerVoxel * this->Vectors;
  }
};

/// `bytes`: the first 540 of the file, unpacked, or all of a shorter one.
[[nodiscard]] vtkHapticNIfTIHeader vtkHapticParseNIfTI(std::string_view bytes);

#endif
