// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in space around the hand: the chosen source, and the block that is felt.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "haptics/session/plan/FittedMap.h"
#include "vtkHapticFieldShape.h"
#include "vtkHapticHandPace.h"
#include "vtkHapticPathData.h"
#include "vtkHapticSessionInternals.h"
#include "vtkPolyData.h"

bool vtkHapticSession::AddField(const char* name, vtkDataObject* data)
{
  Internals& impl = *this->Impl;
  const bool felt = impl.FieldData || impl.FeltField.hasSource();
  const bool gone = !data && impl.FieldArrays.Any();
  const std::string lost =
    impl.FieldName + ": the source is no longer visible, or its field array is missing; choose another one";
  const std::string said = !gone ? "" : felt ? lost : impl.FieldGone;
  const bool added = impl.FeelField(data && name ? name : "",
    data && impl.FieldArrays.Any()
      ? vtkHapticToField(data, impl.FieldArrays, { impl.CompareData.Get(), impl.SnapData.Get() })
      : vtkHapticFieldResult());
  impl.FieldGone = said;
  impl.FieldData = data;
  impl.FieldBounds = data ? vtkHapticFieldBounds(data) : std::array<double, 6>();
  return added;
}

bool vtkHapticSession::Internals::FeelField(const std::string& name, const vtkHapticFieldResult& made)
{
  this->FieldGone.clear();
  this->FieldData = nullptr;
  this->FieldName = name;
  this->FieldProblem = made.Problem.empty() ? "" : this->FieldName + ": " + made.Problem;
  this->FeltField.setSource(made.Source);
  this->FieldEnds = made.Ends;
  this->FieldIsNew = made.Source != nullptr;
  this->FieldAdded_s = this->Now();
  this->FieldBounds = made.Bounds;
  this->Refuse(this->FieldProblem);
  this->Follow("field", this->FieldProblem);
  return this->FieldProblem.empty();
}

void vtkHapticSession::Internals::TakeField(bool wait)
{
  if (this->FollowField(wait))
  {
    const palpate::MadeFieldBlock& made = this->FeltField.made();
    const bool first = made.brick && std::exchange(this->FieldIsNew, false);
    palpate::FieldPlan plan = this->Asked.asked().field;
    if (first && this->Core.running() && palpate::isOfTouch(this->FieldAdded_s, this->Begun_s) && this->FitsNow() &&
        !this->HasSurfaces())
    {
      this->Fit();
      this->LeadMouseAnew();
      plan = this->Asked.asked().field;
    }
    const palpate::DetentPlan before = plan.detent;
    palpate::takeFromData(plan, made, first);
    if (plan.detent.slope_per_u != before.slope_per_u || plan.detent.bounds != before.bounds)
    {
      this->Change(
        [&](palpate::HapticParameters& p)
        {
          p.field.detent.slope_per_u = plan.detent.slope_per_u;
          p.field.detent.bounds = plan.detent.bounds;
        });
    }
  }
}

bool vtkHapticSession::FinishField()
{
  this->Impl->TakeField(true);
  return this->Impl->Core.brick() != nullptr;
}

bool vtkHapticSession::Internals::HasSurfaces() const
{
  return this->Scene.built().scene && !this->Scene.built().scene->empty();
}

/// Surfaces, or where there are none the field: a hand is fitted to their box.
palpate::BuiltScene vtkHapticSession::Internals::Fittable() const
{
  palpate::BuiltScene fittable = this->Scene.built();
  fittable.bounds = this->HasSurfaces() || !this->FeltField.hasSource() ? fittable.bounds : this->FieldBounds;
  return fittable;
}

bool vtkHapticSession::Internals::IsFittable() const
{
  return this->Scene.built().scene || this->FeltField.hasSource();
}

const char* vtkHapticSession::GetFieldName() const
{
  return this->Impl->FieldName.c_str();
}

