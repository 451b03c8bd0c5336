// SPDX-License-Identifier: GPL-3.0-or-later
// Friction: two coefficients that may come in either order, and what it does now.
#include <algorithm>

#include "vtkHapticSessionInternals.h"

void vtkHapticSession::SetFrictionStatic(double coefficient)
{
  const double kinetic = std::min(this->Impl->FrictionKinetic, coefficient);
  this->Change("FrictionStatic", { coefficient },
    [=](palpate::HapticParameters& p) {
      p.contact.friction = { coefficient, kinetic };
    });
}

double vtkHapticSession::GetFrictionStatic() const
{
  return this->Impl->Asked.asked().contact.friction.statical;
}

void vtkHapticSession::SetFrictionKinetic(double coefficient)
{
  if (!this->Allows("FrictionKinetic", { coefficient }))
  {
    return;
  }
  this->Impl->FrictionKinetic = coefficient;
  const double used = std::min(coefficient, this->GetFrictionStatic());
  this->Change([=](palpate::HapticParameters& p) { p.contact.friction.kinetic = used; });
}

double vtkHapticSession::GetFrictionKinetic() const
{
  return this->Impl->FrictionKinetic;
}

double vtkHapticSession::GetFrictionKineticUsed() const
{
  return this->Impl->Asked.asked().contact.friction.kinetic;
}

const char* vtkHapticSession::GetFrictionText() const
{
  switch (this->Impl->State.friction)
  {
    case palpate::FrictionState::Sticks:
      return "sticks";
    case palpate::FrictionState::Slips:
      return "slips";
    default:
      return "";
  }
}
