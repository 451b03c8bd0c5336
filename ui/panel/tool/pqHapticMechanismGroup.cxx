// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMechanismGroup.h"

#include "pqHapticButton.h"
#include "pqHapticController.h"
#include "pqHapticLabel.h"
#include "pqHapticLink.h"
#include "pqHapticNamedSource.h"
#include "pqHapticSourceChoice.h"
#include "pqHapticStrip.h"
#include "vtkHapticSession.h"
#include "vtkHapticTouchedMechanism.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableWidget>

#include <cmath>

namespace
{
constexpr int ShownRows = 5; // the others are scrolled to
const QStringList Columns = { "Constraint", "Phase", "Force", "Inside" };
const QStringList Units = { "", "", " N", " u" };

/// "puncture: needle, wall; 1.5 N, drags 0.4 N".
QString KindOf(vtkTable& table, int row)
{
  const auto text = [&table, row](const char* column)
  { return QString::fromStdString(table.GetValueByName(row, column).ToString()); };
  const QString numbers = text("Numbers");
  return text("Kind") + ": " + text("A") + ", " + text("B") + (numbers.isEmpty() ? QString() : "; " + numbers);
}

vtkHapticSession* Session()
{
  return pqHapticController::instance()->session();
}

/// Constraints that could not be changed are none: the session has said why.
void SetConstraints(const std::string& laws)
{
  if (!laws.empty())
  {
    pqHapticNameSource("MechanismConstraints", QString::fromStdString(laws));
  }
}
} // namespace

pqHapticMechanismGroup::pqHapticMechanismGroup(QWidget* parent) : Superclass(tr("Mechanism"), "mechanism", parent)
{
  this->addSettings();
  this->connect(this->choiceOf("mechanismSource"), &pqHapticSourceChoice::chosen, this,
    [] { pqHapticNameSource("MechanismConstraints", {}); }); // those of another mechanism would not fit
  this->Text = this->addText("mechanismText", tr("State of the mechanism, or the reason why it cannot be touched"));
  this->makeTable();
  this->Form->addRow(this->Table);
  this->Chart = new pqHapticStrip(this, "mechanismChart", tr("Force over depth"), "N", 1.0);
  this->Chart->setToolTip(
    tr("Force on the hand over its displacement along the held body since the last tick without contact force"));
  this->Form->addRow(this->Chart);
  this->makeButtons();
  auto* changes = new QHBoxLayout;
  changes->addWidget(this->Remove, 1);
  changes->addWidget(this->Break, 1);
  changes->addWidget(this->Regrip, 1);
  changes->addWidget(this->PutBack, 1);
  this->Form->addRow(changes);
  auto* added = new QHBoxLayout;
  added->addWidget(this->Constraint, 1);
  added->addWidget(this->Add);
  this->Form->addRow(added);
}

void pqHapticMechanismGroup::makeTable()
{
  this->Table = new QTableWidget(0, static_cast<int>(Columns.size()), this);
  this->Table->setObjectName("mechanismTable");
  this->Table->setToolTip(tr("One row per constraint: phase, force on its first body, depth of the shaft"));
  this->Table->setHorizontalHeaderLabels(Columns);
  this->Table->verticalHeader()->hide();
  this->Table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->setTabKeyNavigation(false); // the Tab key leads on to the buttons
  this->Table->setMinimumWidth(1);
  this->Table->setFixedHeight((ShownRows + 1) * this->Table->verticalHeader()->defaultSectionSize());
}

void pqHapticMechanismGroup::makeButtons()
{
  this->Remove =
    pqHapticButton(this, "mechanismRemove", tr("Remove"), tr("Remove the chosen constraint from the mechanism"));
  this->Break = pqHapticButton(this, "mechanismBreak", tr("Break"),
    tr("Break the chosen constraint, until the mechanism is held or touched anew or gets other constraints"));
  this->PutBack = pqHapticButton(this, "mechanismPutBack", {}, {});
  this->Regrip = pqHapticButton(this, "mechanismRegrip", tr("Regrip"),
    tr("While this is pressed in, the sheath holds the wire and the hand goes back for the next stroke (Clutch; while "
       "Ctrl+Shift+C is held)"));
  this->Regrip->setCheckable(true);
  this->Constraint = new QLineEdit(this);
  this->Constraint->setObjectName("mechanismConstraint");
  this->Constraint->setPlaceholderText(tr("{ \"name\": ..., \"kind\": ..., \"a\": ..., \"b\": ... }"));
  this->Constraint->setToolTip(
    tr("Constraint in the format of a scene file; replaces the constraint of the same name"));
  this->Add = pqHapticButton(this, "mechanismAdd", tr("Add"), tr("Add this constraint to the mechanism"));
  this->connect(this->Add, &QPushButton::clicked, this, &pqHapticMechanismGroup::addConstraint);
  this->connect(this->Constraint, &QLineEdit::returnPressed, this, &pqHapticMechanismGroup::addConstraint);
  this->connect(this->Remove, &QPushButton::clicked, this, &pqHapticMechanismGroup::removeConstraint);
  this->connect(this->Break, &QPushButton::clicked, this, &pqHapticMechanismGroup::breakConstraint);
  this->connect(this->PutBack, &QPushButton::clicked, this, &pqHapticMechanismGroup::putBack);
}