bool vtkHapticSession::Internals::FollowField(bool wait)
{
  const palpate::Vec3 hand_W =
    this->Core.running() ? this->Core.state().device_W.p : this->Hand_W.value_or(palpate::Vec3::Zero());
  const double reach_u =
    vtkHapticHandPace::fastest_m_per_s * vtkHapticHandPace::ahead_s * this->Asked.asked().map.scale_u_per_m;
  const auto brick = this->FeltField.follow(hand_W, reach_u, this->Asked.asked().field, wait);
  if (brick)
  {
    this->Core.setFieldBlock(*brick);
  }
  return brick.has_value();
}

std::string vtkHapticSession::Internals::FollowFieldArrays()
{
  this->FieldArrays = vtkHapticFieldArraysOf(this->Settings);
  const std::string& chosen = this->Settings.text("FeltSource");
  if (!chosen.empty() && chosen != this->FieldName)
  {
    this->FieldData = nullptr; // the arrays are those of the chosen source, which is added by who follows a view
  }
  this->FeelFieldAnew();
  return {};
}

std::string vtkHapticSession::Internals::FollowDetentLevels()
{
  palpate::DetentPlan detent = this->Asked.asked().field.detent;
  const std::string& levels = this->Settings.text("FieldDetentLevels");
  std::string problem = palpate::setLevels(detent, levels);
  if (problem.empty())
  {
    this->Change([&](palpate::HapticParameters& p) { static_cast<void>(palpate::setLevels(p.field.detent, levels)); });
  }
  return problem;
}

/// The data that were added are felt with the settings of now.
void vtkHapticSession::Internals::FeelFieldAnew()
{
  if (this->FieldData)
  {
    const std::string name = this->FieldName;
    static_cast<void>(this->Session.AddField(name.c_str(), vtkSmartPointer<vtkDataObject>(this->FieldData)));
  }
  this->MaterialTime.Modified(); // who follows a view looks again for data that has these arrays
  this->Session.Modified();
}

std::optional<palpate::FieldSample> vtkHapticSession::Internals::FieldAtHand() const
{
  const std::shared_ptr<const palpate::FieldBlock>& brick = this->Core.brick();
  const palpate::Vec3 hand_W(this->Hand);
  return brick ? brick->finestAt(hand_W).sample(palpate::FieldBlockRole::Scalar, hand_W) : std::nullopt;
}

const char* vtkHapticSession::Internals::SayFieldText()
{
  this->FieldText = this->FieldProblem.empty() ? this->FieldGone : this->FieldProblem;
  const palpate::MadeFieldBlock& made = this->FeltField.made();
  if (this->FeltField.hasSource())
  {
    const palpate::HapticParameters& asked = this->Asked.asked();
    this->FieldText = palpate::fieldText(this->FieldName, made, asked.map.scale_u_per_m, vtkHapticHandPace::ahead_s);
    const std::string point = palpate::pointText(asked.field, asked.contact.radius_u);
    this->FieldText += point.empty() ? "" : "; " + point;
    const std::string lattice = palpate::latticeText(asked.field, made, palpate::Vec3(this->Hand));
    this->FieldText += lattice.empty() ? "" : "; " + lattice;
    const double stiffness_N_per_m =
      this->State.stiffness_N_per_m > 0.0 ? this->State.stiffness_N_per_m : asked.stiffness_N_per_m;
    const std::string detent =
      made.brick ? palpate::detentText(asked.field, stiffness_N_per_m / asked.map.scale_u_per_m) : "";
    this->FieldText += detent.empty() ? "" : "; " + detent;
    const std::string level = palpate::levelText(asked.field, this->FieldEnds);
    this->FieldText += level.empty() ? "" : "; " + level;
  }
  return this->FieldText.c_str();
}

double* vtkHapticSession::Internals::GradientNow()
{
  const auto sample = this->FieldAtHand();
  Eigen::Map<palpate::Vec3>{ this->FieldGradient } =
    sample ? sample->gradient_W : palpate::Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  return this->FieldGradient;
}
