// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMaterialGroup.h"

#include "pqHapticArrayChoice.h"
#include "pqHapticFields.h"
#include "pqHapticLabel.h"
#include "pqHapticLink.h"
#include "pqHapticQuantityBox.h"
#include "pqPropertyLinks.h"
#include "vtkHapticSession.h"
#include "vtkSMProxy.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>

namespace
{
constexpr int largestComponent = 99;
constexpr int dataDecimals = 6;

/// Two of them stand in a row.
pqHapticQuantityBox* NumberBox(QWidget* parent, const QString& name, const QString& property, int decimals)
{
  constexpr int leastWidth = 60; // [pixels]
  pqHapticQuantityBox* box = pqHapticNumber(parent, name, property, decimals);
  box->setMinimumWidth(leastWidth);
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return box;
}

/// A row of two fields; the mnemonic of its title leads to the first.
void AddPair(QFormLayout* form, const QString& title, QWidget* left, QWidget* right)
{
  auto* label = new QLabel(title, form->parentWidget());
  label->setBuddy(left);
  auto* row = new QHBoxLayout;
  row->addWidget(left, 1);
  row->addWidget(right, 1);
  form->addRow(label, row);
}
} // namespace

pqHapticMaterialGroup::pqHapticMaterialGroup(QWidget* parent) : Superclass(tr("Material from data"), "material", parent)
{
  this->add({ "Stiffness", "stiffness", 1 });
  this->add({ "Friction", "friction", 3 });
  this->add({ "Texture", "texture", 6 });
  this->Cut = this->addText("materialText", pqHapticReadoutTip("MaterialText"));
}

void pqHapticMaterialGroup::refresh(vtkHapticSession* session)
{
  QString text = session ? QString::fromUtf8(session->GetMaterialText()) : QString();
  text.replace(0, 1, text.left(1).toUpper());
  pqHapticSay(this->Cut, text.isEmpty() ? text : text + ".");
  this->followChoices();
}

void pqHapticMaterialGroup::add(const Looks& looks)
{
  const QString name = looks.Name;
  Transfer transfer{};
  transfer.Property = looks.Property;
  transfer.Array = new pqHapticArrayChoice(this);
  transfer.Array->setObjectName(name + "Array");
  const QString array = QString(looks.Property) + "Array";
  transfer.Array->setToolTip(pqHapticTip(array));
  this->Form->addRow(pqHapticTitle(array), transfer.Array);
  auto* details = new QWidget(this); // only used arrays take space
  details->setObjectName(name + "Details");
  this->addDetails(details, looks, transfer);
  this->Form->addRow(details);
  transfer.Details = details;
  this->connect(transfer.Array, &pqHapticArrayChoice::arrayChanged, this, &pqHapticMaterialGroup::followChoices);
  this->Transfers.push_back(transfer);
  this->followChoices();
}

void pqHapticMaterialGroup::followChoices()
{
  for (const Transfer& transfer : this->Transfers)
  {
    transfer.Details->setVisible(!transfer.Array->array().isEmpty());
  }
}

void pqHapticMaterialGroup::addDetails(QWidget* parent, const Looks& looks, Transfer& transfer)
{
  const QString name = looks.Name, component = QString(looks.Property) + "Component",
                data = QString(looks.Property) + "DataRange", felt = QString(looks.Property) + "FeltRange";
  transfer.Component = new QSpinBox(parent);
  transfer.Component->setObjectName(name + "Component");
  transfer.Component->setRange(-1, largestComponent);
  transfer.Component->setSpecialValueText(tr("length"));
  transfer.Component->setKeyboardTracking(false);
  transfer.Component->setToolTip(pqHapticTip(component));
  const char* const ends[] = { "Low", "High" };
  for (int end = 0; end < 2; ++end)
  {
    transfer.Data[end] = NumberBox(parent, name + "Data" + ends[end], data, dataDecimals);
    transfer.Felt[end] = NumberBox(parent, name + "Felt" + ends[end], felt, looks.Decimals);
  }
  const auto follow = [low = transfer.Data[0], high = transfer.Data[1]]
  {
    const bool own = low->value() == high->value(); // the array's own range
    low->setAutomatic(own);
    high->setAutomatic(own);
  };
  for (pqHapticQuantityBox* end : transfer.Data)
  {
    this->connect(end, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, follow);
  }
  follow();
  auto* form = new QFormLayout(parent);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(pqHapticTitle(component), transfer.Component);
  AddPair(form, pqHapticTitle(data), transfer.Data[0], transfer.Data[1]);
  AddPair(form, pqHapticTitle(felt), transfer.Felt[0], transfer.Felt[1]);
}

void pqHapticMaterialGroup::link(pqPropertyLinks& links, vtkSMProxy* proxy)
{
  for (const Transfer& transfer : this->Transfers)
  {
    const auto link = [&](QObject* widget, const char* what, const char* signal, const char* name, int index)
    {
      const QByteArray property = QByteArray(transfer.Property) + name;
      pqHapticLink::add(links, widget, what, signal, proxy, property, index);
    };
    link(transfer.Array, "array", SIGNAL(arrayChanged()), "Array", -1);
    link(transfer.Component, "value", SIGNAL(valueChanged(int)), "Component", -1);
    for (int end = 0; end < 2; ++end)
    {
      link(transfer.Data[end], "value", SIGNAL(valueChanged(double)), "DataRange", end);
      link(transfer.Felt[end], "value", SIGNAL(valueChanged(double)), "FeltRange", end);
    }
  }
}

void pqHapticMaterialGroup::setArrayNames(const QStringList& names)
{
  for (const Transfer& transfer : this->Transfers)
  {
    transfer.Array->setNames(names);
  }
}

QList<QWidget*> pqHapticMaterialGroup::fields() const
{
  QList<QWidget*> fields;
  for (const Transfer& transfer : this->Transfers)
  {
    fields << transfer.Array << transfer.Component << transfer.Data[0] << transfer.Data[1] << transfer.Felt[0]
           << transfer.Felt[1];
  }
  return fields;
}
