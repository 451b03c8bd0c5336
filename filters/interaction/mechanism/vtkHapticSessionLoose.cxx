// SPDX-License-Identifier: GPL-3.0-or-later
// Sources that are loose bodies.
#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/check/MechanismCheck.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/mechanism/MechanismBodies.h"
#include "haptics/session/mechanism/ToolOnBody.h"
#include "vtkCommand.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"

namespace
{
struct Unit
{
  std::string_view Name;
  double Metres; ///< 0: not known
};
/// The choices of SceneUnit but the first, which is that of the files.
constexpr std::array<Unit, 5> Units = { { { "u", 0.0 }, { "um", 1e-6 }, { "mm", 1e-3 }, { "cm", 1e-2 },
  { "m", 1.0 } } };

double Metres(const std::string& unit)
{
  const auto found = std::find_if(Units.begin(), Units.end(), [&unit](const Unit& each) { return each.Name == unit; });
  return found != Units.end() ? found->Metres : 0.0;
}

/// Null: no body of that mechanism is the loose one of that name.
const palpate::MechanismBody* LooseOf(const palpate::MechanismInputs& inputs, const std::string& name)
{
  const auto& bodies = inputs.mechanism.bodies;
  const auto found = std::find_if(bodies.begin(), bodies.end(),
    [&name](const palpate::MechanismBody& body) { return body.name == name && palpate::isLoose(body); });
  return found != bodies.end() ? &*found : nullptr;
}

std::string MassText(double mass_kg)
{
  std::ostringstream text;
  text.precision(3);
  text << mass_kg << " kg";
  return text.str();
}
} // namespace

std::string vtkHapticSession::Internals::PutDensity(const std::string& source, double density)
{
  const std::string refused = vtkHapticRefuseDensity(density);
  const std::string problem = refused.empty() ? refused : source + ": " + refused;
  this->Refuse(problem);
  this->Follow("density of " + source, problem);
  vtkHapticSourceStyle style = this->Surfaces.Styles().Of(source);
  if (problem.empty() && style.Density != density)
  {
    style.Density = density;
    this->Surfaces.Styles().Set(source, style);
    this->FollowSources();
    this->Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
  return problem;
}

std::string vtkHapticSession::Internals::FollowLooseSettings()
{
  this->FollowLoose();
  if (this->Core.looseRefusal().empty()) // a setting of all sources is not refused for one of them
  {
    this->JudgeLoose();
  }
  return {};
}

void vtkHapticSession::Internals::FollowLoose()
{
  const int chosen = this->Settings.whole("SceneUnit");
  palpate::LooseSources loose;
  loose.density_kg_per_m3 = this->Surfaces.Styles().Densities();
  loose.unit_m = chosen == 0 ? Metres(this->UnitOfFiles) : Units.at(static_cast<std::size_t>(chosen) - 1).Metres;
  loose.gravity_m_per_s2 = palpate::Vec3(this->Settings.of("Gravity").numbers.data());
  this->Core.setLoose(loose);
}

void vtkHapticSession::Internals::JudgeLoose()
{
  const std::string& problem = this->Core.looseRefusal();
  if (problem != this->LooseRefused)
  {
    this->LooseRefused = problem;
    this->Refuse(problem);
    this->Follow("loose sources", problem);
  }
}

std::shared_ptr<const palpate::MechanismInputs> vtkHapticSession::Internals::AmongLoose() const
{
  return this->Core.toolPresses() ? this->Core.feltMechanism() : nullptr;
}

bool vtkHapticSession::Internals::LooseAreSeen() const
{
  const palpate::MechanismNow& now = this->State.mechanism;
  return this->AmongLoose() && now.held && now.revision == this->Core.status<palpate::MechanismTask>().plan;
}

std::optional<palpate::Pose> vtkHapticSession::Internals::LooseWay(const std::string& name) const
{
  const auto inputs = this->AmongLoose();
  const palpate::MechanismBody* const body = inputs ? LooseOf(*inputs, name) : nullptr;
  const palpate::MechanismNow& now = this->State.mechanism;
  if (!body || !this->LooseAreSeen())
  {
    return std::nullopt;
  }
  const auto place = static_cast<std::size_t>(body - inputs->mechanism.bodies.data());
  const palpate::Quat turn_W = now.pose_W[place].q * body->pose_W.q.conjugate();
  return palpate::Pose{ now.pose_W[place].p - turn_W * body->pose_W.p, turn_W };
}

std::string vtkHapticSession::Internals::WhyNotLoose(const std::string& name) const
{
  return this->Core.chosen<palpate::MechanismTask>().inputs
           ? "fixed while a mechanism is held; hold none to touch it as loose"
         : this->Settings.text("ToolSource") == name ? "is the tool in the hand; release it first"
         : !this->Surfaces.Styles().Of(name).Touched ? "is not touched; switch it on in Active source"
         : this->LooseGone.contains(name)
           ? "no source is called " + name + "; remove it from SourcesText, or give a source that name"
           : "to be loose, but not among the touched surfaces; show the source, and press Touch";
}

std::string vtkHapticSession::Internals::LooseProblem() const
{
  const std::string& refusal = this->Core.looseRefusal();
  const auto inputs = this->AmongLoose();
  if (!refusal.empty() || !inputs || this->Surfaces.Styles().Densities().empty())
  {
    return refusal;
  }
  const char* const remedy =
    inputs->soft.empty() ? "choose the unit of lengths (SceneUnit)" : "choose another unit for the soft body (Unit)";
  return palpate::withUnitTaken(this->Core.status<palpate::MechanismTask>().problem, *inputs, remedy);
}

std::string vtkHapticSession::Internals::LooseFallen() const
{
  const auto inputs = this->AmongLoose();
  const palpate::MechanismNow& now = this->State.mechanism;
  if (!this->LooseAreSeen())
  {
    return {};
  }
  const auto& bodies = inputs->mechanism.bodies;
  const double farthest_u = palpate::farthestLoose_u(inputs->mechanism);
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    if (palpate::isLoose(bodies[b]) && (now.pose_W[b].p - bodies[b].pose_W.p).norm() > farthest_u)
    {
      return bodies[b].name;
    }
  }
  return {};
}

std::string vtkHapticSession::Internals::LooseTrouble() const
{
  const std::string fallen = this->LooseFallen();
  return fallen.empty()
           ? this->LooseProblem()
           : fallen + " has fallen out of the scene: put it back (Put Back) onto a surface, or turn Gravity";
}

const char* vtkHapticSession::Internals::SayLooseText()
{
  const auto inputs = this->AmongLoose();
  const palpate::MechanismStatus status =
    inputs ? this->Core.status<palpate::MechanismTask>() : palpate::MechanismStatus();
  const std::string fallen = this->LooseFallen();
  std::ostringstream lines;
  for (const auto& [name, density] : this->Surfaces.Styles().Densities())
  {
    const palpate::MechanismBody* const body = inputs ? LooseOf(*inputs, name) : nullptr;
    lines << name << ": "
          << (body ? "loose, " + MassText(body->mass.mass_Ns2_per_u / inputs->unit_m) : this->WhyNotLoose(name))
          << (body && name == fallen ? "; has fallen out of the scene" : "");
    for (const auto& [a, b] : status.check.overlaps)
    {
      if (body && (a == name || b == name))
      {
        lines << "; overlaps " << (a == name ? b : a) << " where it begins, and is pushed out slowly; move one of them";
      }
    }
    lines << "\n";
  }
  const std::string problem = this->LooseProblem();
  this->LooseText = problem.empty() || lines.str().empty() ? lines.str() : problem + "\n";
  return this->LooseText.c_str();
}
