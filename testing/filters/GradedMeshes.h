// SPDX-License-Identifier: GPL-3.0-or-later
// Graded meshes as in fluid dynamics, and the values that VTK's probe finds in them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "haptics/field/cells/GridPlace.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"

namespace palpate::testing
{

inline constexpr double handStep_u = 0.012; ///< of a tick: 0.3 m/s where 25 mm of the hand are one unit
inline constexpr double layer_u = 0.0127;

inline double profile(double y)
{
  return 1.0 - std::exp(-y / layer_u);
}

/// Steps that grow until they are as long as asked.
inline std::vector<double> graded(double first, double growth, double end)
{
  std::vector<double> at{ 0.0 };
  for (double step = first; at.back() < end; step *= growth)
  {
    at.push_back(at.back() + step);
  }
  return at;
}

template<class Place, class Value>
vtkSmartPointer<vtkStructuredGrid> gridOf(const GridIndex& size, const Place& place, const Value& value)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> values;
  values->SetName("u");
  for (int n = 0; n < size[0] * size[1] * size[2]; ++n)
  {
    const Vec3 p = place(n % size[0], n / size[0] % size[1], n / (size[0] * size[1]));
    points->InsertNextPoint(p.data());
    values->InsertNextValue(static_cast<float>(value(p)));
  }
  grid->SetDimensions(size.data());
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(values);
  return grid;
}

/// How far the layers of the channel are from its wall.
inline std::vector<double> channelLayers()
{
  return graded(1e-3, 1.2, 3.0);
}

/// Cells of 1e-3 at the wall y = 0, and of half a unit in the middle of the flow.
inline vtkSmartPointer<vtkStructuredGrid> channel(int along, int across)
{
  const std::vector<double> y = channelLayers();
  const double dx = 6.0 / (along - 1), dz = 3.0 / (across - 1);
  return gridOf(
    { along, static_cast<int>(y.size()), across },
    [&](int i, int j, int k) { return Vec3(dx * i, y[static_cast<std::size_t>(j)], dz * k); },
    [](const Vec3& p) { return profile(p.y()); });
}

/// How far the layers round the ball are from it.
inline std::vector<double> oGridLayers()
{
  return graded(2e-3, 1.2, 4.0);
}

/// Round a ball of radius 1, with a seam and two poles.
inline vtkSmartPointer<vtkStructuredGrid> oGrid()
{
  constexpr int turns = 48, bends = 25;
  const std::vector<double> r = oGridLayers();
  return gridOf(
    { turns + 1, bends, static_cast<int>(r.size()) },
    [&](int i, int j, int k)
    {
      const double turn = 2.0 * std::numbers::pi * i / turns, bend = std::numbers::pi * j / (bends - 1);
      return Vec3((1.0 + r[static_cast<std::size_t>(k)]) *
                  Vec3(std::sin(bend) * std::cos(turn), std::sin(bend) * std::sin(turn), std::cos(bend)));
    },
    [](const Vec3& p) { return profile(p.norm() - 1.0); });
}

/// Values of the cells of data at the points of other data; NaN where VTK finds none.
inline std::vector<double> probed(vtkDataSet* at, vtkDataSet* data)
{
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(at);
  probe->SetSourceData(data);
  probe->Update();
  vtkDataArray* const found = probe->GetOutput()->GetPointData()->GetArray("u");
  vtkDataArray* const valid = probe->GetOutput()->GetPointData()->GetArray(probe->GetValidPointMaskArrayName());
  std::vector<double> values;
  for (vtkIdType i = 0; i < at->GetNumberOfPoints(); ++i)
  {
    values.push_back(valid->GetTuple1(i) != 0.0 ? found->GetTuple1(i) : std::nan(""));
  }
  return values;
}

/// How far apart the layers beside a height are.
inline double cellAt(const std::vector<double>& layers, double height)
{
  const auto above = std::upper_bound(layers.begin(), layers.end(), height);
  return *above - *(above - 1);
}

/// Where VTK's probe of the cells finds a value on the rays from the origin through some places; values rise outward.
inline std::vector<double> radiiOf(double value, const std::vector<Vec3>& through, vtkDataSet* data)
{
  std::vector<double> low(through.size(), 1.0), high(through.size(), 1.2);
  constexpr int halvings = 30;
  for (int step = 0; step < halvings; ++step)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (std::size_t i = 0; i < through.size(); ++i)
    {
      const Vec3 p = 0.5 * (low[i] + high[i]) * through[i].normalized();
      points->InsertNextPoint(p.data());
    }
    vtkNew<vtkPolyData> places;
    places->SetPoints(points);
    const std::vector<double> found = probed(places, data);
    for (std::size_t i = 0; i < through.size(); ++i)
    {
      const double middle = 0.5 * (low[i] + high[i]);
      (found[i] >= value ? high[i] : low[i]) = middle; // where there is no value the ball begins
    }
  }
  return high;
}

} // namespace palpate::testing
