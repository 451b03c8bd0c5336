// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSession.h"

#include <utility>

#include "devices/io/broker/DBusBroker.h"
#include "haptics/session/Warning.h"
#include "haptics/session/settings/SessionSettings.h"
#include "vtkCommand.h"
#include "vtkHapticCheckState.h"
#include "vtkHapticDeviceCheck.h"
#include "vtkHapticInspection.h"
#include "vtkHapticKnownDevices.h"
#include "vtkHapticLabyrinthGame.h"
#include "vtkHapticRecordings.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"
#include "vtkHapticSight.h"
#include "vtkHapticTouchedMechanism.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHapticSession);

namespace
{
using palpate::Vec3;
} // namespace

palpate::DeviceOptions vtkHapticSession::Internals::Options() const
{
  palpate::DeviceOptions options;
  options.recordingFile = this->Settings.text("ReplayFile");
  options.period_s = PeriodSeconds;
  options.hid = this->Bus;
  options.calibrationFolder = this->CalibrationFolder;
  options.felt = this->Felt;
  options.wheel = this->Settings.isOn("Wheel");
  options.hand = this->Settings.text("Hand");
  options.delay_ticks = static_cast<int>(this->Asked.asked().passivity.delay_ticks);
  options.stroke.speed_m_per_s = this->Settings.number("StrokeSpeed");
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
  this->ForgetAround();
  this->Warning = this->Core.running() ? palpate::warning(this->State, this->Report) : std::string();
  if (this->Core.running() && this->Warning.empty())
  {
    this->Warning = palpate::otherDeviceText(this->DeviceNameNow(), this->Chosen.name);
    this->Warning = this->Warning.empty() ? this->Cancelled : this->Warning;
    this->Warning = this->Warning.empty() ? this->Around : this->Warning;
    this->Warning =
      this->Warning.empty() ? this->MissingArrays.substr(0, this->MissingArrays.find('\n')) : this->Warning;
    this->Warning = this->Warning.empty() ? this->FieldGone : this->Warning;
    this->Warning = this->Warning.empty() ? this->LooseTrouble() : this->Warning;
    this->Warning = this->Warning.empty() && this->Recorded.Played ? this->Recorded.PlayedText : this->Warning;
  }
  if (this->Core.running())
  {
    this->Scheduling = this->Core.scheduling().message;
  }
  this->State = !this->Scene.built().scene && this->Core.brick() ? palpate::ofFieldAlone(this->State) : this->State;
  this->FollowFelt();
  Eigen::Map<Vec3>(this->Proxy) = this->State.proxy_W.p;
  Eigen::Map<Vec3>(this->Hand) = this->State.device_W.p;
  Eigen::Map<Vec3>(this->Force) = this->State.force_W;
  this->FollowGame();
}

vtkHapticSession::vtkHapticSession() : Impl(std::make_unique<Internals>(*this))
{
  this->Impl->Refuse(this->Impl->Core.setParameters(this->Impl->Asked.asked()));
  this->Impl->Chosen.name = "fed";
  this->Impl->LookForDevices();
  this->Impl->JudgeStability();
}

vtkHapticSession::~vtkHapticSession()
{
  this->Impl->Core.stop();
}

vtkHapticSession::Internals& vtkHapticSession::Behind()
{
  return *this->Impl;
}

