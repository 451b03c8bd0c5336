// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFieldShape.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "haptics/field/laws/Follow.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using palpate::FieldBlock;
using palpate::FieldBlockRole;
using palpate::Vec3;

namespace
{
constexpr int CellsAround = 6; ///< of the proxy: a patch as large as a hand looks at, made anew for each picture

/// The values around a place, in index coordinates, as far as there are any.
vtkSmartPointer<vtkImageData> ValuesAround(const FieldBlock& brick, const Vec3& index)
{
  int extent[6];
  for (int k = 0; k < 3; ++k)
  {
    const double last = brick.grid().size[k] - 1, middle = std::clamp(index[k], 0.0, last);
    extent[2 * k] = static_cast<int>(std::max(0.0, std::floor(middle) - CellsAround));
    extent[2 * k + 1] = static_cast<int>(std::min(last, std::ceil(middle) + CellsAround));
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(extent);
  const palpate::FieldBlockComponent values = brick.component(FieldBlockRole::Scalar);
  vtkNew<vtkDoubleArray> array;
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      for (int x = extent[0]; x <= extent[1]; ++x)
      {
        array->InsertNextValue(values.at({ x, y, z }));
      }
    }
  }
  image->GetPointData()->SetScalars(array);
  return image;
}

void AddPatch(const FieldBlock& brick, double isovalue, const Vec3& proxy_W, vtkPolyData* shape)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(ValuesAround(brick, brick.grid().toIndex(proxy_W)));
  contour->SetValue(0, isovalue);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkPolyData* const patch = contour->GetOutput();
  for (vtkIdType i = 0; i < patch->GetNumberOfPoints(); ++i)
  {
    shape->GetPoints()->InsertNextPoint(brick.grid().toWorld(Vec3(patch->GetPoint(i))).data());
  }
  shape->SetPolys(patch->GetPolys());
}

/// Along the streamline through a place, forwards or backwards.
std::vector<Vec3> Walk(const FieldBlock& brick, const Vec3& from_W, double step_u)
{
  std::vector<Vec3> way{ from_W };
  Vec3 ahead = Vec3::Zero();
  for (int i = 0; i < 4 * CellsAround; ++i)
  {
    const auto here = palpate::followStreamline(brick, way.back(), way.back());
    const double sign = here && ahead.dot(here->along_W) < 0.0 ? -1.0 : 1.0;
    ahead = here ? Vec3(sign * here->along_W) : ahead;
    const auto next = here ? palpate::followStreamline(brick, way.back(), way.back() + step_u * ahead) : std::nullopt;
    if (!next)
    {
      break;
    }
    way.push_back(next->y_W);
  }
  return way;
}

void AddLine(const std::vector<Vec3>& line_W, vtkPolyData* shape)
{
  shape->GetLines()->InsertNextCell(static_cast<int>(line_W.size()));
  for (const Vec3& p_W : line_W)
  {
    shape->GetLines()->InsertCellPoint(shape->GetPoints()->InsertNextPoint(p_W.data()));
  }
}

void AddStreamline(const FieldBlock& brick, const Vec3& proxy_W, vtkPolyData* shape)
{
  const double step_u = 0.5 * brick.grid().spacing_u.minCoeff();
  std::vector<Vec3> line = Walk(brick, proxy_W, -step_u);
  std::reverse(line.begin(), line.end());
  const std::vector<Vec3> forward = Walk(brick, proxy_W, step_u);
  line.insert(line.end(), forward.begin() + 1, forward.end());
  AddLine(line, shape);
}

/// A square along the level that the proxy is on.
void AddLevel(const FieldBlock& brick, const Vec3& proxy_W, vtkPolyData* shape)
{
  const auto sample = brick.sample(FieldBlockRole::Scalar, proxy_W);
  if (!sample || sample->gradient_W.isZero(0.0))
  {
    return;
  }
  const double half_u = 0.5 * CellsAround * brick.grid().spacing_u.minCoeff();
  const Vec3 one = half_u * sample->gradient_W.unitOrthogonal();
  const Vec3 other = half_u * sample->gradient_W.cross(one).normalized();
  AddLine({ proxy_W + one, proxy_W + other, proxy_W - one, proxy_W - other, proxy_W + one }, shape);
}

/// A cross at the place that a hand is drawn to, and the line there.
void AddSnap(const FieldBlock& brick, double reach_u, const Vec3& hand_W, vtkPolyData* shape)
{
  const auto place_W = brick.nearestPlace_W(hand_W, reach_u);
  if (!place_W)
  {
    return;
  }
  AddLine({ hand_W, *place_W }, shape);
  for (int k = 0; k < 3; ++k)
  {
    const Vec3 arm = brick.grid().spacing_u.minCoeff() * Vec3::Unit(k);
    AddLine({ *place_W - arm, *place_W + arm }, shape);
  }
}
} // namespace

void vtkHapticFieldShape(
  const FieldBlock& brick, const palpate::FieldPlan& plan, const Vec3& hand_W, const Vec3& proxy_W, vtkPolyData* shape)
{
  shape->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  shape->SetPoints(points);
  vtkNew<vtkCellArray> lines;
  shape->SetLines(lines);
  if (plan.isosurface && brick.component(FieldBlockRole::Scalar).exists())
  {
    AddPatch(brick, plan.isovalue, proxy_W, shape);
  }
  if (plan.follow_N > 0.0 && brick.component(FieldBlockRole::Vector).exists())
  {
    AddStreamline(brick, proxy_W, shape);
  }
  if (plan.detent.strength_N > 0.0)
  {
    AddLevel(brick, proxy_W, shape);
  }
  if (plan.snap_N > 0.0)
  {
    AddSnap(brick, plan.snapReach_u, hand_W, shape);
  }
}