void pqHapticMechanismGroup::link(pqPropertyLinks& links, vtkSMProxy* proxy)
{
  pqHapticLink::add(links, this->Regrip, "checked", SIGNAL(toggled(bool)), proxy, "Clutch");
  this->Superclass::link(links, proxy);
}

QString pqHapticMechanismGroup::selected() const
{
  const int row = this->Table->currentRow();
  return row >= 0 ? this->Table->item(row, 0)->text() : QString();
}

void pqHapticMechanismGroup::addConstraint()
{
  if (vtkHapticSession* const session = Session())
  {
    SetConstraints(session->GetMechanism()->GetConstraintsWith(this->Constraint->text().toUtf8().constData()));
  }
}

void pqHapticMechanismGroup::removeConstraint()
{
  if (vtkHapticSession* const session = Session())
  {
    SetConstraints(session->GetMechanism()->GetConstraintsWithout(this->selected().toUtf8().constData()));
  }
}

void pqHapticMechanismGroup::breakConstraint()
{
  if (vtkHapticSession* const session = Session())
  {
    session->GetMechanism()->BreakConstraint(this->selected().toUtf8().constData());
  }
}

void pqHapticMechanismGroup::putBack()
{
  if (vtkHapticSession* const session = Session())
  {
    session->GetMechanism()->PutBack();
  }
}

void pqHapticMechanismGroup::fill(vtkHapticSession& session)
{
  vtkNew<vtkTable> table;
  session.GetMechanism()->GetTable(table);
  const int rows = static_cast<int>(table->GetNumberOfRows());
  this->Table->setRowCount(rows);
  for (int row = 0; row < rows; ++row)
  {
    const QString kind = KindOf(*table, row);
    for (int column = 0; column < Columns.size(); ++column)
    {
      const vtkVariant value = table->GetValueByName(row, Columns[column].toUtf8().constData());
      const QString text = value.IsString() ? QString::fromStdString(value.ToString())
                                            : QString::number(value.ToDouble(), 'f', 3) + Units[column];
      if (!this->Table->item(row, column))
      {
        this->Table->setItem(row, column, new QTableWidgetItem);
      }
      this->Table->item(row, column)->setText(pqHapticInUnits(text));
      this->Table->item(row, column)->setToolTip(kind);
    }
  }
}

void pqHapticMechanismGroup::refresh(vtkHapticSession* session)
{
  const bool held = session && *session->GetSettingText("MechanismSource") != '\0';
  pqHapticSay(this->Text, session ? QString::fromUtf8(session->GetMechanismText()) : QString());
  if (session)
  {
    this->fill(*session);
  }
  if (held && session->GetTouching())
  {
    const double* const force = session->GetForce();
    this->Chart->addAt(std::hypot(force[0], force[1], force[2]), session->GetMechanismDepth());
  }
  else
  {
    this->Chart->clear();
  }
  this->showRows(held, held && session->GetMechanism()->GetIsWire());
  this->PutBack->setVisible(held || (session && *session->GetLooseText() != '\0'));
}

void pqHapticMechanismGroup::showRows(bool held, bool wire)
{
  const QList<QWidget*> ofConstraints{ this->Table, this->Constraint, this->Add, this->Remove, this->Break };
  for (QWidget* const widget : ofConstraints)
  {
    widget->setVisible(held && !wire);
  }
  this->Chart->setVisible(held);
  this->Regrip->setVisible(wire);
  this->PutBack->setText(wire ? tr("Pull Out") : tr("Put Back"));
  this->PutBack->setToolTip(
    wire ? tr("Pull the wire out of the vessel, back to the length with which it begins")
         : tr("Put all bodies back where the scene file has them, and loose sources where their data are; broken "
              "constraints are whole again"));
  for (QPushButton* const button : { this->Remove, this->Break })
  {
    button->setEnabled(held && !this->selected().isEmpty());
  }
}

QList<QWidget*> pqHapticMechanismGroup::fields() const
{
  return this->settings() + QList<QWidget*>{ this->Table, this->Remove, this->Break, this->Regrip, this->PutBack,
    this->Constraint, this->Add };
}
