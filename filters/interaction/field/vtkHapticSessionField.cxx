// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in space around the hand: which, and what is there.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "vtkHapticFieldShape.h"
#include "vtkHapticHandPace.h"
#include "vtkHapticSessionInternals.h"
#include "vtkPolyData.h"

bool vtkHapticSession::AddField(const char* name, vtkDataObject* data)
{
  Internals& impl = *this->Impl;
  const bool felt = impl.FieldData || impl.FeltField.hasSource();
  const bool gone = !data && impl.FieldArrays.Any();
  const std::string lost = impl.FieldName + ": it is not shown any more, or an array that was felt of it as a field is "
                                            "gone; choose another one";
  const std::string said = !gone ? "" : felt ? lost : impl.FieldGone;
  const bool added = this->AddRemoteField(data && name ? name : "",
    data && impl.FieldArrays.Any()
      ? vtkHapticToField(data, impl.FieldArrays, { impl.CompareData.Get(), impl.SnapData.Get() })
      : vtkHapticFieldResult());
  impl.FieldGone = said;
  impl.FieldData = data;
  impl.FieldBounds = data ? vtkHapticFieldBounds(data) : std::array<double, 6>();
  return added;
}

bool vtkHapticSession::AddRemoteField(const char* name, const vtkHapticFieldResult& made)
{
  Internals& impl = *this->Impl;
  impl.FieldGone.clear();
  impl.FieldData = nullptr;
  impl.FieldName = name;
  impl.FieldProblem = made.Problem.empty() ? "" : impl.FieldName + ": " + made.Problem;
  impl.FeltField.setSource(made.Source);
  impl.FieldEnds = made.Ends;
  impl.FieldIsNew = made.Source != nullptr;
  impl.FieldBounds = made.Bounds;
  this->Refuse(impl.FieldProblem);
  impl.Follow("field", impl.FieldProblem);
  return impl.FieldProblem.empty();
}

void vtkHapticSession::TakeField(bool wait)
{
  Internals& impl = *this->Impl;
  if (impl.FollowField(wait))
  {
    const palpate::MadeBrick& made = impl.FeltField.made();
    const bool first = made.brick && std::exchange(impl.FieldIsNew, false);
    palpate::FieldPlan plan = impl.Asked.asked().field;
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
  this->TakeField(true);
  return this->Impl->Core.brick() != nullptr;
}

/// Surfaces, or where there are none the field: what a hand is fitted to.
palpate::BuiltScene vtkHapticSession::Internals::Fittable() const
{
  palpate::BuiltScene fittable = this->Scene.built();
  fittable.bounds = fittable.scene ? fittable.bounds : this->FieldBounds;
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
    this->Core.setBrick(*brick);
  }
  return brick.has_value();
}

/// What the arrays are that are felt changed: what was added is felt so.
void vtkHapticSession::ChangeField(
  const char* setting, std::initializer_list<double> values, const std::function<void(vtkHapticFieldArrays&)>& change)
{
  vtkHapticFieldArrays arrays = this->Impl->FieldArrays;
  change(arrays);
  if (!this->Allows(setting, values) || arrays == this->Impl->FieldArrays)
  {
    return;
  }
  this->Impl->FieldArrays = arrays;
  this->FeelFieldAnew();
}

/// What was added is felt as it is to be felt now.
void vtkHapticSession::FeelFieldAnew()
{
  if (this->Impl->FieldData)
  {
    const std::string name = this->Impl->FieldName;
    static_cast<void>(this->AddField(name.c_str(), vtkSmartPointer<vtkDataObject>(this->Impl->FieldData)));
  }
  this->Impl->MaterialTime.Modified(); // who follows a view looks again for data that has these arrays
  this->Modified();
}

