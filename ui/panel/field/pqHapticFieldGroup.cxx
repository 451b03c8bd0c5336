// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticFieldGroup.h"

#include "pqHapticArrayChoice.h"
#include "pqHapticController.h"
#include "pqHapticFields.h"
#include "pqHapticLabel.h"
#include "pqHapticLink.h"
#include "pqHapticViewFollower.h"
#include "pqPropertyLinks.h"
#include "vtkHapticSession.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <cmath>

namespace
{
QString AroundHand(vtkHapticSession& session)
{
  return pqHapticFieldGroup::tr("push %1 mW, age %2 s, %3 ticks outside")
    .arg(session.GetFieldPushPower(), 0, 'f', 2)
    .arg(session.GetFieldAge(), 0, 'f', 1)
    .arg(session.GetFieldTicksBeyond());
}
} // namespace

pqHapticFieldGroup::pqHapticFieldGroup(QWidget* parent) : Superclass(tr("Field"), "field", parent)
{
  this->add("FieldArray", 0);
  this->add("FieldVectors", 3);
  this->add("FieldResistance", 0);
  this->add("FieldOther", 0);
  this->addSettings();
  this->Value = pqHapticLabel(this, "fieldValue", tr("Value at the hand, and magnitude of its gradient [1/u]"));
  this->Around = pqHapticLabel(this, "fieldAround",
    tr("Power injected by Push [mW]; age of the sampled field around the hand [s]; ticks spent outside the sampled "
       "region"));
  this->Form->addRow(tr("At the hand"), this->Value);
  this->Form->addRow(tr("Around it"), this->Around);
  this->Sentence = this->addText("fieldText", tr("Sampled field: arrays, spacing and extent around the hand"));
  const QPushButton* const take = this->addButton("fieldTakeColours", tr("Take Range of Colour Map"),
    tr("Take ranges from the colour maps: isovalue (at half of the largest opacity), detent levels, and the data "
       "ranges of stiffness, friction and texture"));
  this->connect(take, &QPushButton::clicked, this, &pqHapticFieldGroup::takeColours);
  this->Taken = this->addText("fieldTaken", take->toolTip());
  pqHapticSay(this->Taken, QString());
}

void pqHapticFieldGroup::add(const char* property, int components)
{
  auto* list = new pqHapticArrayChoice(this);
  QString name = property;
  list->setObjectName(name.replace(0, 1, name.at(0).toLower()));
  list->setToolTip(pqHapticTip(property));
  this->Form->addRow(pqHapticTitle(property), list);
  this->Choices.push_back({ property, components, list });
}

void pqHapticFieldGroup::takeColours()
{
  if (this->Proxy)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->Proxy.Get());
    const QString said = pqHapticController::instance()->follower()->takeColorRange(this->Proxy);
    pqHapticSay(this->Taken, said.isEmpty() ? tr("No touchable source is coloured by") : said.trimmed());
  }
}

void pqHapticFieldGroup::link(pqPropertyLinks& links, vtkSMProxy* proxy)
{
  this->Proxy = proxy;
  for (const Choice& choice : this->Choices)
  {
    pqHapticLink::add(links, choice.List, "array", SIGNAL(arrayChanged()), proxy, choice.Property);
  }
  this->Superclass::link(links, proxy);
}

void pqHapticFieldGroup::refresh(vtkHapticSession* session)
{
  if (!this->isVisible())
  {
    return; // looking at all sources costs too much for a hidden page
  }
  for (const Choice& choice : this->Choices)
  {
    choice.List->setNames(pqHapticController::instance()->follower()->fieldNames(choice.Components));
  }
  const double value = session ? session->GetFieldValue() : NAN;
  const double* const gradient = session ? session->GetFieldGradient() : nullptr;
  this->Value->setText(std::isfinite(value) ? tr("%1, gradient %2 1/u")
                                                .arg(value, 0, 'g', 5)
                                                .arg(std::hypot(gradient[0], gradient[1], gradient[2]), 0, 'g', 3)
                                            : tr("-"));
  this->Around->setText(session && session->GetFieldAge() > 0.0 ? AroundHand(*session) : tr("-"));
  pqHapticSay(this->Sentence, session ? QString::fromUtf8(session->GetFieldText()) : QString());
}

QList<QWidget*> pqHapticFieldGroup::fields() const
{
  QList<QWidget*> lists;
  for (const Choice& choice : this->Choices)
  {
    lists.push_back(choice.List);
  }
  return lists + this->settings();
}
