// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSession.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "devices/FedDevice.h"
#include "devices/io/DBusBroker.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkHapticSessionInternals.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHapticSession);

namespace
{
using palpate::Vec3;

/// Rounding of a quaternion typed by a person or read from a text file.
constexpr double unitTolerance = 1e-6;

palpate::HapticParameters Defaults()
{
  palpate::HapticParameters parameters;
  parameters.stiffness_N_per_m = 500.0;
  parameters.passivity.enabled = true;
  parameters.map.scale_u_per_m = 1000.0;
  return parameters;
}

bool SameMap(const palpate::WorkspaceMap& a, const palpate::WorkspaceMap& b)
{
  return a.scale_u_per_m == b.scale_u_per_m && a.offset_W == b.offset_W && a.q_WD.coeffs() == b.q_WD.coeffs();
}

palpate::DeviceSample SampleAt(const palpate::WorkspaceMap& map, const Vec3& p_W)
{
  palpate::DeviceSample sample;
  sample.pose_D.p = map.toDevice(p_W);
  return sample;
}
} // namespace

palpate::DeviceOptions vtkHapticSession::Internals::Options() const
{
  palpate::DeviceOptions options;
  options.recordingFile = this->ReplayFile;
  options.period_s = PeriodSeconds;
  options.calibrationFolder = this->CalibrationFolder;
  options.hand = this->HeldBy;
  options.delay_ticks = static_cast<int>(this->Parameters.passivity.delay_ticks);
  options.stroke.speed_m_per_s = this->StrokeSpeed;
  for (const Vec3& p_W : this->Stroke_W)
  {
    options.stroke.points_D.push_back(this->Parameters.map.toDevice(p_W));
  }
  return options;
}

void vtkHapticSession::Internals::Feed(bool placed)
{
  if (auto* fed = dynamic_cast<palpate::FedDevice*>(this->Core.device()))
  {
    const palpate::DeviceSample sample = SampleAt(this->Parameters.map, this->Hand_W);
    placed ? fed->place(sample) : fed->feed(sample);
  }
}

void vtkHapticSession::Internals::ShowState()
{
  this->State = this->Core.state();
  this->Report = this->Core.report();
  if (this->Core.running())
  {
    this->Scheduling = this->Core.scheduling().message;
  }
  Eigen::Map<Vec3>(this->Proxy) = this->State.proxy_W.p;
  Eigen::Map<Vec3>(this->Hand) = this->State.device_W.p;
  Eigen::Map<Vec3>(this->Force) = this->State.force_W;
  this->FollowGame();
}

vtkHapticSession::vtkHapticSession() : Impl(std::make_unique<Internals>())
{
  this->Impl->Parameters = Defaults();
  this->Refuse(this->Impl->Core.setParameters(this->Impl->Parameters));
  this->Impl->JudgeStability();
}

vtkHapticSession::~vtkHapticSession()
{
  this->Impl->Core.stop();
}

void vtkHapticSession::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DeviceName: " << this->Impl->DeviceName << "\n";
  os << indent << "Touching: " << this->GetTouching() << "\n";
  os << indent << "VirtualTime: " << this->Impl->VirtualTime << "\n";
  os << indent << "Stiffness: " << this->GetStiffness() << " N/m\n";
  os << indent << "StiffnessUsed: " << this->GetStiffnessUsed() << " N/m\n";
  os << indent << "Stability: " << this->GetStabilitySentence() << "\n";
  os << indent << "Passivity: " << this->GetPassivity() << ", delay " << this->GetDelay() << " ticks\n";
  os << indent << "LimitStiffness: " << this->GetLimitStiffness() << "\n";
  os << indent << "VelocityMethod: " << this->GetVelocityMethod() << "\n";
  os << indent << "Hand: " << this->Impl->HeldBy << "\n";
  os << indent << "Damping: " << this->GetDamping() << " N s/m\n";
  os << indent << "Radius: " << this->GetRadius() << " u, used " << this->GetRadiusUsed() << " u, limit "
     << this->GetRadiusLimit() << " u " << (this->GetLimitRadius() ? "on" : "off") << "\n";
  os << indent << "LineRadius: " << this->GetLineRadius() << " u\n";
  os << indent << "FrictionStatic: " << this->GetFrictionStatic() << "\n";
  os << indent << "FrictionKinetic: " << this->GetFrictionKinetic() << ", used " << this->GetFrictionKineticUsed()
     << "\n";
  os << indent << "StiffnessArray: " << this->GetStiffnessArray() << "\n";
  os << indent << "FrictionArray: " << this->GetFrictionArray() << "\n";
  os << indent << "TextureArray: " << this->GetTextureArray() << "\n";
  os << indent << "ForceShading: " << this->GetForceShading() << "\n";
  os << indent << "Simplify: " << this->GetSimplify() << "\n";
  os << indent << "Plan: " << this->GetPlanSentence() << "\n";
  os << indent << "Scale: " << this->GetScale() << " u/m\n";
  os << indent << "Stroke: " << this->Impl->Stroke_W.size() << " points, " << this->Impl->StrokeSpeed << " m/s\n";
  os << indent << "PressDepth: " << this->Impl->PressDepth_m << " m\n";
  os << indent << "RecordFile: " << this->Impl->RecordFile << "\n";
  os << indent << "ReplayFile: " << this->Impl->ReplayFile << "\n";
  os << indent << "State: " << this->GetStateText() << "\n";
  os << indent << "Problem: " << this->Impl->Problem << "\n";
  os << indent << "Ticks: " << this->GetTicks() << "\n";
  os << indent << "Scene: " << this->Impl->Built.Report << "\n";
}