void vtkHapticSession::SetFieldBeside(vtkDataObject* compared, vtkDataObject* snap)
{
  Internals& impl = *this->Impl;
  const vtkMTimeType time = std::max(compared ? compared->GetMTime() : 0, snap ? snap->GetMTime() : 0);
  if (impl.CompareData != compared || impl.SnapData != snap || impl.BesideTime != time)
  {
    impl.BesideTime = time;
    impl.CompareData = compared;
    impl.SnapData = snap;
    this->FeelFieldAnew();
  }
}

void vtkHapticSession::NameSource(std::string& kept, const char* name)
{
  const std::string asked = name ? name : "";
  if (kept != asked)
  {
    kept = asked;
    this->FeelFieldAnew();
  }
}

void vtkHapticSession::SetFeltSource(const char* name)
{
  this->NameSource(this->Impl->FeltSource, name);
}

const char* vtkHapticSession::GetFeltSource() const
{
  return this->Impl->FeltSource.c_str();
}

void vtkHapticSession::SetCompareSource(const char* name)
{
  this->NameSource(this->Impl->CompareSource, name);
}

const char* vtkHapticSession::GetCompareSource() const
{
  return this->Impl->CompareSource.c_str();
}

void vtkHapticSession::SetSnapSource(const char* name)
{
  this->NameSource(this->Impl->SnapSource, name);
}

const char* vtkHapticSession::GetSnapSource() const
{
  return this->Impl->SnapSource.c_str();
}

void vtkHapticSession::SetFieldEigenvector(int which)
{
  this->ChangeField(
    "FieldEigenvector", { static_cast<double>(which) }, [=](vtkHapticFieldArrays& a) { a.Eigenvector = which; });
}

int vtkHapticSession::GetFieldEigenvector() const
{
  return this->Impl->FieldArrays.Eigenvector;
}

void vtkHapticSession::SetFieldDetentLevels(const char* levels)
{
  const std::string asked = levels ? levels : "";
  palpate::DetentPlan detent = this->Impl->Asked.asked().field.detent;
  const std::string problem = palpate::setLevels(detent, asked);
  this->Refuse(problem);
  this->Impl->Follow("FieldDetentLevels", problem);
  if (problem.empty() && asked != this->Impl->DetentLevels)
  {
    this->Impl->DetentLevels = asked;
    this->Change([&](palpate::HapticParameters& p) { static_cast<void>(palpate::setLevels(p.field.detent, asked)); });
    this->Modified();
  }
}

const char* vtkHapticSession::GetFieldDetentLevels() const
{
  return this->Impl->DetentLevels.c_str();
}

void vtkHapticSession::SetFieldArray(const char* name)
{
  this->ChangeField("FieldArray", {}, [=](vtkHapticFieldArrays& a) { a.Scalar = name ? name : ""; });
}

const char* vtkHapticSession::GetFieldArray() const
{
  return this->Impl->FieldArrays.Scalar.c_str();
}

void vtkHapticSession::SetFieldComponent(int component)
{
  this->ChangeField(
    "FieldComponent", { static_cast<double>(component) }, [=](vtkHapticFieldArrays& a) { a.Component = component; });
}

int vtkHapticSession::GetFieldComponent() const
{
  return this->Impl->FieldArrays.Component;
}

void vtkHapticSession::SetFieldVectors(const char* name)
{
  this->ChangeField("FieldVectors", {}, [=](vtkHapticFieldArrays& a) { a.Vector = name ? name : ""; });
}

const char* vtkHapticSession::GetFieldVectors() const
{
  return this->Impl->FieldArrays.Vector.c_str();
}

void vtkHapticSession::SetFieldResistance(const char* name)
{
  this->ChangeField("FieldResistance", {}, [=](vtkHapticFieldArrays& a) { a.Resistance = name ? name : ""; });
}

const char* vtkHapticSession::GetFieldResistance() const
{
  return this->Impl->FieldArrays.Resistance.c_str();
}

void vtkHapticSession::SetFieldOther(const char* name)
{
  this->ChangeField("FieldOther", {}, [=](vtkHapticFieldArrays& a) { a.Other = name ? name : ""; });
}

const char* vtkHapticSession::GetFieldOther() const
{
  return this->Impl->FieldArrays.Other.c_str();
}

