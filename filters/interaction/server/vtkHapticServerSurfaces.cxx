// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticServerSurfaces.h"

#include "haptics/session/HapticSession.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/tool/ToolChoice.h"
#include "vtkHapticHandPace.h"
#include "vtkHapticSceneSurfaces.h"

std::optional<palpate::Vec3> vtkHapticServerSurfaces::GetCentre() const
{
  const palpate::Vec3 hand_W =
    this->Core.running() ? this->Core.state().device_W.p : this->Hand_W.value_or(palpate::Vec3::Zero());
  const bool is = hand_W.allFinite() && (this->Core.running() || this->Hand_W);
  return is ? std::optional(hand_W) : std::nullopt;
}

double vtkHapticServerSurfaces::Pulled() const
{
  const auto& tool = this->Core.chosen<palpate::ToolTask>().tool;
  const double touches_u = tool ? tool->reach_u : this->Core.parameters().contact.radius_u;
  if (!this->Core.running())
  {
    return touches_u;
  }
  const palpate::HapticState& state = this->Core.state();
  const double pulled_u = (state.proxy_W.p - state.device_W.p).norm();
  return touches_u + (std::isfinite(pulled_u) ? pulled_u : 0.0);
}

double vtkHapticServerSurfaces::GetReach() const
{
  const double ahead_u =
    vtkHapticHandPace::fastest_m_per_s * vtkHapticHandPace::ahead_s * this->Core.parameters().map.scale_u_per_m;
  return 2.0 * ahead_u + 2.0 * this->Pulled();
}

bool vtkHapticServerSurfaces::NeedsPart() const
{
  const std::optional<palpate::Vec3> hand_W = this->GetCentre();
  return this->Part.whole != 0 && hand_W &&
         (*hand_W - this->Part.centre_W).norm() + this->Pulled() > 0.5 * this->Part.reach_u;
}

void vtkHapticServerSurfaces::BeginRequest()
{
  this->Scene.ask(++this->Requests);
}

void vtkHapticServerSurfaces::EndRequest()
{
  this->Scene.ask(0);
}

void vtkHapticServerSurfaces::SetPartNumber(int number)
{
  this->Surfaces.SetPartNumber(number);
}

void vtkHapticServerSurfaces::Take(const palpate::ScenePart& part, const std::string& sentence)
{
  this->Part = part;
  this->Sentence = sentence;
  this->Taken = std::chrono::steady_clock::now();
  this->Surfaces.SetPart(part);
}

double vtkHapticServerSurfaces::GetAge() const
{
  return this->Sentence.empty() ? 0.0
                                : std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Taken).count();
}
