// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSession.h"

#include <utility>

#include "devices/io/broker/DBusBroker.h"
#include "haptics/session/Warning.h"
#include "haptics/session/settings/SessionSettings.h"
#include "haptics/session/settings/TickFields.h"
#include "vtkCommand.h"
#include "vtkHapticSessionInternals.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHapticSession);

namespace
{
using palpate::Vec3;
} // namespace

palpate::DeviceOptions vtkHapticSession::Internals::Options() const
{
  palpate::DeviceOptions options;
  options.recordingFile = this->ReplayFile;
  options.period_s = PeriodSeconds;
  options.hid = this->Bus;
  options.calibrationFolder = this->CalibrationFolder;
  options.felt = this->Felt;
  options.wheel = this->Wheel;
  options.hand = this->HeldBy;
  options.delay_ticks = static_cast<int>(this->Asked.asked().passivity.delay_ticks);
  options.stroke.speed_m_per_s = this->StrokeSpeed;
  for (const Vec3& p_W : this->Stroke_W)
  {
    options.stroke.points_D.push_back(this->Asked.asked().map.toDevice(p_W));
  }
  return options;
}

void vtkHapticSession::Internals::ShowState()
{
  this->State = this->Core.state();
  this->Report = this->Core.report();
  this->Warning = this->Core.running() ? palpate::warning(this->State, this->Report) : std::string();
  if (this->Core.running() && this->Warning.empty())
  {
    this->Warning = palpate::otherDeviceSentence(this->DeviceNameNow(), this->Chosen.name);
    this->Warning = this->Warning.empty() ? this->Cancelled : this->Warning;
    this->Warning = this->Warning.empty() ? this->Around : this->Warning;
    this->Warning =
      this->Warning.empty() ? this->MissingArrays.substr(0, this->MissingArrays.find('\n')) : this->Warning;
    this->Warning = this->Warning.empty() ? this->FieldGone : this->Warning;
    this->Warning = this->Warning.empty() && this->Played ? this->PlayedSentence : this->Warning;
  }
  if (this->Core.running())
  {
    this->Scheduling = this->Core.scheduling().message;
  }
  this->State = !this->Scene.built().scene && this->Core.brick() ? palpate::ofFieldAlone(this->State) : this->State;
  this->Tool.Follow(this->Core, this->State);
  this->Soft.Follow(this->Core, this->State, this->Now());
  this->Mechanism.Follow(this->Core, this->State);
  const Vec3* const ofMechanism = this->Mechanism.SoftHand_W();
  this->Soft.Hand_W = ofMechanism ? *ofMechanism : this->Soft.Hand_W;
  Eigen::Map<Vec3>(this->Proxy) = this->State.proxy_W.p;
  Eigen::Map<Vec3>(this->Hand) = this->State.device_W.p;
  Eigen::Map<Vec3>(this->Force) = this->State.force_W;
  this->FollowGame();
}

vtkHapticSession::vtkHapticSession() : Impl(std::make_unique<Internals>())
{
  this->Refuse(this->Impl->Core.setParameters(this->Impl->Asked.asked()));
  this->Impl->Chosen.name = "fed";
  this->Impl->LookForDevices();
  this->Impl->JudgeStability();
}

vtkHapticSession::~vtkHapticSession()
{
  this->Impl->Core.stop();
}

void vtkHapticSession::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DeviceName: " << this->Impl->Chosen.name << "\n";
  os << indent << "Touching: " << this->GetTouching() << "\n";
  os << indent << "VirtualTime: " << this->Impl->VirtualTime << "\n";
  os << indent << "Stiffness: " << this->GetStiffness() << " N/m\n";
  os << indent << "StiffnessUsed: " << this->GetStiffnessUsed() << " N/m\n";
  os << indent << "Stability: " << this->GetStabilitySentence() << "\n";
  os << indent << "Passivity: " << this->GetPassivity() << ", delay " << this->GetDelay() << " ticks\n";
  os << indent << "LimitStiffness: " << this->GetLimitStiffness() << "\n";
  os << indent << "VelocityMethod: " << this->GetVelocityMethod() << "\n";
  os << indent << "Hand: " << this->Impl->HeldBy << "\n";
  os << indent << "Tool: " << this->GetToolSource() << "\n";
  os << indent << "Soft body: " << this->GetSoftSource() << "\n";
  os << indent << "Mechanism: " << this->GetMechanismSource() << "\n";
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
  os << indent << "Scene: " << this->Impl->Scene.built().report << "\n";
}

void vtkHapticSession::Refuse(const std::string& problem)
{
  if (!problem.empty())
  {
    this->Impl->Problem = problem;
    this->Impl->ProblemOf.clear();
    vtkErrorMacro(<< problem);
  }
}