void vtkHapticSession::SetFieldSmoothing(int times)
{
  this->ChangeField(
    "FieldSmoothing", { static_cast<double>(times) }, [=](vtkHapticFieldArrays& a) { a.Smoothing = times; });
}

int vtkHapticSession::GetFieldSmoothing() const
{
  return this->Impl->FieldArrays.Smoothing;
}

void vtkHapticSession::GetFieldShape(vtkPolyData* shape) const
{
  const std::shared_ptr<const palpate::Brick>& brick = this->Impl->Core.brick();
  shape->Initialize();
  const palpate::Vec3& proxy_W = this->Impl->State.field.proxy_W;
  if (brick && proxy_W.allFinite())
  {
    vtkHapticFieldShape(
      brick->finestAt(proxy_W), this->Impl->Asked.asked().field, palpate::Vec3(this->Impl->Hand), proxy_W, shape);
  }
}

std::optional<palpate::FieldSample> vtkHapticSession::Internals::FieldAtHand() const
{
  const std::shared_ptr<const palpate::Brick>& brick = this->Core.brick();
  const palpate::Vec3 hand_W(this->Hand);
  return brick ? brick->finestAt(hand_W).sample(palpate::BrickRole::Scalar, hand_W) : std::nullopt;
}

double vtkHapticSession::GetFieldValue() const
{
  const std::shared_ptr<const palpate::Brick>& brick = this->Impl->Core.brick();
  const auto value = brick ? brick->scalarFelt(palpate::Vec3(this->Impl->Hand)) : std::nullopt;
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

double* vtkHapticSession::GetFieldGradient()
{
  const auto sample = this->Impl->FieldAtHand();
  Eigen::Map<palpate::Vec3>{ this->Impl->FieldGradient } =
    sample ? sample->gradient_W : palpate::Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  return this->Impl->FieldGradient;
}

double vtkHapticSession::GetFieldPushPower() const
{
  constexpr double milli = 1e3;
  return milli * this->Impl->State.field.pushPower_W;
}

vtkIdType vtkHapticSession::GetFieldTicksBeyond() const
{
  return static_cast<vtkIdType>(this->Impl->State.field.beyondTicks);
}

double vtkHapticSession::GetFieldError() const
{
  return this->Impl->FeltField.made().error;
}

double vtkHapticSession::GetFieldAge() const
{
  return this->Impl->FeltField.age_s();
}

const char* vtkHapticSession::GetFieldSentence() const
{
  Internals& impl = *this->Impl;
  impl.FieldSentence = impl.FieldProblem.empty() ? impl.FieldGone : impl.FieldProblem;
  const palpate::MadeBrick& made = impl.FeltField.made();
  if (impl.FeltField.hasSource())
  {
    const palpate::HapticParameters& asked = impl.Asked.asked();
    impl.FieldSentence =
      palpate::fieldSentence(impl.FieldName, made, asked.map.scale_u_per_m, vtkHapticHandPace::ahead_s);
    const std::string point = palpate::pointSentence(asked.field, asked.contact.radius_u);
    impl.FieldSentence += point.empty() ? "" : "; " + point;
    const std::string lattice = palpate::latticeSentence(asked.field, made, palpate::Vec3(impl.Hand));
    impl.FieldSentence += lattice.empty() ? "" : "; " + lattice;
    const double stiffness_N_per_m =
      impl.State.stiffness_N_per_m > 0.0 ? impl.State.stiffness_N_per_m : asked.stiffness_N_per_m;
    const std::string detent =
      made.brick ? palpate::detentSentence(asked.field, stiffness_N_per_m / asked.map.scale_u_per_m) : "";
    impl.FieldSentence += detent.empty() ? "" : "; " + detent;
    const std::string level = palpate::levelSentence(asked.field, impl.FieldEnds);
    impl.FieldSentence += level.empty() ? "" : "; " + level;
  }
  return impl.FieldSentence.c_str();
}