void vtkHapticSession::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const palpate::Setting& setting : palpate::sessionSettings())
  {
    const palpate::SettingValue& value = this->Impl->ValueOf(setting);
    os << indent << setting.name << ":" << (value.text.empty() ? "" : " ") << value.text;
    for (const double number : value.numbers)
    {
      os << " " << number;
    }
    os << " " << setting.unit << "\n";
  }
  os << indent << "StiffnessUsed: " << this->GetStiffnessUsed() << " N/m\n";
  os << indent << "Stability: " << this->GetStabilityText() << "\n";
  os << indent << "RadiusUsed: " << this->GetRadiusUsed() << " u, limit " << this->GetRadiusLimit() << " u\n";
  os << indent << "FrictionKineticUsed: " << this->GetFrictionKineticUsed() << "\n";
  os << indent << "Plan: " << this->GetPlanText() << "\n";
  os << indent << "Stroke: " << this->Impl->Stroke_W.size() << " points\n";
  os << indent << "State: " << this->GetStateText() << "\n";
  os << indent << "Problem: " << this->Impl->Problem << "\n";
  os << indent << "Ticks: " << this->GetTicks() << "\n";
  os << indent << "Scene: " << this->Impl->Scene.built().report << "\n";
}

void vtkHapticSession::Internals::Refuse(const std::string& problem)
{
  if (!problem.empty())
  {
    this->Problem = problem;
    this->ProblemOf.clear();
    vtkErrorWithObjectMacro(&this->Session, << problem);
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
  touching ? this->Impl->Start() : this->Impl->Stop();
  this->Impl->JudgeStability();
  this->Impl->ShowState();
  this->Modified();
}

bool vtkHapticSession::GetTouching() const
{
  return this->Impl->Core.running();
}

std::string vtkHapticSession::Internals::FollowTouching()
{
  this->Session.SetTouching(this->Settings.isOn("Touching"));
  return {};
}

void vtkHapticSession::Internals::Start()
{
  if (this->FitsNow() && this->IsFittable())
  {
    this->Fit();
  }
  this->Session.InvokeEvent(vtkCommand::StartEvent);
  if (this->Check.Run.running())
  {
    this->Refuse("a device check is running; stop the check first");
    return;
  }
  palpate::MadeDevice made = palpate::makeDevice(this->Chosen.name, this->Options());
  if (!made.device)
  {
    this->Refuse(made.problem);
    return;
  }
  if (auto* fed = dynamic_cast<palpate::FedDevice*>(made.device.get()))
  {
    this->FeedTo(*fed, false); // before the first tick reads it
  }
  this->AlignOnTouch(*made.device);
  this->Recorded.Play(*made.device);
  palpate::SafetyLimits safety = palpate::SafetyLimits::forDevice(made.device->info());
  safety.deadMan = this->Asked.asked().safety.deadMan;
  this->Asked.protect(safety);
  this->Running =
    Internals::RunningChoice{ this->Chosen.name, made.device->info(), this->Settings.isOn("VirtualTime") };
  this->FollowDevice();
  this->Problem.clear();
  this->Refuse(made.warning);
  this->Refuse(this->Core.setParameters(this->Asked.told(this->Asked.asked(), this->Scene.built())));
  palpate::SessionOptions options;
  options.period_s = Internals::PeriodSeconds;
  options.virtualTime = this->Settings.isOn("VirtualTime");
  options.recordFile = this->Recorded.FileOfTouch();
  options.brokers = palpate::systemBrokers();
  this->Refuse(this->Core.start(std::move(made.device), options));
  if (this->Recorded.Played && this->Recorded.Played->ball_W) // a recording may begin in the middle of a press
  {
    this->Refuse(this->Core.setParameters(this->Core.parameters(), this->Recorded.Played->ball_W));
  }
  this->Around.clear();
  this->Cancelled.clear();
  this->Begun_s = this->Now();
  this->Recorded.FollowTouch();
  if (!this->Core.running())
  {
    this->Recorded.Played.reset();
    this->Running.reset();
    this->FollowDevice();
  }
}

void vtkHapticSession::Internals::Stop()
{
  this->ShowState(); // the scheduling report ends with the servo
  this->Core.stop();
  this->Recorded.Follow();
  this->Recorded.Played.reset();
  this->LetHandGo();
  this->Running.reset();
  this->FollowDevice();
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

void vtkHapticSession::Step(int ticks)
{
  this->Impl->Core.step(ticks);
  this->Impl->Check.Run.step(ticks);
  this->Update();
}

void vtkHapticSession::Update()
{
  this->Impl->TakeScene();
  this->Impl->TakeOutSqueezed();
  this->Impl->FollowCommit();
  this->Impl->Scene.follow(this->Impl->PlanNow());
  if (!this->Impl->VirtualTimeNow())
  {
    this->Impl->Scene.takeSimpler();
  }
  this->Impl->Recorded.FollowPlayed();
  this->Impl->ShowState();
  this->Impl->TakeField(false);
  this->Impl->Recorded.Follow();
  this->Impl->FollowRadius();
  if (this->Impl->Scene.rests())
  {
    this->Impl->Surfaces.Settle(this->Impl->Scene.worker());
  }
  this->Impl->FollowCheck();
  this->Impl->FollowContact();
  this->Impl->FollowHand();
  this->Impl->ForgetSettled();
}

/// A refusal is gone with its reason.
void vtkHapticSession::Internals::ForgetSettled()
{
  const bool settled = (this->ProblemOf == "mark" && this->State.contacts > 0) ||
                       (this->ProblemOf == "FitWorkspace" && this->IsFittable());
  if (settled)
  {
    this->Follow(std::string(this->ProblemOf), "");
  }
}

// Parts -------------------------------------------------------------------------------------------------------------

vtkSmartPointer<vtkHapticKnownDevices> vtkHapticSession::GetDevices()
{
  return vtkHapticKnownDevices::Of(*this);
}

vtkSmartPointer<vtkHapticDeviceCheck> vtkHapticSession::GetDeviceCheck()
{
  return vtkHapticDeviceCheck::Of(*this);
}

vtkSmartPointer<vtkHapticInspection> vtkHapticSession::GetInspection()
{
  return vtkHapticInspection::Of(*this);
}

vtkSmartPointer<vtkHapticLabyrinthGame> vtkHapticSession::GetLabyrinth()
{
  return vtkHapticLabyrinthGame::Of(*this);
}

vtkSmartPointer<vtkHapticTouchedMechanism> vtkHapticSession::GetMechanism()
{
  return vtkHapticTouchedMechanism::Of(*this);
}

vtkSmartPointer<vtkHapticSight> vtkHapticSession::GetSight()
{
  return vtkHapticSight::Of(*this);
}

const char* vtkHapticSession::GetDescribed()
{
  static const std::string json = palpate::describedAsJson();
  return json.c_str();
}

void vtkHapticSession::Internals::Change(const std::function<void(palpate::HapticParameters&)>& change)
{
  const palpate::HapticParameters before = this->Asked.asked();
  palpate::HapticParameters parameters = before;
  change(parameters);
  const palpate::HapticParameters told = this->Asked.told(parameters, this->Scene.built());
  const bool otherMap = this->Core.running() && !palpate::isSame(before.map, parameters.map);
  if (otherMap)
  {
    this->Withdraw(); // the old pose would be somewhere else in the new map, maybe inside a surface
  }
  const std::optional<palpate::CameAround> into = otherMap ? this->PutInto(parameters.map) : std::nullopt;
  const std::string problem = this->Core.setParameters(told, into ? std::optional(into->from_W) : std::nullopt);
  this->Refuse(problem);
  this->Follow("parameters", problem);
  if (!problem.empty())
  {
    this->Feed();
    return;
  }
  this->Asked.taken(parameters, told);
  if (otherMap)
  {
    this->StayOutside(into);
    this->Session.InvokeEvent(vtkCommand::StartEvent); // the hand begins anew
    this->Feed(true);
  }
  if (before.passivity != parameters.passivity || before.damping_Ns_per_m != parameters.damping_Ns_per_m)
  {
    this->JudgeStability();
  }
  if (before.contact.radius_u != parameters.contact.radius_u)
  {
    this->FollowWalls();
  }
  this->FollowPlane();
  this->Feed(); // the hand stays where it is in the scene when the map changes
  this->Session.Modified();
}
