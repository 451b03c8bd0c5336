// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticImageField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <Eigen/Eigenvalues>

using palpate::Vec3;

namespace
{
/// The frame of an image's points; true where its first axis had to be turned round to make it right-handed.
std::pair<palpate::FieldBlockGrid, bool> LatticeOf(vtkImageData& image)
{
  palpate::FieldBlockGrid lattice;
  Eigen::Matrix3d axes_W;
  for (int k = 0; k < 3; ++k)
  {
    lattice.size[k] = image.GetDimensions()[k];
    lattice.spacing_u[k] = image.GetSpacing()[k];
    for (int row = 0; row < 3; ++row)
    {
      axes_W(row, k) = image.GetDirectionMatrix()->GetElement(row, k);
    }
  }
  const bool mirrored = axes_W.determinant() < 0.0;
  const int* const extent = image.GetExtent();
  const int first[3] = { mirrored ? extent[1] : extent[0], extent[2], extent[4] };
  image.TransformIndexToPhysicalPoint(first, lattice.pose_W.p.data());
  if (mirrored)
  {
    axes_W.col(0) = -axes_W.col(0);
  }
  lattice.pose_W.q = palpate::Quat(axes_W).normalized();
  return { lattice, mirrored };
}

/// Points that are blanked, or corners of cells that are.
std::vector<bool> HiddenPoints(vtkImageData& image)
{
  std::vector<bool> hidden;
  vtkUnsignedCharArray* const points = image.GetPointGhostArray();
  vtkUnsignedCharArray* const cells = image.GetCellGhostArray();
  if (points || cells)
  {
    hidden.assign(static_cast<std::size_t>(image.GetNumberOfPoints()), false);
  }
  for (vtkIdType i = 0; points && i < image.GetNumberOfPoints(); ++i)
  {
    hidden[static_cast<std::size_t>(i)] = (points->GetValue(i) & vtkDataSetAttributes::HIDDENPOINT) != 0;
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; cells && i < image.GetNumberOfCells(); ++i)
  {
    if (cells->GetValue(i) & (vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL))
    {
      image.GetCellPoints(i, corners);
      for (const vtkIdType corner : *corners)
      {
        hidden[static_cast<std::size_t>(corner)] = true;
      }
    }
  }
  return hidden;
}

double ScalarOf(const double* tuple, int components, int component)
{
  if (component >= 0 && component < components)
  {
    return tuple[component];
  }
  if (components == 1)
  {
    return tuple[0];
  }
  return Eigen::Map<const Eigen::VectorXd>(tuple, components).norm();
}

/// VTK's order of six: xx, yy, zz, xy, yz, xz. Of nine the symmetric part.
Eigen::Matrix3d TensorOf(const double* tuple, int components)
{
  Eigen::Matrix3d tensor;
  if (components == 6)
  {
    tensor << tuple[0], tuple[3], tuple[5], tuple[3], tuple[1], tuple[4], tuple[5], tuple[4], tuple[2];
    return tensor;
  }
  const Eigen::Map<const Eigen::Matrix3d> all(tuple);
  return 0.5 * (all + all.transpose());
}

/// As long as its eigenvalue is large; NaN where the tensor is not finite.
Vec3 EigenvectorOf(const Eigen::Matrix3d& tensor, int which)
{
  if (!tensor.allFinite())
  {
    return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(tensor); // eigenvalues rise
  const int column = 2 - std::clamp(which, 0, 2);
  return std::abs(solved.eigenvalues()[column]) * solved.eigenvectors().col(column);
}

void Keep(const double* tuple, int components, const vtkHapticFieldPart& part, float* to)
{
  if (palpate::componentsOf(part.Role) == 1)
  {
    *to = static_cast<float>(ScalarOf(tuple, components, part.Component) - part.Offset);
    return;
  }
  const Vec3 kept = part.Role == palpate::FieldBlockRole::Axis
                      ? EigenvectorOf(TensorOf(tuple, components), part.Component)
                      : Vec3(tuple);
  std::transform(kept.begin(), kept.end(), to, [](double number) { return static_cast<float>(number); });
}

/// Copies tuples of one array, of any type that VTK knows, into floats.
struct CopyValues
{
  template<class Array, class Points>
  void operator()(Array* array, const vtkHapticFieldPart& part, const Points& points, std::vector<float>& values) const
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    const int components = array->GetNumberOfComponents();
    const auto kept = static_cast<std::size_t>(palpate::componentsOf(part.Role));
    std::vector<double> tuple(static_cast<std::size_t>(components));
    points(
      [&](vtkIdType point, std::size_t at)
      {
        const auto from = tuples[point];
        if (kept == 1 && components == 1)
        {
          values[at] = static_cast<float>(from[0] - part.Offset);
          return;
        }
        std::copy(from.begin(), from.end(), tuple.begin());
        Keep(tuple.data(), components, part, values.data() + kept * at);
      });
  }
};
} // namespace

