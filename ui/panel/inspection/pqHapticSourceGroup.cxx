// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSourceGroup.h"

#include "haptics/geometry/mesh/Material.h"
#include "pqActiveObjects.h"
#include "pqHapticController.h"
#include "pqHapticLabel.h"
#include "pqHapticQuantityBox.h"
#include "pqHapticTouchKinds.h"
#include "pqPipelineSource.h"
#include "vtkHapticSession.h"
#include "vtkHapticTouchedMechanism.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>

#include <algorithm>

namespace
{
/// The value of a box where the session's own is meant.
constexpr double asSession = -1.0;
constexpr int decimals = 3;
constexpr int leastWidth = 90; // else the widest number makes the whole panel wide [pixels]
constexpr double largestStiffness_N_per_m = 1e6;
constexpr double leastDensity = 0.001, largestDensity = 1e6, densityOfWater = 1000.0; // kg/m3

/// Entries of the list, in this order.
enum Kinds
{
  Fixed,
  Loose,
  Soft
};

/// Empty: none is active.
QByteArray ActiveName()
{
  pqPipelineSource* const source = pqActiveObjects::instance().activeSource();
  return source ? source->getSMName().toUtf8() : QByteArray();
}

/// Text that is being typed stays while the value is the same.
void Show(QDoubleSpinBox* box, double value)
{
  const QSignalBlocker nothingWasTyped(box);
  if (box->value() != value)
  {
    box->setValue(value);
  }
}
} // namespace

pqHapticSourceGroup::pqHapticSourceGroup(QWidget* parent) : Superclass(tr("Active source"), "source", parent)
{
  this->Source = this->addText("sourceName", tr("Active source of the pipeline browser"));
  this->Touched = new QCheckBox(tr("Touched as"), this);
  this->Touched->setObjectName("sourceTouched");
  this->Touched->setToolTip(tr("Off: the source is visible but not touchable"));
  this->Kind = new QComboBox(this);
  this->Kind->setObjectName("sourceKind");
  this->Kind->addItems({ tr("Fixed"), tr("Loose"), tr("Soft") });
  this->Kind->setToolTip(
    tr("Fixed: a part of the scene. Loose: a rigid body with mass, which falls and is pushed. Soft: "
       "the soft body of the page Tissue"));
  this->Form->addRow(this->Touched, this->Kind);
  this->Density = this->addNumber(
    "sourceDensity", tr("Its density"), tr("Density of a loose source; with the volume of its surface, its mass"));
  this->Density->setSuffix(" kg/m\u00b3");
  this->Density->setSpecialValueText({});
  this->Density->setRange(leastDensity, largestDensity);
  this->Density->setValue(densityOfWater);
  this->Loose = this->addText("sourceLoose", tr("Mass of the loose sources, or the reason why they are fixed"));
  this->Stiffness = this->addNumber("sourceStiffness", tr("Its stiffness"),
    tr("Stiffness of this source, at most the session's stiffness; an array has priority"));
  this->Stiffness->setSuffix(" N/m");
  this->Stiffness->setMaximum(largestStiffness_N_per_m);
  this->FrictionStatic = this->addNumber("sourceFrictionStatic", tr("Its static friction"), tr("At rest"));
  this->FrictionKinetic = this->addNumber("sourceFrictionKinetic", tr("Its kinetic friction"), tr("While it slides"));
  this->connect(this->Touched, &QCheckBox::toggled, this, &pqHapticSourceGroup::setTouched);
  this->connect(this->Kind, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &pqHapticSourceGroup::setKind);
  this->connect(
    this->Density, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &pqHapticSourceGroup::setDensity);
  const auto changed = QOverload<double>::of(&QDoubleSpinBox::valueChanged);
  this->connect(this->Stiffness, changed, this, &pqHapticSourceGroup::setMaterial);
  this->connect(this->FrictionStatic, changed, this, &pqHapticSourceGroup::setStatic);
  this->connect(this->FrictionKinetic, changed, this, &pqHapticSourceGroup::setKinetic);
  this->refresh(nullptr);
}

