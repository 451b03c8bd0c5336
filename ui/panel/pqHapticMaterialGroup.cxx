// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMaterialGroup.h"

#include "pqHapticArrayChoice.h"
#include "pqHapticNumber.h"
#include "vtkSMProxy.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>

namespace
{
constexpr int largestComponent = 99;
constexpr double anything = 1e100;
constexpr int dataDecimals = 6;

/// Two of them stand in a row.
QDoubleSpinBox* Number(QWidget* parent, const QString& name, double low, double high, int decimals, const QString& tip)
{
  constexpr int leastWidth = 60; // [pixels]
  QDoubleSpinBox* box = pqHapticNumber(parent, name, low, high, decimals, tip);
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

pqHapticMaterialGroup::pqHapticMaterialGroup(QWidget* parent) : Superclass(tr("Material from data"), parent)
{
  this->setObjectName("materialGroup");
  auto* form = new QFormLayout(this);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  this->add(
    form, { "Stiffness", "stiffness", tr("Stiffn&ess from"),
            tr("Stiffness that is felt at that value [N/m]; never more than the spring's"), tr("N/m"), 0.0, 1e6, 1 });
  this->add(form, { "Friction", "friction", tr("Friction from (&-)"),
                    tr("Friction that is felt at that value [1], at rest and sliding"), QStringLiteral("1"), 0.0,
                    pqHapticLargestFriction, 3 });
  this->add(form, { "Texture", "texture", tr("Te&xture from"),
                    tr("Height felt at that value [scene units]: the highest place is the surface itself, lower ones "
                       "are hollows in it; its mean when the hand is too fast for it"),
                    tr("u"), -1e9, 1e9, 6 });
}

void pqHapticMaterialGroup::add(QFormLayout* form, const Looks& looks)
{
  const QString name = looks.Name;
  Transfer transfer{};
  transfer.Property = looks.Property;
  transfer.Array = new pqHapticArrayChoice(this);
  transfer.Array->setObjectName(name + "Array");
  transfer.Array->setToolTip(tr("Array of points or cells of what is shown; surfaces without it keep their own"));
  form->addRow(looks.Title, transfer.Array);
  auto* details = new QWidget(this); // only what is used takes room
  details->setObjectName(name + "Details");
  this->addDetails(details, looks, transfer);
  form->addRow(details);
  const auto show = [details, array = transfer.Array] { details->setVisible(!array->array().isEmpty()); };
  this->connect(transfer.Array, &pqHapticArrayChoice::arrayChanged, this, show);
  show();
  this->Transfers.push_back(transfer);
}

void pqHapticMaterialGroup::addDetails(QWidget* parent, const Looks& looks, Transfer& transfer)
{
  const QString name = looks.Name;
  transfer.Component = new QSpinBox(parent);
  transfer.Component->setObjectName(name + "Component");
  transfer.Component->setRange(-1, largestComponent);
  transfer.Component->setSpecialValueText(tr("length"));
  transfer.Component->setKeyboardTracking(false);
  transfer.Component->setToolTip(tr("Component of the array, from 0 on, or the length of a vector"));
  const QString dataTip = tr("Value of the array at this end; both ends equal: the whole range of the array");
  const char* const ends[] = { "Low", "High" };
  for (int end = 0; end < 2; ++end)
  {
    transfer.Data[end] = Number(parent, name + "Data" + ends[end], -anything, anything, dataDecimals, dataTip);
    transfer.Felt[end] =
      Number(parent, name + "Felt" + ends[end], looks.Least, looks.Most, looks.Decimals, looks.FeltTip);
  }
  auto* form = new QFormLayout(parent);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  const int before = 3 * static_cast<int>(this->Transfers.size()); // digits: the panel has used up the letters
  form->addRow(tr("Component (&%1)").arg(before + 1), transfer.Component);
  AddPair(form, tr("Data range (&%1)").arg(before + 2), transfer.Data[0], transfer.Data[1]);
  AddPair(form, tr("Feels like [%1] (&%2)").arg(looks.Unit).arg(before + 3), transfer.Felt[0], transfer.Felt[1]);
}

void pqHapticMaterialGroup::setProxy(vtkSMProxy* proxy)
{
  this->Links.clear();
  for (const Transfer& transfer : this->Transfers)
  {
    if (proxy)
    {
      this->link(transfer, proxy);
    }
  }
}

void pqHapticMaterialGroup::link(const Transfer& transfer, vtkSMProxy* proxy)
{
  const auto link = [&](QObject* widget, const char* what, const char* signal, const char* name, int index)
  {
    const QByteArray property = QByteArray(transfer.Property) + name;
    this->Links.addTraceablePropertyLink(widget, what, signal, proxy, proxy->GetProperty(property), index);
  };
  link(transfer.Array, "array", SIGNAL(arrayChanged()), "Array", -1);
  link(transfer.Component, "value", SIGNAL(valueChanged(int)), "Component", -1);
  for (int end = 0; end < 2; ++end)
  {
    link(transfer.Data[end], "value", SIGNAL(valueChanged(double)), "DataRange", end);
    link(transfer.Felt[end], "value", SIGNAL(valueChanged(double)), "FeltRange", end);
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
