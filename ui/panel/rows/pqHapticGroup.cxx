// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticGroup.h"

#include "pqHapticButton.h"
#include "pqHapticLabel.h"
#include "pqHapticSourceChoice.h"

#include <QFormLayout>

pqHapticGroup::pqHapticGroup(const QString& title, const char* name, QWidget* parent)
  : Superclass(title, parent), Name(name), Form(new QFormLayout(this))
{
  this->setObjectName(QString(name) + "Group");
  this->Form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

pqHapticGroup::~pqHapticGroup() = default;

QPushButton* pqHapticGroup::addButton(const char* name, const QString& title, const QString& tip)
{
  QPushButton* const button = pqHapticButton(this, name, title, tip);
  this->Form->addRow(button);
  return button;
}

QLabel* pqHapticGroup::addText(const char* name, const QString& tip)
{
  QLabel* const label = pqHapticLabel(this, name, tip);
  this->Form->addRow(label);
  return label;
}

void pqHapticGroup::addSettings()
{
  this->Rows.add(this->Form, this->Name);
}

QList<QWidget*> pqHapticGroup::settings() const
{
  return this->Rows.fields(this->Name);
}

void pqHapticGroup::link(pqPropertyLinks& links, vtkSMProxy* proxy)
{
  this->Rows.link(links, proxy);
}

pqHapticSourceChoice* pqHapticGroup::choiceOf(const QString& setting) const
{
  return this->findChild<pqHapticSourceChoice*>(setting);
}
