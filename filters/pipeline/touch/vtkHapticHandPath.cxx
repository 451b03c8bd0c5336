// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticHandPath.h"

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
} // namespace

vtkHapticHandPath vtkHapticReadHandPath(vtkPolyData* path, const char* timeArray, double rate)
{
  vtkHapticHandPath result;
  std::vector<vtkIdType> order;
  result.Problem = OrderOf(path, order);
  if (result.Problem.empty())
  {
    result.Problem = ReadPoints(path, order, result.Points_W);
  }
  if (!result.Problem.empty())
  {
    return result;
  }
  if (timeArray && *timeArray)
  {
    result.Problem = ReadTimes(path, timeArray, order, result.Times);
    return result;
  }
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    result.Times.push_back(static_cast<double>(i) / rate);
  }
  return result;
}
