// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticNIfTIImage.h"

#include <cstring>
#include <stdexcept>

#include "vtkByteSwap.h"
#include "vtkDataArray.h"
#include "vtkHapticFileGuards.h"
#include "vtkHapticPackedFile.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

namespace
{
using Number = vtkHapticNIfTIType::Number;
using ArrayPointer = vtkSmartPointer<vtkDataArray>;

int StoredType(const vtkHapticNIfTIType& type)
{
  if (type.Kind == Number::Real)
  {
    return type.Bytes == 4 ? VTK_FLOAT : VTK_DOUBLE;
  }
  const bool isSigned = type.Kind == Number::Signed;
  switch (type.Bytes)
  {
    case 1:
      return isSigned ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
    case 2:
      return isSigned ? VTK_SHORT : VTK_UNSIGNED_SHORT;
    case 4:
      return isSigned ? VTK_INT : VTK_UNSIGNED_INT;
    default:
      return isSigned ? VTK_LONG_LONG : VTK_UNSIGNED_LONG_LONG;
  }
}

/// The values of one step, one voxel after another within each of its vectors.
ArrayPointer ReadStored(
  const std::string& path, const vtkHapticNIfTIHeader& header, vtkIdType voxels, std::int64_t step)
{
  auto stored = ArrayPointer::Take(vtkDataArray::CreateDataArray(StoredType(header.Type)));
  stored->SetNumberOfComponents(header.Type.PerVoxel);
  stored->SetNumberOfTuples(voxels * header.Vectors);
  const auto numbers = static_cast<std::size_t>(stored->GetNumberOfValues());
  const std::size_t bytes = numbers * static_cast<std::size_t>(header.Type.Bytes);
  const std::size_t image = static_cast<std::size_t>(voxels) * static_cast<std::size_t>(header.Type.PerVoxel) *
                            static_cast<std::size_t>(header.Type.Bytes);
  vtkHapticPackedFile file(path);
  file.Skip(header.DataOffset);
  std::size_t read = 0;
  for (int vector = 0; vector < header.Vectors; ++vector)
  {
    const auto before = static_cast<std::uint64_t>(vector == 0 ? step : header.TimeSteps - 1);
    file.Skip(before * image);
    read += file.Read(static_cast<char*>(stored->GetVoidPointer(0)) + static_cast<std::size_t>(vector) * image, image);
  }
  if (read < bytes)
  {
    throw std::runtime_error(
      "it is cut short: " + std::to_string(read) + " of " + std::to_string(bytes) + " bytes of the image are present");
  }
  if (header.BigEndian)
  {
    vtkByteSwap::SwapVoidRange(stored->GetVoidPointer(0), numbers, static_cast<std::size_t>(header.Type.Bytes));
  }
  return stored;
}

/// All numbers of a voxel side by side.
ArrayPointer Interleave(vtkDataArray* stored, const vtkHapticNIfTIHeader& header, vtkIdType voxels)
{
  auto values = ArrayPointer::Take(vtkDataArray::CreateDataArray(stored->GetDataType()));
  values->SetNumberOfComponents(header.NumbersPerVoxel());
  values->SetNumberOfTuples(voxels);
  const auto each = static_cast<std::size_t>(header.Type.PerVoxel) * static_cast<std::size_t>(header.Type.Bytes);
  const auto* from = static_cast<const char*>(stored->GetVoidPointer(0));
  auto* const to = static_cast<char*>(values->GetVoidPointer(0));
  const auto vectors = static_cast<std::size_t>(header.Vectors);
  for (std::size_t vector = 0; vector < vectors; ++vector)
  {
    for (std::size_t voxel = 0; voxel < static_cast<std::size_t>(voxels); ++voxel, from += each)
    {
      std::memcpy(to + (voxel * vectors + vector) * each, from, each);
    }
  }
  return values;
}

/// The values as the header scales them.
ArrayPointer Rescale(vtkDataArray* stored, const vtkHapticNIfTIHeader& header)
{
  auto values = ArrayPointer::Take(vtkDataArray::CreateDataArray(vtkHapticNIfTIImage::ScalarTypeOf(header)));
  values->SetNumberOfComponents(stored->GetNumberOfComponents());
  values->SetNumberOfTuples(stored->GetNumberOfTuples());
  for (vtkIdType tuple = 0; tuple < stored->GetNumberOfTuples(); ++tuple)
  {
    for (int component = 0; component < stored->GetNumberOfComponents(); ++component)
    {
      values->SetComponent(tuple, component, header.Slope * stored->GetComponent(tuple, component) + header.Intercept);
    }
  }
  return values;
}
} // namespace

void vtkHapticNIfTIImage::Place(const vtkHapticNIfTIHeader& header, vtkImageData* image)
{
  const Eigen::Affine3d& map = header.SpaceFromVoxel;
  const palpate::Vec3 spacing = map.linear().colwise().norm();
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> direction;
  direction = map.linear() * spacing.cwiseInverse().asDiagonal();
  image->SetOrigin(map.translation().data());
  image->SetSpacing(spacing.data());
  image->SetDirectionMatrix(direction.data());
}

int vtkHapticNIfTIImage::ScalarTypeOf(const vtkHapticNIfTIHeader& header)
{
  const int stored = StoredType(header.Type);
  if (!header.Rescales())
  {
    return stored;
  }
  return header.Type.Bytes <= 2 || stored == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE;
}

vtkHapticNIfTIHeader vtkHapticNIfTIImage::ReadHeader(const std::string& path)
{
  std::string bytes(vtkHapticNIfTIHeader::LargestBytes, '\0');
  bytes.resize(vtkHapticPackedFile(path).Read(bytes.data(), bytes.size()));
  vtkHapticNIfTIHeader header = vtkHapticParseNIfTI(bytes);
  vtkHapticFileGuards::ThrowIf(header.Problem);
  const bool compressed = path.ends_with(".gz") || path.ends_with(".GZ");
  vtkHapticFileGuards::ThrowIf(vtkHapticFileGuards::CheckImageBytes(
    path, header.Size.data(), header.BytesPerVoxel() * static_cast<double>(header.TimeSteps), compressed));
  return header;
}

vtkSmartPointer<vtkImageData> vtkHapticNIfTIImage::Read(
  const std::string& path, const vtkHapticNIfTIHeader& header, std::int64_t step)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(header.Size.data());
  Place(header, image);
  const vtkIdType voxels = image->GetNumberOfPoints();
  ArrayPointer values = ReadStored(path, header, voxels, step);
  values = header.Vectors > 1 ? Interleave(values, header, voxels) : values;
  values = header.Rescales() ? Rescale(values, header) : values;
  values->SetName("NIFTI");
  image->GetPointData()->SetScalars(values);
  return image;
}
