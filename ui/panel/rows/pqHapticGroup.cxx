// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticGroup.h"

#include "pqActiveObjects.h"
#include "pqHapticButton.h"
#include "pqHapticLabel.h"
#include "pqHapticNamedSource.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"

#include <QFormLayout>
#include <QHBoxLayout>

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

pqHapticSourceUse::pqHapticSourceUse(const QString& title, const char* name, const char* property, QWidget* parent)
  : Superclass(title, name, parent), Property(property)
{
}

void pqHapticSourceUse::addButtons(const Button& use, const Button& leave)
{
  auto* buttons = new QHBoxLayout;
  this->Form->addRow(buttons);
  this->Use = pqHapticButton(buttons, use.Name, use.Title, use.Tip);
  this->Leave = pqHapticButton(buttons, leave.Name, leave.Title, leave.Tip);
  const auto useActive = [this]
  {
    if (pqOutputPort* const port = pqActiveObjects::instance().activePort())
    {
      this->use(*port);
    }
  };
  this->connect(this->Use, &QPushButton::clicked, this, useActive);
  this->connect(this->Leave, &QPushButton::clicked, this, [this] { pqHapticNameSource(this->Property, {}); });
}

void pqHapticSourceUse::use(pqOutputPort& port)
{
  pqHapticNameSource(this->Property, port.getSource()->getSMName());
}

void pqHapticSourceUse::refreshButtons(vtkHapticSession* session, const char* source)
{
  this->Use->setEnabled(session && pqActiveObjects::instance().activePort());
  this->Leave->setEnabled(session && *source != '\0');
}

QList<QWidget*> pqHapticSourceUse::fields() const
{
  return QList<QWidget*>{ this->Use, this->Leave };
}
