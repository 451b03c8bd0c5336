// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticFields.h"

#include "haptics/session/settings/SessionSettings.h"
#include "pqHapticQuantityBox.h"
#include "pqHapticSourceChoice.h"
#include "pqHapticUnits.h"
#include "pqSMAdaptor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
/// Larger quantities do not occur; values of arrays have no unit, and can be anything.
constexpr double largestQuantity = 1e9, largestValue = 1e100;

/// Else the widest number a field could hold makes the whole panel wide [pixels].
constexpr int leastFieldWidth = 90;

/// Three numbers are no wider than one [pixels].
constexpr int leastShare = 30;

/// Of the table of settings, where it stays.
const palpate::Setting* Described(const QString& property)
{
  return &palpate::sessionSetting(property.toStdString());
}

QString Text(std::string_view utf8)
{
  return QString::fromUtf8(utf8.data(), static_cast<int>(utf8.size()));
}

/// A length of the hand is stored in m and shown in mm.
bool IsOfHand(const palpate::Setting& setting)
{
  return setting.unit == "m";
}

/// The friction of 1 has none.
QString SuffixOf(const palpate::Setting& setting)
{
  return IsOfHand(setting)                             ? QObject::tr(" mm")
         : setting.unit.empty() || setting.unit == "1" ? QString()
                                                       : " " + pqHapticUnitIn(Text(setting.unit));
}

/// The property of Qt that has the name of a field's setting.
constexpr const char* settingOf = "hapticSetting";

template<typename Field>
Field* Named(Field* field, const QString& name, const QString& property)
{
  field->setObjectName(name);
  field->setToolTip(pqHapticTip(property));
  pqHapticSetProperty(field, property);
  return field;
}

/// The meaning of the least value where it is no quantity; "": it is one.
QString LeastOf(const QString& property)
{
  static const QMap<QString, QString> meanings = { { "FieldSmoothing", QObject::tr("automatic") },
    { "ToolLever", QObject::tr("automatic") }, { "FieldFullSpeed", QObject::tr("any length") },
    { "PrecisionButton", QObject::tr("none") }, { "ClutchButton", QObject::tr("none") } };
  return meanings.value(property);
}
} // namespace

QString pqHapticTitle(const QString& property)
{
  return Text(Described(property)->title);
}

QString pqHapticTip(const QString& property)
{
  return Text(Described(property)->sentence);
}

void pqHapticSetProperty(QWidget* field, const QString& property)
{
  field->setProperty(settingOf, property);
}

QString pqHapticProperty(const QWidget& field)
{
  return field.property(settingOf).toString();
}

QString pqHapticReadoutTip(const QString& property)
{
  const std::string name = property.toStdString();
  const auto all = palpate::sessionReadouts();
  const auto named = [&name](const palpate::Readout& readout) { return readout.name == name; };
  const auto found = std::find_if(all.begin(), all.end(), named);
  return found == all.end() ? QString() : Text(found->sentence);
}

pqHapticQuantityBox* pqHapticNumber(QWidget* parent, const QString& name, const QString& property, int decimals)
{
  const palpate::Setting& setting = *Described(property);
  const bool ofScene = setting.unit == "u" || setting.unit == "u/m" || setting.unit.empty();
  pqHapticQuantityBox* const box =
    Named(ofScene ? new pqHapticQuantityBox(parent) : new pqHapticQuantityBox(decimals, parent), name, property);
  box->setSuffix(SuffixOf(setting));
  box->setFactor(IsOfHand(setting) ? 1e3 : 1.0);
  box->setSpecialValueText(LeastOf(property));
  const double widest = setting.unit.empty() ? largestValue : largestQuantity;
  const double smallest = ofScene ? std::numeric_limits<double>::min() : std::pow(10.0, -decimals);
  const double least = setting.low + (setting.above ? smallest : 0.0);
  box->setRange(std::max(least, -widest), std::min(setting.high, widest));
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setKeyboardTracking(false);
  box->setMinimumWidth(leastFieldWidth);
  return box;
}

void pqHapticFollowUnit(const QWidget& panel)
{
  for (pqHapticQuantityBox* const box : panel.findChildren<pqHapticQuantityBox*>())
  {
    if (const QString property = pqHapticProperty(*box); !property.isEmpty())
    {
      box->setSuffix(SuffixOf(*Described(property)));
    }
  }
}

QDoubleSpinBox* pqHapticNumberRow(QFormLayout* form, const char* name, const char* property, int decimals)
{
  QDoubleSpinBox* box = pqHapticNumber(form->parentWidget(), name, property, decimals);
  form->addRow(pqHapticTitle(property), box);
  return box;
}

QList<QDoubleSpinBox*> pqHapticVectorRow(QFormLayout* form, const char* name, const char* property, int decimals)
{
  auto* row = new QHBoxLayout;
  QList<QDoubleSpinBox*> boxes;
  for (const char* const axis : { "_x", "_y", "_z" })
  {
    boxes << pqHapticNumber(form->parentWidget(), QString(name) + axis, property, decimals);
    boxes.back()->setMinimumWidth(leastShare);
    boxes.back()->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // the row is no wider than the others
    row->addWidget(boxes.back());
  }
  auto* title = new QLabel(pqHapticTitle(property), form->parentWidget());
  title->setBuddy(boxes.front());
  form->addRow(title, row);
  return boxes;
}

QSpinBox* pqHapticCountRow(QFormLayout* form, const char* name, const char* property)
{
  const palpate::Setting& setting = *Described(property);
  auto* box = Named(new QSpinBox(form->parentWidget()), name, property);
  box->setRange(static_cast<int>(setting.low), static_cast<int>(std::min(setting.high, largestQuantity)));
  box->setSuffix(SuffixOf(setting));
  box->setSpecialValueText(LeastOf(property));
  box->setKeyboardTracking(false);
  box->setMinimumWidth(leastFieldWidth);
  form->addRow(pqHapticTitle(property), box);
  return box;
}

QCheckBox* pqHapticSwitchRow(QFormLayout* form, const char* name, const char* property)
{
  auto* box = Named(new QCheckBox(pqHapticTitle(property), form->parentWidget()), name, property);
  form->addRow(box);
  return box;
}

QLineEdit* pqHapticTextRow(QFormLayout* form, const char* name, const char* property)
{
  auto* line = Named(new QLineEdit(form->parentWidget()), name, property);
  form->addRow(pqHapticTitle(property), line);
  return line;
}

pqHapticSourceChoice* pqHapticSourceRow(QFormLayout* form, const char* name, const char* property)
{
  auto* list = Named(new pqHapticSourceChoice(form->parentWidget(), property), name, property);
  form->addRow(pqHapticTitle(property), list);
  return list;
}

QComboBox* pqHapticChoiceRow(QFormLayout* form, const char* name, const char* property)
{
  auto* box = Named(new QComboBox(form->parentWidget()), name, property);
  form->addRow(pqHapticTitle(property), box);
  return box;
}

void pqHapticFill(QComboBox* box, vtkSMProperty* property)
{
  box->clear();
  for (const QVariant& entry : pqSMAdaptor::getEnumerationPropertyDomain(property))
  {
    box->addItem(entry.toString());
  }
}
