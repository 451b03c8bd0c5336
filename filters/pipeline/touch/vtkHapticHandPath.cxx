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
/// The order of the points, or what is wrong with the lines.
std::string OrderOf(vtkPolyData* path, std::vector<vtkIdType>& order)
{
  if (std::string problem = vtkHapticCellChecks::CheckPolyData(path); !problem.empty())
  {
    return problem;
  }
  const vtkIdType lines = path->GetNumberOfLines();
  if (lines > 1)
  {
    return "it has " + std::to_string(lines) + " lines; join them into one polyline";
  }
  if (lines == 1)
  {
    vtkNew<vtkIdList> ids;
    path->GetLines()->GetCellAtId(0, ids);
    order.assign(ids->begin(), ids->end());
  }
  else
  {
    order.resize(static_cast<std::size_t>(path->GetNumberOfPoints()));
    std::iota(order.begin(), order.end(), 0);
  }
  return order.empty() ? "it has no points" : "";
}

std::string ReadPoints(vtkPolyData* path, const std::vector<vtkIdType>& order, std::vector<palpate::Vec3>& points_W)
{
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    palpate::Vec3 p_W;
    path->GetPoint(order[i], p_W.data());
    if (!p_W.allFinite())
    {
      return "its point " + std::to_string(i) + " is not finite";
    }
    points_W.push_back(p_W);
  }
  return {};
}

std::string ReadTimes(
  vtkPolyData* path, const std::string& name, const std::vector<vtkIdType>& order, std::vector<double>& times)
{
  vtkDataArray* array = path->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return "it has no point array '" + name + "' of one number a point; name the one that holds the time [s]";
  }
  for (const vtkIdType id : order)
  {
    const double time = array->GetComponent(id, 0);
    if (!std::isfinite(time) || (!times.empty() && !(time > times.back())))
    {
      return "its time '" + name + "' does not increase at point " + std::to_string(times.size());
    }
    times.push_back(time);
  }
  return {};
}

std::string ReadTurns(
  vtkPolyData* path, const std::string& name, const std::vector<vtkIdType>& order, std::vector<palpate::Quat>& turns)
{
  vtkDataArray* array = path->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 4)
  {
    return "it has no point array '" + name + "' of four numbers a point; name the one that holds quaternions w x y z";
  }
  constexpr double tolerance = 1e-3; // what a file with few digits loses
  for (const vtkIdType id : order)
  {
    std::array<double, 4> q{};
    array->GetTuple(id, q.data());
    turns.emplace_back(q[0], q[1], q[2], q[3]);
    if (!(std::abs(turns.back().norm() - 1.0) <= tolerance))
    {
      return "its turn '" + name + "' is no unit quaternion at point " + std::to_string(turns.size() - 1);
    }
    turns.back().normalize();
  }
  return {};
}
} // namespace

vtkHapticHandPath vtkHapticReadHandPath(vtkPolyData* path, const vtkHapticPathArrays& arrays)
{
  const auto named = [](const char* array) { return array && *array; };
  vtkHapticHandPath result;
  std::vector<vtkIdType> order;
  result.Problem = OrderOf(path, order);
  if (result.Problem.empty())
  {
    result.Problem = ReadPoints(path, order, result.Points_W);
  }
  if (result.Problem.empty() && named(arrays.Turns))
  {
    result.Problem = ReadTurns(path, arrays.Turns, order, result.Turns);
  }
  if (result.Problem.empty() && named(arrays.Times))
  {
    result.Problem = ReadTimes(path, arrays.Times, order, result.Times);
  }
  for (std::size_t i = 0; i < order.size() && result.Problem.empty() && !named(arrays.Times); ++i)
  {
    result.Times.push_back(static_cast<double>(i) / arrays.Rate);
  }
  return result;
}
