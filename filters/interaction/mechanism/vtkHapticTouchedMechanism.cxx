// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticTouchedMechanism.h"

#include "haptics/mechanism/check/BodiesOverlap.h"
#include "haptics/session/mechanism/MechanismBodies.h"
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkSmartPointer<vtkHapticTouchedMechanism> vtkHapticTouchedMechanism::Of(vtkHapticSession& session)
{
  return vtkSmartPointer<vtkHapticTouchedMechanism>::Take(new vtkHapticTouchedMechanism(session));
}

bool vtkHapticTouchedMechanism::GetIsWire() const
{
  return this->Behind().Mechanism.IsWire();
}

const char* vtkHapticTouchedMechanism::GetAdded() const
{
  return this->Behind().Mechanism.Taken().c_str();
}

void vtkHapticTouchedMechanism::SetMoved(bool moved)
{
  this->Behind().Mechanism.DrawnElsewhere = moved;
}

bool vtkHapticTouchedMechanism::Move(vtkPolyData* shapes)
{
  return shapes && this->Behind().Mechanism.Move(*shapes);
}

void vtkHapticTouchedMechanism::GetTable(vtkTable* table) const
{
  this->Behind().Mechanism.FillTable(*table);
}

std::string vtkHapticTouchedMechanism::GetConstraintsWith(const char* law)
{
  std::string problem;
  const std::string laws = this->Behind().Mechanism.With(law ? law : "", problem);
  problem = laws.empty() ? problem : this->Behind().Mechanism.RefusalOf(laws, this->Behind().Core);
  this->Behind().Refuse(problem);
  return problem.empty() ? laws : "";
}

std::string vtkHapticTouchedMechanism::GetConstraintsWithout(const char* name)
{
  std::string problem;
  std::string laws = this->Behind().Mechanism.Without(name ? name : "", problem);
  this->Behind().Refuse(problem);
  return laws;
}

bool vtkHapticTouchedMechanism::PutBack()
{
  const auto felt = this->Behind().Core.feltMechanism();
  const auto now = this->Behind().Core.state().mechanism;
  const std::string inHand = felt && now.held ? palpate::looseInHand(felt->mechanism, now.hand_W) : "";
  if (!inHand.empty())
  {
    const std::string problem = "the hand is where " + inHand + " would be put back: move the hand away first";
    this->Behind().Refuse(problem);
    this->Behind().Follow("Put Back", problem);
    return false;
  }
  vtkHapticHeldMechanism& mechanism = this->Behind().Mechanism;
  const bool held = mechanism.BeginAgain();
  if (held)
  {
    mechanism.Choose(this->Behind().Core);
  }
  const bool back = held || this->Behind().Core.putBack();
  const std::string problem =
    back ? "" : "no mechanism is held, and no source is loose: hold a mechanism before putting its bodies back";
  this->Behind().Refuse(problem);
  this->Behind().Follow("Put Back", problem);
  return back;
}

bool vtkHapticTouchedMechanism::SetDensity(const char* source, double density)
{
  return this->Behind().PutDensity(source ? source : "", density).empty();
}

double vtkHapticTouchedMechanism::GetDensity(const char* source) const
{
  return this->Behind().Surfaces.Styles().Of(source ? source : "").Density;
}

bool vtkHapticTouchedMechanism::BreakConstraint(const char* name)
{
  const int law = this->Behind().Mechanism.IndexOf(name ? name : "");
  const bool felt = this->Behind().Mechanism.IsFelt(); // else the servo may number other constraints
  this->Behind().Refuse(law < 0 ? std::string("there is no constraint \"") + (name ? name : "") + "\" to be broken"
                        : felt  ? ""
                               : "these constraints are not active: break a constraint while the mechanism is touched");
  if (law >= 0 && felt)
  {
    this->Behind().Core.breakConstraint(static_cast<std::uint32_t>(law));
  }
  return law >= 0 && felt;
}