void vtkHapticSession::Refuse(const std::string& problem)
{
  if (!problem.empty())
  {
    this->Impl->Problem = problem;
    vtkErrorMacro(<< problem);
  }
}

// Device ------------------------------------------------------------------------------------------------------------

void vtkHapticSession::SetDeviceName(const char* name)
{
  const std::string wanted = name ? name : "";
  if (wanted == this->Impl->DeviceName)
  {
    return;
  }
  const palpate::MadeDevice made = palpate::makeDevice(wanted, {});
  if (!made.device)
  {
    this->Refuse(made.problem);
    return;
  }
  this->Impl->DeviceName = wanted;
  this->Impl->LearnDevices();
  this->Impl->JudgeStability();
  this->Impl->FollowWalls();
  this->Impl->FollowPlane();
  this->Modified();
}

const char* vtkHapticSession::GetDeviceName() const
{
  return this->Impl->DeviceName.c_str();
}

int vtkHapticSession::GetNumberOfKnownDevices() const
{
  return static_cast<int>(this->Impl->Known.size());
}

const char* vtkHapticSession::GetKnownDeviceName(int index) const
{
  return index >= 0 && index < this->GetNumberOfKnownDevices() ? this->Impl->Known[index].name.c_str() : nullptr;
}

const char* vtkHapticSession::GetKnownDeviceProblem(int index) const
{
  return index >= 0 && index < this->GetNumberOfKnownDevices() ? this->Impl->Known[index].problem.c_str() : nullptr;
}

// Touching ----------------------------------------------------------------------------------------------------------

void vtkHapticSession::SetTouching(bool touching)
{
  if (touching == this->GetTouching())
  {
    return;
  }
  touching ? this->Start() : this->Stop();
  this->Impl->JudgeStability();
  this->Impl->ShowState();
  this->Modified();
}

bool vtkHapticSession::GetTouching() const
{
  return this->Impl->Core.running();
}

void vtkHapticSession::Start()
{
  this->InvokeEvent(vtkCommand::StartEvent);
  Internals& impl = *this->Impl;
  if (impl.Check.running())
  {
    this->Refuse("the device is being checked; stop that first");
    return;
  }
  palpate::MadeDevice made = palpate::makeDevice(impl.DeviceName, impl.Options());
  if (!made.device)
  {
    this->Refuse(made.problem);
    return;
  }
  if (auto* fed = dynamic_cast<palpate::FedDevice*>(made.device.get()))
  {
    fed->feed(SampleAt(impl.Parameters.map, impl.Hand_W)); // before the first tick reads it
  }
  const palpate::DeadMan deadMan = impl.Parameters.safety.deadMan;
  impl.Parameters.safety = palpate::SafetyLimits::forDevice(made.device->info());
  impl.Parameters.safety.deadMan = deadMan;
  impl.Problem.clear();
  this->Refuse(made.warning);
  this->Refuse(impl.Core.setParameters(impl.Allowed(impl.Parameters)));
  palpate::SessionOptions options;
  options.period_s = Internals::PeriodSeconds;
  options.virtualTime = impl.VirtualTime;
  options.recordFile = impl.RecordFile;
  options.brokers = palpate::systemBrokers();
  this->Refuse(impl.Core.start(std::move(made.device), options));
}

void vtkHapticSession::Stop()
{
  this->Impl->ShowState(); // the scheduling report ends with the servo
  this->Refuse(this->Impl->Core.stop());
}

void vtkHapticSession::Engage()
{
  this->Impl->Core.engage();
}

void vtkHapticSession::Release()
{
  this->Impl->Core.release();
}

void vtkHapticSession::Mark()
{
  this->Impl->Core.mark();
}