void vtkHapticSession::Internals::Follow(const std::string& what, const std::string& problem)
{
  if (!problem.empty())
  {
    this->ProblemOf = what;
  }
  else if (this->ProblemOf == what)
  {
    this->Problem.clear();
    this->ProblemOf.clear();
  }
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
  Internals& impl = *this->Impl;
  if (impl.FitsNow() && impl.IsFittable())
  {
    this->Fit();
  }
  this->InvokeEvent(vtkCommand::StartEvent);
  if (impl.Check.running())
  {
    this->Refuse("the device is being checked; stop that first");
    return;
  }
  palpate::MadeDevice made = palpate::makeDevice(impl.Chosen.name, impl.Options());
  if (!made.device)
  {
    this->Refuse(made.problem);
    return;
  }
  if (auto* fed = dynamic_cast<palpate::FedDevice*>(made.device.get()))
  {
    impl.FeedTo(*fed, false); // before the first tick reads it
  }
  this->AlignOnTouch(*made.device);
  this->Play(*made.device);
  palpate::SafetyLimits safety = palpate::SafetyLimits::forDevice(made.device->info());
  safety.deadMan = impl.Asked.asked().safety.deadMan;
  impl.Asked.protect(safety);
  impl.Running = Internals::RunningChoice{ impl.Chosen.name, made.device->info(), impl.VirtualTime };
  impl.FollowDevice();
  impl.Problem.clear();
  this->Refuse(made.warning);
  this->Refuse(impl.Core.setParameters(impl.Asked.told(impl.Asked.asked(), impl.Scene.built())));
  palpate::SessionOptions options;
  options.period_s = Internals::PeriodSeconds;
  options.virtualTime = impl.VirtualTime;
  options.recordFile = impl.Recording || !impl.RecordFile.empty() ? impl.NextRecording() : "";
  options.brokers = palpate::systemBrokers();
  this->Refuse(impl.Core.start(std::move(made.device), options));
  if (impl.Played && impl.Played->ball_W) // a recording may begin in the middle of a press
  {
    this->Refuse(impl.Core.setParameters(impl.Core.parameters(), impl.Played->ball_W));
  }
  impl.Around.clear();
  impl.Cancelled.clear();
  impl.Begun_s = impl.Now();
  impl.RecordingBegun_s = impl.RecordedSeconds = 0.0;
  if (impl.Recording != impl.Core.recording())
  {
    impl.Recording = impl.Core.recording();
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
  if (!impl.Core.running())
  {
    impl.Played.reset();
    impl.Running.reset();
    impl.FollowDevice();
  }
}

void vtkHapticSession::Stop()
{
  this->Impl->ShowState(); // the scheduling report ends with the servo
  this->Impl->Core.stop();
  this->FollowRecording();
  this->Impl->Played.reset();
  this->LetHandGo();
  this->Impl->Running.reset();
  this->Impl->FollowDevice();
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
  this->TakeScene();
  this->TakeOutSqueezed();
  this->Impl->FollowCommit();
  this->Impl->Scene.follow(this->Impl->PlanNow());
  if (!this->Impl->VirtualTimeNow())
  {
    this->Impl->Scene.takeSimpler();
  }
  this->Impl->FollowReplay();
  this->Impl->ShowState();
  this->TakeField(false);
  this->FollowRecording();
  this->Impl->FollowRadius();
  if (this->Impl->Scene.rests())
  {
    this->Impl->Surfaces.Settle(this->Impl->Scene.worker());
  }
  this->Impl->FollowCheck();
  this->FollowContact();
  this->FollowHand();
}

// Parameters --------------------------------------------------------------------------------------------------------

bool vtkHapticSession::Allows(const char* setting, std::initializer_list<double> values)
{
  const palpate::Setting& described = palpate::sessionSetting(setting);
  const std::string problem = palpate::refuse(described, values, palpate::spoken(described));
  this->Refuse(problem);
  this->Impl->Follow(setting, problem);
  return problem.empty();
}

void vtkHapticSession::Change(const char* setting, std::initializer_list<double> values,
  const std::function<void(palpate::HapticParameters&)>& change)
{
  if (this->Allows(setting, values))
  {
    this->Change(change);
  }
}

void vtkHapticSession::SetField(const char* setting, std::initializer_list<double> values)
{
  const std::vector<double> numbers(values);
  this->Change(setting, values,
    [&](palpate::HapticParameters& p) { palpate::setField(p, palpate::sessionSetting(setting), numbers); });
}

double* vtkHapticSession::GetField(const char* setting) const
{
  const std::vector<double> now = palpate::fieldOf(this->Impl->Asked.asked(), palpate::sessionSetting(setting));
  std::vector<double>& numbers = this->Impl->Fields[setting];
  numbers.assign(now.begin(), now.end()); // in place: the caller may still have the address of before
  return numbers.data();
}

const char* vtkHapticSession::GetDescribed()
{
  static const std::string json = palpate::describedAsJson();
  return json.c_str();
}

void vtkHapticSession::Change(const std::function<void(palpate::HapticParameters&)>& change)
{
  const palpate::HapticParameters before = this->Impl->Asked.asked();
  palpate::HapticParameters parameters = before;
  change(parameters);
  const palpate::HapticParameters told = this->Impl->Asked.told(parameters, this->Impl->Scene.built());
  const bool otherMap = this->GetTouching() && !palpate::isSame(before.map, parameters.map);
  if (otherMap)
  {
    this->Impl->Withdraw(); // the old pose would be somewhere else in the new map, maybe inside a surface
  }
  const std::optional<palpate::CameAround> into = otherMap ? this->Impl->PutInto(parameters.map) : std::nullopt;
  const std::string problem = this->Impl->Core.setParameters(told, into ? std::optional(into->from_W) : std::nullopt);
  this->Refuse(problem);
  this->Impl->Follow("parameters", problem);
  if (!problem.empty())
  {
    this->Impl->Feed();
    return;
  }
  this->Impl->Asked.taken(parameters, told);
  if (otherMap)
  {
    this->Impl->StayOutside(into);
    this->InvokeEvent(vtkCommand::StartEvent); // the hand begins anew
    this->Impl->Feed(true);
  }
  if (before.passivity != parameters.passivity || before.damping_Ns_per_m != parameters.damping_Ns_per_m)
  {
    this->Impl->JudgeStability();
  }
  if (before.contact.radius_u != parameters.contact.radius_u)
  {
    this->Impl->FollowWalls();
  }
  this->Impl->FollowPlane();
  this->Impl->Feed(); // the hand stays where it is in the scene when the map changes
  this->Modified();
}
