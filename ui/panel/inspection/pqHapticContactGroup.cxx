// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticContactGroup.h"

#include "pqHapticFields.h"
#include "pqHapticLabel.h"
#include "pqHapticUnits.h"
#include "vtkHapticSession.h"

#include <QFormLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace
{
QString Shown(double value)
{
  return QString::number(value, 'g', 6);
}

QString Vector(const double v[3])
{
  constexpr double rounding = 1e-9; // of the longest component: less is an error of rounding, not a place
  const double longest = std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
  const auto shown = [&](double x) { return Shown(std::abs(x) < rounding * longest ? 0.0 : x); };
  return QString("(%1, %2, %3)").arg(shown(v[0]), shown(v[1]), shown(v[2]));
}

/// `unknown`: the text for NaN.
QString Quantity(double value, const QString& unit, const QString& unknown)
{
  return std::isnan(value) ? unknown : Shown(value) + " " + unit;
}

/// "3 and 2 1/u": the unit once.
QString CurvatureOf(vtkHapticSession& session)
{
  const double* const curvature_per_u = session.GetContactCurvature();
  const QString least = Quantity(curvature_per_u[1], pqHapticUnitIn("1/u"), "not known");
  return std::isnan(curvature_per_u[0]) ? least : Shown(curvature_per_u[0]) + " and " + least;
}
} // namespace

pqHapticContactGroup::pqHapticContactGroup(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("contactPlace");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  this->When = pqHapticLabel(this, "contactWhen",
    tr("Data at the contact while a surface is touched, then at the last "
       "contact"));
  this->Found = new QWidget(this);
  this->Found->setObjectName("contactFound");
  column->addWidget(this->When);
  column->addWidget(this->Found);
  auto* form = new QFormLayout(this->Found);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  this->Source = this->add(form, "contactSource", tr("Source"), pqHapticReadoutTip("ContactSource"));
  this->Ids = this->add(form, "contactIds", tr("Cell, point"),
    tr("Numbers of the cell at the contact, and of its point with the largest weight"));
  this->Position = this->add(form, "contactPosition", tr("Position"), pqHapticReadoutTip("ContactPosition"));
  this->Normal = this->add(form, "contactNormal", tr("Normal"), pqHapticReadoutTip("ContactNormal"));
  this->Depth = this->add(form, "contactDepth", tr("Depth"), pqHapticReadoutTip("Depth"));
  this->Curvature = this->add(form, "contactCurvature", tr("Curvature"), pqHapticReadoutTip("ContactCurvature"));
  this->Thickness = this->add(form, "contactThickness", tr("Wall"), pqHapticReadoutTip("ContactThickness"));
  this->Arrays = this->add(form, "contactArrays", tr("Arrays"), pqHapticReadoutTip("ContactArrays"));
  this->refresh(nullptr);
}

QLabel* pqHapticContactGroup::add(QFormLayout* form, const char* name, const QString& title, const QString& tip)
{
  QLabel* const label = pqHapticLabel(this->Found, name, tip);
  form->addRow(title, label);
  return label;
}

void pqHapticContactGroup::refresh(vtkHapticSession* session)
{
  const bool found = session && this->isVisible() && session->InspectContact();
  if (found)
  {
    this->showContact(*session);
  }
  this->Found->setVisible(found);
  this->When->setText(!found                       ? tr("No contact in this scene yet.")
                      : session->GetContactIsNow() ? tr("Contact now:")
                                                   : tr("Last contact:"));
}

void pqHapticContactGroup::showContact(vtkHapticSession& session)
{
  this->Source->setText(QString::fromUtf8(session.GetContactSource()));
  this->Ids->setText(QString("%1, %2").arg(session.GetContactCell()).arg(session.GetContactPoint()));
  this->Position->setText(pqHapticInUnits(Vector(session.GetContactPosition()) + " u"));
  this->Normal->setText(Vector(session.GetContactNormal()));
  this->Depth->setText(pqHapticInUnits(Quantity(session.GetDepth(), "u", QString())));
  this->Curvature->setText(CurvatureOf(session));
  this->Thickness->setText(pqHapticInUnits(Quantity(session.GetContactThickness(), "u", tr("no far wall"))));
  const QString arrays = QString::fromUtf8(session.GetContactArrays()).trimmed();
  this->Arrays->setText(arrays.isEmpty() ? tr("none") : arrays);
}
