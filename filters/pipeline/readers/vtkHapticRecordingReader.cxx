// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticRecordingReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <variant>

#include "haptics/recording/way/Trajectory.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkHapticFileGuards.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtksys/SystemTools.hxx"

vtkStandardNewMacro(vtkHapticRecordingReader);

namespace
{
using Point = palpate::TrajectoryPoint;
using Points = std::span<const Point>;
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Adds an array with the value of each point, for the hand and then again for the proxy.
template<class Array, class ValueOf>
void AddArray(vtkPolyData* data, const char* name, Points points, ValueOf valueOf)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(2 * points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), valueOf(points[i]));
    array->SetValue(static_cast<vtkIdType>(points.size() + i), valueOf(points[i]));
  }
  data->GetPointData()->AddArray(array);
}

void AddForce(vtkPolyData* data, Points points)
{
  vtkNew<vtkDoubleArray> force;
  force->SetName("Force");
  force->SetNumberOfComponents(3);
  for (int part = 0; part < 2; ++part)
  {
    for (const Point& point : points)
    {
      force->InsertNextTuple(point.force_W.data());
    }
  }
  data->GetPointData()->AddArray(force);
  data->GetPointData()->SetActiveScalars("Force"); // by which ParaView colours the path
}

/// First the hands, then the proxies, with their arrays; no cells.
void AddPoints(vtkPolyData* data, Points points)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkIntArray> part;
  part->SetName("Part");
  for (const bool proxy : { false, true })
  {
    for (const Point& point : points)
    {
      places->InsertNextPoint((proxy ? point.proxy_W : point.hand_W).data());
      part->InsertNextValue(proxy ? 1 : 0);
    }
  }
  data->SetPoints(places);
  AddForce(data, points);
  AddArray<vtkDoubleArray>(data, "Depth", points, [](const Point& p) { return p.depth_u(); });
  AddArray<vtkDoubleArray>(data, "Lateness", points, [](const Point& p) { return p.lateness_s; });
  AddArray<vtkDoubleArray>(data, "StiffnessShare", points, [](const Point& p) { return p.stiffnessShare; });
  AddArray<vtkDoubleArray>(data, "ExcessEnergy", points, [](const Point& p) { return p.excess_J; });
  AddArray<vtkIntArray>(data, "Contacts", points, [](const Point& p) { return p.contacts; });
  AddArray<vtkIdTypeArray>(data, "Tick", points, [](const Point& p) { return static_cast<vtkIdType>(p.tick); });
  AddArray<vtkDoubleArray>(data, "Time", points, [](const Point& p) { return p.time_s; });
  data->GetPointData()->AddArray(part);
}

void FillPath(vtkPolyData* path, Points points)
{
  AddPoints(path, points);
  vtkNew<vtkCellArray> lines;
  const auto count = static_cast<vtkIdType>(points.size());
  for (const vtkIdType first : { vtkIdType{ 0 }, count })
  {
    lines->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      lines->InsertCellPoint(first + i);
    }
  }
  path->SetLines(lines);
}

void FillMoment(vtkPolyData* moment, const Point& point)
{
  AddPoints(moment, Points(&point, 1));
  vtkNew<vtkCellArray> ends;
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(2);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    ends->InsertNextCell(1, &i);
    line->InsertCellPoint(i);
  }
  moment->SetVerts(ends);
  moment->SetLines(line);
}

/// The first tick at or after each step; never more than there are ticks.
std::vector<double> StepsOf(Points points, double rate)
{
  std::vector<double> steps;
  double next = points.front().time_s;
  for (const Point& point : points)
  {
    if (point.time_s >= next && (steps.empty() || point.time_s > steps.back()))
    {
      steps.push_back(point.time_s);
      next = rate > 0.0 ? (std::floor(point.time_s * rate) + 1.0) / rate : point.time_s;
    }
  }
  return steps;
}

/// The last point that is not after the time asked for.
const Point& PointFor(Points points, vtkInformation* info)
{
  const double time =
    info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : points.front().time_s;
  const auto after =
    std::upper_bound(points.begin(), points.end(), time, [](double t, const Point& p) { return t < p.time_s; });
  return after == points.begin() ? points.front() : *(after - 1);
}
} // namespace

vtkHapticRecordingReader::vtkHapticRecordingReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

vtkHapticRecordingReader::~vtkHapticRecordingReader()
{
  this->SetFileName(nullptr);
}

std::string vtkHapticRecordingReader::Read()
{
  if (!this->FileName)
  {
    return "a file name is needed";
  }
  const long changed = vtksys::SystemTools::ModifiedTime(this->FileName);
  if (this->ReadFile == this->FileName && this->ReadTime == changed && !this->Points.empty())
  {
    return {};
  }
  this->Points.clear();
  if (const std::string problem = vtkHapticFileGuards::CheckFile(this->FileName); !problem.empty())
  {
    return std::string(this->FileName) + ": " + problem;
  }
  const std::variant<palpate::Recording, std::string> read = palpate::readRecording(this->FileName);
  if (const auto* problem = std::get_if<std::string>(&read))
  {
    return *problem;
  }
  this->Points = palpate::trajectoryOf(std::get<palpate::Recording>(read));
  this->ReadFile = this->FileName;
  this->ReadTime = changed;
  return this->Points.empty() ? std::string(this->FileName) + ": the recording has no hand; record while touching" : "";
}

int vtkHapticRecordingReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (const std::string problem = this->Read(); !problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  const std::vector<double> steps = StepsOf(this->Points, this->StepRate);
  const std::array<double, 2> range = { steps.front(), this->Points.back().time_s };
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkInformation* const info = output->GetInformationObject(port);
    info->Set(Pipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
    info->Set(Pipeline::TIME_RANGE(), range.data(), 2);
  }
  return 1;
}

int vtkHapticRecordingReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  const Point& point = PointFor(this->Points, output->GetInformationObject(0));
  FillMoment(vtkPolyData::GetData(output, 0), point);
  FillPath(vtkPolyData::GetData(output, 1), this->Points);
  vtkPolyData::GetData(output, 0)->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), point.time_s);
  return 1;
}

void vtkHapticRecordingReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "StepRate: " << this->StepRate << " Hz\n";
}