void vtkHapticSession::SetVirtualTime(bool on)
{
  if (on != this->Impl->VirtualTime)
  {
    this->Impl->VirtualTime = on;
    this->Modified();
  }
}

bool vtkHapticSession::GetVirtualTime() const
{
  return this->Impl->VirtualTime;
}

void vtkHapticSession::Step(int ticks)
{
  this->Impl->Core.step(ticks);
  this->Impl->Check.step(ticks);
  this->Update();
}

void vtkHapticSession::Update()
{
  this->Impl->TakeScene(this->Impl->Worker.Poll());
  this->Impl->FollowRules();
  this->Impl->TakeSimpler(this->Impl->VirtualTime ? std::nullopt : this->Impl->Simpler.Poll());
  this->Impl->ShowState();
  this->Impl->FollowRadius();
  this->Impl->SettleScene();
  this->Impl->FollowCheck();
}

// Parameters --------------------------------------------------------------------------------------------------------

void vtkHapticSession::Change(const std::function<void(palpate::HapticParameters&)>& change)
{
  palpate::HapticParameters parameters = this->Impl->Parameters;
  change(parameters);
  const palpate::HapticParameters allowed = this->Impl->Allowed(parameters);
  const std::string problem = this->Impl->Core.setParameters(allowed);
  if (!problem.empty())
  {
    this->Refuse(problem);
    return;
  }
  const palpate::HapticParameters before = std::exchange(this->Impl->Parameters, parameters);
  const bool otherMap = !SameMap(before.map, parameters.map);
  if (otherMap && this->GetTouching())
  {
    this->InvokeEvent(vtkCommand::StartEvent); // the hand begins anew
    this->Impl->Feed(true);
  }
  this->Impl->RadiusUsed_u = allowed.contact.radius_u;
  if (before.passivity != parameters.passivity || before.damping_Ns_per_m != parameters.damping_Ns_per_m)
  {
    this->Impl->JudgeStability();
  }
  this->Impl->FollowPlane();
  this->Impl->Feed(); // the hand stays where it is in the scene when the map changes
  this->Modified();
}

void vtkHapticSession::SetStiffness(double stiffness_N_per_m)
{
  this->Change([=](palpate::HapticParameters& p) { p.stiffness_N_per_m = stiffness_N_per_m; });
}

double vtkHapticSession::GetStiffness() const
{
  return this->Impl->Parameters.stiffness_N_per_m;
}

void vtkHapticSession::SetDamping(double damping_Ns_per_m)
{
  this->Change([=](palpate::HapticParameters& p) { p.damping_Ns_per_m = damping_Ns_per_m; });
}

double vtkHapticSession::GetDamping() const
{
  return this->Impl->Parameters.damping_Ns_per_m;
}

void vtkHapticSession::SetRadius(double radius_u)
{
  this->Change([=](palpate::HapticParameters& p) { p.contact.radius_u = radius_u; });
  this->Impl->FollowWalls();
}

double vtkHapticSession::GetRadius() const
{
  return this->Impl->Parameters.contact.radius_u;
}

void vtkHapticSession::SetScale(double scale_u_per_m)
{
  this->Change([=](palpate::HapticParameters& p) { p.map.scale_u_per_m = scale_u_per_m; });
}

double vtkHapticSession::GetScale() const
{
  return this->Impl->Parameters.map.scale_u_per_m;
}

void vtkHapticSession::SetRotation(double w, double x, double y, double z)
{
  const palpate::Quat q(w, x, y, z);
  if (!(std::abs(q.norm() - 1.0) <= unitTolerance))
  {
    this->Refuse("the rotation must be a unit quaternion (w, x, y, z)");
    return;
  }
  this->Change([&q](palpate::HapticParameters& p) { p.map.q_WD = q.normalized(); });
}

