// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticHandPath.h"

#include <array>
#include <cmath>
#include <numeric>

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkHapticCellChecks.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace
{
/// The order of the points, or the fault of the lines.
std::string OrderOf(vtkPolyData& path, std::vector<vtkIdType>& order)
{
  if (std::string problem = vtkHapticCellChecks::CheckPolyData(&path); !problem.empty())
  {
    return problem;
  }
  const vtkIdType lines = path.GetNumberOfLines();
  if (lines > 1)
  {
    return "it has " + std::to_string(lines) + " lines; join them into one polyline";
  }
  if (lines == 1)
  {
    vtkNew<vtkIdList> ids;
    path.GetLines()->GetCellAtId(0, ids);
    order.assign(ids->begin(), ids->end());
  }
  else
  {
    order.resize(static_cast<std::size_t>(path.GetNumberOfPoints()));
    std::iota(order.begin(), order.end(), 0);
  }
  return order.empty() ? "it has no points" : "";
}

/// An array of that many numbers a point; null with a problem where it is named and not there.
vtkDataArray* ArrayOf(vtkPolyData& path, const char* name, int components, const char* what, std::string& problem)
{
  if (!name || !*name)
  {
    return nullptr;
  }
  vtkDataArray* const array = path.GetPointData()->GetArray(name);
  if (array && array->GetNumberOfComponents() == components)
  {
    return array;
  }
  problem = std::string("it has no point array '") + name + "' of " + what;
  return nullptr;
}

/// One point of the path, or its fault.
std::string Sample(
  vtkPolyData& path, vtkIdType id, vtkDataArray* times, vtkDataArray* turns, palpate::PathSample& sample)
{
  constexpr double tolerance = 1e-3; // rounding in a file with few digits
  path.GetPoint(id, sample.hand_W.p.data());
  if (turns)
  {
    std::array<double, 4> q{};
    turns->GetTuple(id, q.data());
    sample.hand_W.q = palpate::Quat(q[0], q[1], q[2], q[3]);
  }
  const bool isTurn = std::abs(sample.hand_W.q.norm() - 1.0) <= tolerance;
  sample.hand_W.q.normalize();
  sample.time_s = times ? times->GetComponent(id, 0) : sample.time_s;
  return !sample.hand_W.p.allFinite() ? "its position is not finite"
         : !isTurn                    ? std::string("its rotation '") + turns->GetName() + "' is not a unit quaternion"
                                      : "";
}
} // namespace

std::vector<palpate::PathSample> vtkHapticReadHandPath(
  vtkPolyData& path, const vtkHapticPathArrays& arrays, std::string& problem)
{
  std::vector<vtkIdType> order;
  problem = OrderOf(path, order);
  vtkDataArray* const turns =
    ArrayOf(path, arrays.Turns, 4, "four numbers per point; name the array with quaternions w x y z", problem);
  vtkDataArray* const times =
    ArrayOf(path, arrays.Times, 1, "one number per point; name the array with the time [s]", problem);
  std::vector<palpate::PathSample> samples;
  for (std::size_t i = 0; i < order.size() && problem.empty(); ++i)
  {
    samples.push_back({ static_cast<double>(i) / arrays.Rate, {} });
    palpate::PathSample& sample = samples.back();
    problem = Sample(path, order[i], times, turns, sample);
    const bool later = std::isfinite(sample.time_s) && (i == 0 || sample.time_s > samples[i - 1].time_s);
    problem = problem.empty() && !later ? "its time does not increase" : problem;
    problem += problem.empty() ? "" : " at point " + std::to_string(i);
  }
  return problem.empty() ? samples : std::vector<palpate::PathSample>{};
}
