// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticFieldGroup.h"

#include "pqHapticArrayChoice.h"
#include "pqHapticFields.h"
#include "pqHapticLabel.h"
#include "pqHapticSettingRows.h"
#include "pqHapticViewFollower.h"
#include "vtkHapticSession.h"
#include "vtkSMProxy.h"

#include <QFormLayout>
#include <QLabel>

#include <cmath>

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
  form->addRow(tr("At the hand"), this->Value);
  form->addRow(this->Sentence);
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

void pqHapticFieldGroup::setProxy(vtkSMProxy* proxy)
{
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
