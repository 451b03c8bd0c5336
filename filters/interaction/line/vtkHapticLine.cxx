// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticLine.h"

#include "devices/DeviceFactory.h"
#include "devices/io/broker/DBusBroker.h"
#include "devices/line/LineRun.h"
#include "haptics/line/LineFile.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <limits>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHapticLine);

class vtkHapticLine::Internals
{
public:
  std::vector<palpate::LinePlace> Places; ///< potentials are values
  std::string DeviceName = "simulated-joystick";
  std::string Problem;
  palpate::LineRun Run;

  palpate::LineWorld World(const vtkHapticLine& line) const
  {
    palpate::LineWorld world;
    world.places = this->Places;
    if (world.places.size() > 1)
    {
      palpate::scaleToHardest(world.places, line.HardestForce);
    }
    world.detentEvery_m = line.DetentEvery;
    world.detent_N = line.DetentForce;
    world.stop_N_per_m = line.StopStiffness;
    return world;
  }
};

vtkHapticLine::vtkHapticLine() : Impl(std::make_unique<Internals>()) {}

vtkHapticLine::~vtkHapticLine() = default;

void vtkHapticLine::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DeviceName: " << this->Impl->DeviceName << "\n";
  os << indent << "Places: " << this->Impl->Places.size() << "\n";
  os << indent << "HardestForce: " << this->HardestForce << " N\n";
  os << indent << "Detents: every " << this->DetentEvery << " m, " << this->DetentForce << " N\n";
  os << indent << "StopStiffness: " << this->StopStiffness << " N/m\n";
}

bool vtkHapticLine::Refuse(const std::string& problem)
{
  this->Impl->Problem = problem;
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
  }
  return problem.empty();
}

void vtkHapticLine::AddPlace(double s, double value, double friction)
{
  this->Impl->Places.push_back({ s, value, friction });
  this->Modified();
}

void vtkHapticLine::ClearPlaces()
{
  this->Impl->Places.clear();
  this->Modified();
}

int vtkHapticLine::GetNumberOfPlaces() const
{
  return static_cast<int>(this->Impl->Places.size());
}

bool vtkHapticLine::SetPath(vtkPolyData* path, const char* array, double scale)
{
  vtkDataArray* values = path && array ? path->GetPointData()->GetArray(array) : nullptr;
  if (!values || !path->GetLines() || path->GetNumberOfLines() < 1 || !(scale > 0.0))
  {
    return this->Refuse("a path needs a line, a point array of that name, and a scale above 0");
  }
  vtkNew<vtkIdList> points;
  path->GetLines()->GetCellAtId(0, points);
  std::vector<palpate::LinePlace> places;
  palpate::Vec3 last_W = palpate::Vec3::Zero();
  double way_u = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    const palpate::Vec3 p_W(path->GetPoint(points->GetId(i)));
    const double step_u = i > 0 ? (p_W - last_W).norm() : 0.0;
    last_W = p_W;
    way_u += step_u;
    if (i == 0 || step_u > 0.0) // a point twice says nothing new
    {
      places.push_back({ way_u / scale, values->GetComponent(points->GetId(i), 0), 0.0 });
    }
  }
  for (palpate::LinePlace& place : places)
  {
    place.s_m -= 0.5 * way_u / scale;
  }
  this->Impl->Places = std::move(places);
  this->Modified();
  return this->Refuse("");
}

void vtkHapticLine::SetDeviceName(const char* name)
{
  this->Impl->DeviceName = name ? name : "";
  this->Modified();
}

const char* vtkHapticLine::GetDeviceName() const
{
  return this->Impl->DeviceName.c_str();
}

double vtkHapticLine::GetForceAt(double s)
{
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  const palpate::LineWorld world = this->Impl->World(*this);
  return this->Refuse(world.refusal(unlimited)) ? palpate::lineForce(world, s)
                                                : std::numeric_limits<double>::quiet_NaN();
}

bool vtkHapticLine::Start()
{
  palpate::DeviceOptions options;
  options.hand = "light";
  options.wheel = true;
  options.stroke.points_D = { palpate::Vec3(this->HandPosition, 0.0, 0.0) };
  palpate::MadeDevice made = palpate::makeDevice(this->Impl->DeviceName, options);
  if (!made.device)
  {
    return this->Refuse(made.problem);
  }
  constexpr double period_s = 1e-3;
  return this->Refuse(this->Impl->Run.start(
    std::move(made.device), this->Impl->World(*this), {}, { period_s, this->VirtualTime, palpate::systemBrokers() }));
}

void vtkHapticLine::Engage()
{
  this->Impl->Run.engage();
}

void vtkHapticLine::Step(int ticks)
{
  this->Impl->Run.step(ticks);
}

void vtkHapticLine::Stop()
{
  this->Impl->Run.stop();
}

bool vtkHapticLine::GetRunning() const
{
  return this->Impl->Run.running();
}

double vtkHapticLine::GetPosition()
{
  return this->Impl->Run.state().s_m;
}

double vtkHapticLine::GetForce()
{
  return this->Impl->Run.state().force_N;
}

const char* vtkHapticLine::GetProblem() const
{
  return this->Impl->Problem.c_str();
}
