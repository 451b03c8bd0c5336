// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticFieldGroup.h"

#include "pqHapticArrayChoice.h"
#include "pqHapticFields.h"
#include "pqHapticLabel.h"
#include "pqHapticSettingRows.h"
#include "pqHapticViewFollower.h"
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
  return pqHapticFieldGroup::tr("push %1 mW, %2 s old, %3 ticks beyond")
    .arg(session.GetFieldPushPower(), 0, 'f', 2)
    .arg(session.GetFieldAge(), 0, 'f', 1)
    .arg(session.GetFieldTicksBeyond());
}
} // namespace

pqHapticFieldGroup::pqHapticFieldGroup(pqHapticSettingRows& rows, QWidget* parent) : Superclass(tr("Field"), parent)
{
  this->setObjectName("fieldGroup");
  auto* form = new QFormLayout(this);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  this->add(form, "FieldArray", 0);
  this->add(form, "FieldVectors", 3);
  this->add(form, "FieldResistance", 0);
  this->add(form, "FieldOther", 0);
  rows.add(form, "field");
  this->Value =
    pqHapticLabel(this, "fieldValue", tr("The value at the hand, and how much it changes there a unit [1/u]"));
  this->Sentence =
    pqHapticLabel(this, "fieldSentence", tr("What is felt as a field, how finely and how far around the hand"));
  this->Around = pqHapticLabel(this, "fieldAround",
    tr("Power of the push [mW]; how old the numbers around the hand are [s]; ticks in which the hand was beyond them"));
  form->addRow(tr("At the hand"), this->Value);
  form->addRow(tr("Around it"), this->Around);
  form->addRow(this->Sentence);
  auto* take = new QPushButton(tr("Take Range of Colour Map"), this);
  take->setObjectName("fieldTakeColours");
  take->setToolTip(
    tr("What the colour maps show low and high feels low and high: isovalue, where half as opaque as any, "
       "and levels of the values, data ranges of stiffness, friction and texture"));
  this->connect(take, &QPushButton::clicked, this, &pqHapticFieldGroup::takeColours);
  form->addRow(take);
  this->Taken = pqHapticLabel(this, "fieldTaken", take->toolTip());
  form->addRow(this->Taken);
  pqHapticSay(this->Taken, QString());
}

void pqHapticFieldGroup::add(QFormLayout* form, const char* property, int components)
{
  auto* list = new pqHapticArrayChoice(this);
  QString name = property;
  list->setObjectName(name.replace(0, 1, name.at(0).toLower()));
  list->setToolTip(pqHapticTip(property));
  form->addRow(pqHapticTitle(property), list);
  this->Choices.push_back({ property, components, list });
}

void pqHapticFieldGroup::takeColours()
{
  if (this->Follower && this->Proxy)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->Proxy.Get());
    const QString said = this->Follower->takeColorRange(this->Proxy);
    pqHapticSay(this->Taken, said.isEmpty() ? tr("Nothing that is felt is coloured by") : said.trimmed());
  }
}

void pqHapticFieldGroup::setProxy(vtkSMProxy* proxy)
{
  this->Proxy = proxy;
  this->Links.clear();
  for (const Choice& choice : this->Choices)
  {
    if (proxy)
    {
      this->Links.addTraceablePropertyLink(
        choice.List, "array", SIGNAL(arrayChanged()), proxy, proxy->GetProperty(choice.Property));
    }
  }
}

void pqHapticFieldGroup::refresh(vtkHapticSession* session, const pqHapticViewFollower& follower)
{
  this->Follower = &follower;
  if (!this->isVisible())
  {
    return; // looking at all sources costs too much for what nobody sees
  }
  for (const Choice& choice : this->Choices)
  {
    choice.List->setNames(follower.fieldNames(choice.Components));
  }
  const double value = session ? session->GetFieldValue() : NAN;
  const double* const gradient = session ? session->GetFieldGradient() : nullptr;
  this->Value->setText(std::isfinite(value) ? tr("%1, changes by %2 1/u")
                                                .arg(value, 0, 'g', 5)
                                                .arg(std::hypot(gradient[0], gradient[1], gradient[2]), 0, 'g', 3)
                                            : tr("-"));
  this->Around->setText(session && session->GetFieldAge() > 0.0 ? AroundHand(*session) : tr("-"));
  pqHapticSay(this->Sentence, session ? QString::fromUtf8(session->GetFieldSentence()) : QString());
}

QList<QWidget*> pqHapticFieldGroup::fields() const
{
  QList<QWidget*> lists;
  for (const Choice& choice : this->Choices)
  {
    lists.push_back(choice.List);
  }
  return lists;
}