void vtkHapticKeepTuple(
  vtkDataArray* array, vtkIdType point, const vtkHapticFieldPart& part, std::vector<float>& values)
{
  const int components = array->GetNumberOfComponents();
  std::vector<double> tuple(static_cast<std::size_t>(components));
  array->GetTuple(point, tuple.data());
  Keep(tuple.data(), components, part, values.data() + palpate::componentsOf(part.Role) * point);
}

vtkHapticImageField::vtkHapticImageField(vtkSmartPointer<vtkImageData> image, vtkHapticFieldArrays arrays)
  : Image(std::move(image)), Arrays(std::move(arrays)), Hidden(HiddenPoints(*this->Image))
{
  std::tie(this->Lattice, this->Mirrored) = LatticeOf(*this->Image);
}

palpate::MadeFieldBlock vtkHapticImageField::brickAround(const palpate::FieldBlockWish& wish) const
{
  const auto read = [this](const auto& part, const auto& window) { return this->Read(part, window); };
  palpate::MadeFieldBlock made = vtkHapticFieldBlockAround(this->Lattice, this->Arrays, read, wish);
  this->Levels.Tell(made, wish, this->Lattice, this->Arrays, read);
  return made;
}

vtkIdType vtkHapticImageField::PointId(int i, int j, int k) const
{
  const palpate::GridIndex& size = this->Lattice.size;
  return (this->Mirrored ? size[0] - 1 - i : i) +
         static_cast<vtkIdType>(size[0]) * (j + static_cast<vtkIdType>(size[1]) * k);
}

bool vtkHapticImageField::IsHidden(vtkIdType point) const
{
  return !this->Hidden.empty() && this->Hidden[static_cast<std::size_t>(point)];
}

std::vector<float> vtkHapticImageField::Read(const vtkHapticFieldPart& part, const vtkHapticFieldWindow& window) const
{
  const int kept = palpate::componentsOf(part.Role);
  std::vector<float> values(window.Index(0, 0, window.Size[2]) * static_cast<std::size_t>(kept));
  const auto forEachPoint = [&](const auto& visit)
  {
    for (int k = 0; k < window.Size[2]; ++k)
    {
      for (int j = 0; j < window.Size[1]; ++j)
      {
        for (int i = 0; i < window.Size[0]; ++i)
        {
          visit(this->PointId(window.First[0] + i, window.First[1] + j, window.First[2] + k), window.Index(i, j, k));
        }
      }
    }
  };
  vtkDataArray* const array = this->Image->GetPointData()->GetArray(part.Name.c_str());
  if (!vtkArrayDispatch::Dispatch::Execute(array, CopyValues(), part, forEachPoint, values))
  {
    CopyValues()(array, part, forEachPoint, values);
  }
  forEachPoint(
    [&](vtkIdType point, std::size_t at)
    {
      if (this->IsHidden(point))
      {
        std::fill_n(
          values.begin() + static_cast<std::ptrdiff_t>(at) * kept, kept, std::numeric_limits<float>::quiet_NaN());
      }
    });
  return values;
}