QDoubleSpinBox* pqHapticSourceGroup::addNumber(const char* name, const QString& title, const QString& tip)
{
  auto* box = new pqHapticQuantityBox(decimals, this);
  box->setObjectName(name);
  box->setToolTip(tip);
  box->setRange(asSession, palpate::Material::largestFriction);
  box->setSpecialValueText(tr("the session's"));
  box->setKeyboardTracking(false);
  box->setMinimumWidth(leastWidth);
  this->Form->addRow(title, box);
  return box;
}

void pqHapticSourceGroup::refresh(vtkHapticSession* session)
{
  const QByteArray name = ActiveName();
  for (QWidget* field : this->fields())
  {
    field->setEnabled(session && !name.isEmpty());
  }
  this->Source->setText(name.isEmpty() ? tr("None: click one in the pipeline browser.") : QString::fromUtf8(name));
  if (!session || name.isEmpty())
  {
    return;
  }
  const QSignalBlocker nothingWasClicked(this->Touched);
  this->Touched->setChecked(session->GetSourceTouched(name.constData()));
  const double density = session->GetMechanism()->GetDensity(name.constData());
  const bool soft = name == session->GetSettingText("SoftSource");
  const QSignalBlocker nothingWasChosen(this->Kind);
  this->Kind->setCurrentIndex(density > 0.0 ? Kinds::Loose : soft ? Kinds::Soft : Kinds::Fixed);
  this->Density->setVisible(density > 0.0); // the page fits its place
  this->Form->labelForField(this->Density)->setVisible(density > 0.0);
  Show(this->Density, density > 0.0 ? density : densityOfWater);
  pqHapticSay(this->Loose, QString::fromUtf8(session->GetLooseText()).trimmed());
  double material[3];
  session->GetSourceMaterial(name.constData(), material);
  Show(this->Stiffness, material[0] == palpate::Material::rigid_N_per_m ? asSession : material[0]);
  Show(this->FrictionStatic, material[1]);
  Show(this->FrictionKinetic, material[2]);
}

QList<QWidget*> pqHapticSourceGroup::fields() const
{
  return { this->Touched, this->Kind, this->Density, this->Stiffness, this->FrictionStatic, this->FrictionKinetic };
}

void pqHapticSourceGroup::setTouched(bool on)
{
  if (vtkHapticSession* session = pqHapticController::instance()->session())
  {
    session->SetSourceTouched(ActiveName().constData(), on);
  }
}

void pqHapticSourceGroup::setKind(int kind)
{
  pqHapticController* const controller = pqHapticController::instance();
  vtkHapticSession* const session = controller->session();
  if (!session)
  {
    return;
  }
  const QByteArray name = ActiveName();
  const bool wasSoft = name == session->GetSettingText("SoftSource");
  if (kind == Kinds::Soft)
  {
    controller->kinds()->touchAs(pqActiveObjects::instance().activeSource(), "tissue");
  }
  else if (wasSoft)
  {
    vtkSMPropertyHelper(controller->sessionProxy(), "SoftSource").Set("");
    controller->sessionProxy()->UpdateVTKObjects();
  }
  session->GetMechanism()->SetDensity(name.constData(), kind == Kinds::Loose ? this->Density->value() : 0.0);
  this->refresh(session);
}

void pqHapticSourceGroup::setDensity(double density)
{
  vtkHapticSession* const session = pqHapticController::instance()->session();
  if (session && this->Kind->currentIndex() == Kinds::Loose)
  {
    session->GetMechanism()->SetDensity(ActiveName().constData(), density);
  }
}

/// Both are of its own or neither, and the kinetic one is no more than the static one: the other one follows.
void pqHapticSourceGroup::setStatic(double friction)
{
  const double kinetic = this->FrictionKinetic->value();
  Show(this->FrictionKinetic, kinetic < 0.0 ? friction : std::min(kinetic, friction));
  this->setMaterial();
}

void pqHapticSourceGroup::setKinetic(double friction)
{
  Show(this->FrictionStatic, friction < 0.0 ? friction : std::max(this->FrictionStatic->value(), friction));
  this->setMaterial();
}

void pqHapticSourceGroup::setMaterial()
{
  if (vtkHapticSession* session = pqHapticController::instance()->session())
  {
    const double stiffness = this->Stiffness->value();
    session->SetSourceMaterial(ActiveName().constData(), stiffness < 0.0 ? palpate::Material::rigid_N_per_m : stiffness,
      this->FrictionStatic->value(), this->FrictionKinetic->value());
  }
}