void vtkHapticSession::SetRotation(const double wxyz[4])
{
  this->SetRotation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

double* vtkHapticSession::GetRotation()
{
  const palpate::Quat& q = this->Impl->Parameters.map.q_WD;
  const double wxyz[4] = { q.w(), q.x(), q.y(), q.z() };
  std::copy(wxyz, wxyz + 4, this->Impl->Rotation);
  return this->Impl->Rotation;
}

void vtkHapticSession::SetOffset(double x, double y, double z)
{
  this->Change([=](palpate::HapticParameters& p) { p.map.offset_W = Vec3(x, y, z); });
}

void vtkHapticSession::SetOffset(const double offset_W[3])
{
  this->SetOffset(offset_W[0], offset_W[1], offset_W[2]);
}

double* vtkHapticSession::GetOffset()
{
  Eigen::Map<Vec3>(this->Impl->Offset) = this->Impl->Parameters.map.offset_W;
  return this->Impl->Offset;
}

void vtkHapticSession::FitWorkspace()
{
  double bounds[6];
  if (!this->GetSceneBounds(bounds))
  {
    this->Refuse("there is no scene to fit the workspace to; add a surface and commit it");
    return;
  }
  const Vec3 low_W(bounds[0], bounds[2], bounds[4]);
  const Vec3 high_W(bounds[1], bounds[3], bounds[5]);
  const double radius_m = this->Impl->ChosenInfo().workspaceRadius_m.value;
  const double half = 0.5 * (high_W - low_W).norm();
  this->Change(
    [&](palpate::HapticParameters& p)
    {
      p.map.scale_u_per_m = half / radius_m;
      p.map.offset_W = 0.5 * (low_W + high_W);
      if (this->Impl->Built.Plane_WP && this->Impl->ChosenInfo().abilities.sensedAxes == 2)
      {
        p.map.q_WD = this->Impl->Built.Plane_WP->q; // a device that moves in a plane moves in this one
      }
    });
}

// Hand --------------------------------------------------------------------------------------------------------------

void vtkHapticSession::SetHandPosition(double x, double y, double z)
{
  this->Impl->Hand_W = Vec3(x, y, z);
  this->Impl->Feed();
}

void vtkHapticSession::SetHandPosition(const double p_W[3])
{
  this->SetHandPosition(p_W[0], p_W[1], p_W[2]);
}

void vtkHapticSession::SetStrokePath(vtkPolyData* path)
{
  if (!path || path->GetNumberOfLines() != 1)
  {
    this->Refuse("a stroke is poly data with one polyline");
    return;
  }
  vtkNew<vtkIdList> ids;
  path->GetLines()->GetCellAtId(0, ids);
  this->Impl->Stroke_W.clear();
  for (vtkIdType id : *ids)
  {
    this->AddStrokePoint(path->GetPoint(id)[0], path->GetPoint(id)[1], path->GetPoint(id)[2]);
  }
}

void vtkHapticSession::ClearStrokePoints()
{
  this->Impl->Stroke_W.clear();
  this->Modified();
}

void vtkHapticSession::AddStrokePoint(double x, double y, double z)
{
  this->Impl->Stroke_W.emplace_back(x, y, z);
  this->Modified();
}

int vtkHapticSession::GetNumberOfStrokePoints() const
{
  return static_cast<int>(this->Impl->Stroke_W.size());
}

void vtkHapticSession::SetStrokeSpeed(double speed_m_per_s)
{
  if (!(speed_m_per_s > 0.0 && std::isfinite(speed_m_per_s)))
  {
    this->Refuse("the speed of the stroke must be more than 0 m/s");
    return;
  }
  this->Impl->StrokeSpeed = speed_m_per_s;
  this->Modified();
}

double vtkHapticSession::GetStrokeSpeed() const
{
  return this->Impl->StrokeSpeed;
}

// Files -------------------------------------------------------------------------------------------------------------

void vtkHapticSession::SetRecordFile(const char* file)
{
  this->Impl->RecordFile = file ? file : "";
  this->Modified();
}

const char* vtkHapticSession::GetRecordFile() const
{
  return this->Impl->RecordFile.c_str();
}

void vtkHapticSession::SetReplayFile(const char* file)
{
  this->Impl->ReplayFile = file ? file : "";
  this->Modified();
}

const char* vtkHapticSession::GetReplayFile() const
{
  return this->Impl->ReplayFile.c_str();
}

// Scene -------------------------------------------------------------------------------------------------------------

void vtkHapticSession::ClearSurfaces()
{
  this->Impl->Worker.Clear();
}

bool vtkHapticSession::AddSurface(const char* name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  const std::string problem = this->Impl->Worker.Add(name ? name : "surface", data, matrix);
  this->Refuse(problem);
  return problem.empty();
}

void vtkHapticSession::CommitScene()
{
  this->Impl->Simpler.Cancel();
  this->Impl->Worker.Follow(this->Impl->Core.running() ? this->Impl->Full.Scene : nullptr);
  this->Impl->Worker.Commit(this->Impl->Now());
}

bool vtkHapticSession::FinishScene()
{
  this->Impl->TakeScene(this->Impl->Worker.Wait());
  this->Impl->FollowRadius();
  return this->Impl->Built.Scene != nullptr;
}

bool vtkHapticSession::GetSceneBounds(double bounds[6]) const
{
  std::copy(this->Impl->Built.Bounds.begin(), this->Impl->Built.Bounds.end(), bounds);
  return this->Impl->Built.Scene != nullptr;
}

const char* vtkHapticSession::GetSceneReport() const
{
  return this->Impl->Built.Report.c_str();
}
