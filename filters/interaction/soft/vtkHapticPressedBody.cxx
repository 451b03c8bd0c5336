// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPressedBody.h"

#include <sstream>

#include "haptics/session/settings/Setting.h"
#include "vtkHapticSoftBodyData.h"

namespace
{
/// Largest |F - 1| within which small strain is true to 1 %, and from which on any law of these is qualitative.
constexpr double SmallStrain = 0.1, LargeStrain = 0.5;
constexpr double CountEvery_s = 1.0;

std::string Rounded(double value, int digits)
{
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}
} // namespace

std::string vtkHapticPressedBody::Take(const std::string& name, vtkDataObject* data)
{
  this->Name = name;
  const vtkHapticSoftBodyResult read = data ? vtkHapticToSoftBody(data) : vtkHapticSoftBodyResult();
  this->Input = read.Input;
  this->Material = read.Input ? vtkHapticSoftBodyText(*read.Input) : "";
  this->Problem = data && !read.Input ? name + " cannot give way: " + read.Problem : "";
  this->Shown = nullptr;
  return this->Problem;
}

void vtkHapticPressedBody::CountPackets(double now_s)
{
  if (this->Status.packets < this->CountedPackets) // of another body
  {
    this->CountedPackets = 0;
    this->Counted_s = now_s;
  }
  if (now_s - this->Counted_s >= CountEvery_s)
  {
    this->PacketsPerSecond =
      static_cast<double>(this->Status.packets - this->CountedPackets) / (now_s - this->Counted_s);
    this->CountedPackets = this->Status.packets;
    this->Counted_s = now_s;
  }
}

void vtkHapticPressedBody::Follow(palpate::HapticSession& core, const palpate::HapticState& state, double now_s)
{
  this->Status = core.running() ? core.softStatus() : palpate::SoftStatus{};
  this->CountPackets(now_s);
  this->Strain = this->Status.shape ? this->Status.shape->mostGradient : 0.0;
  this->Text = this->Source.empty() ? "" : this->Sentence(state);
}

std::string vtkHapticPressedBody::StrainSentence() const
{
  const palpate::Vec3& at = this->Status.shape->worst_W;
  const std::string where = " at (" + Rounded(at.x(), 4) + ", " + Rounded(at.y(), 4) + ", " + Rounded(at.z(), 4) + ")";
  return ", largest strain " + Rounded(100.0 * this->Strain, 2) + " %" + (this->Strain > 0.0 ? where : "") +
         (this->Strain > LargeStrain    ? ": qualitative from here on"
           : this->Strain > SmallStrain ? ": a linear law is off by more than 1 %"
                                        : "");
}

std::string vtkHapticPressedBody::Sentence(const palpate::HapticState& state) const
{
  if (!this->Problem.empty())
  {
    return this->Problem;
  }
  if (!this->Input)
  {
    return this->Source + " is not there: choose another source as the soft body, or none";
  }
  const std::string text = this->Name + ": " + this->Material;
  if (!this->Status.problem.empty())
  {
    return text + ". It does not give way: " + this->Status.problem;
  }
  if (!this->Status.shape)
  {
    return text + (this->Status.building ? "; is being computed, and rigid until then" : "");
  }
  return text + "; " + Rounded(this->PacketsPerSecond, 3) + " packets a second, " +
         (state.soft.felt ? palpate::quantity(1e3 * state.soft.age_s, "ms") + " old" : "not taken yet") +
         this->StrainSentence() +
         (state.soft.pressed && this->Status.shape->struck
             ? "; struck faster than a body as dense as water follows: its inertia is left out"
             : "");
}

bool vtkHapticPressedBody::Bend(vtkUnstructuredGrid& body)
{
  if (!this->Input || this->Status.shape == this->Shown)
  {
    return false;
  }
  this->Shown = this->Status.shape;
  vtkHapticBendBody(body, *this->Input, this->Status.asMade.get(), this->Shown.get());
  return true;
}
