// SPDX-License-Identifier: GPL-3.0-or-later
// Friction: two coefficients that may come in either order, and what it does now; smooth forces over facets.
#include <algorithm>
#include <cmath>

#include "haptics/geometry/mesh/Material.h"
#include "vtkHapticSessionInternals.h"

namespace
{
/// A number that cannot be is left as it is, for the parameters to refuse.
double Used(double kinetic, double statical)
{
  return kinetic <= palpate::Material::largestFriction ? std::min(kinetic, statical) : kinetic;
}
} // namespace

void vtkHapticSession::SetFrictionStatic(double coefficient)
{
  const double kinetic = Used(this->Impl->FrictionKinetic, coefficient);
  this->Change([=](palpate::HapticParameters& p) { p.contact.friction = { coefficient, kinetic }; });
}

double vtkHapticSession::GetFrictionStatic() const
{
  return this->Impl->Parameters.contact.friction.statical;
}

void vtkHapticSession::SetFrictionKinetic(double coefficient)
{
  const double used = Used(coefficient, this->GetFrictionStatic());
  this->Change([=](palpate::HapticParameters& p) { p.contact.friction.kinetic = used; });
  if (this->GetFrictionKineticUsed() == used)
  {
    this->Impl->FrictionKinetic = coefficient;
  }
}

double vtkHapticSession::GetFrictionKinetic() const
{
  return this->Impl->FrictionKinetic;
}

double vtkHapticSession::GetFrictionKineticUsed() const
{
  return this->Impl->Parameters.contact.friction.kinetic;
}

void vtkHapticSession::SetForceShading(bool on)
{
  this->Change([=](palpate::HapticParameters& p) { p.contact.shading = on; });
}

bool vtkHapticSession::GetForceShading() const
{
  return this->Impl->Parameters.contact.shading;
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
