// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSettingRows.h"

#include "haptics/session/settings/SessionSettings.h"
#include "pqHapticFields.h"
#include "pqHapticLink.h"
#include "pqHapticSourceChoice.h"
#include "vtkSMProxy.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSpinBox>

#include <string_view>

namespace
{
/// Digits of a stiffness, a force or a friction that a hand tells apart; lengths of the scene can be of any size.
int DecimalsOf(const palpate::Setting& setting)
{
  return setting.unit == "N/m" ? 1 : setting.unit == "N" || setting.unit == "1" ? 3 : 6;
}

struct Editor
{
  const char* Value;
  const char* Changed;
  QList<QWidget*> Widgets;
};

Editor NumberEditor(QFormLayout* form, const char* name, const char* property, const palpate::Setting& setting)
{
  Editor editor{ "value", SIGNAL(valueChanged(double)), {} };
  if (setting.defaults.size() == 1)
  {
    editor.Widgets << pqHapticNumberRow(form, name, property, DecimalsOf(setting));
    return editor;
  }
  for (QDoubleSpinBox* box : pqHapticVectorRow(form, name, property, DecimalsOf(setting)))
  {
    editor.Widgets << box;
  }
  return editor;
}

Editor TextEditor(QFormLayout* form, const char* name, const char* property)
{
  return std::string_view(property).ends_with("Source")
           ? Editor{ "source", SIGNAL(sourceChanged()), { pqHapticSourceRow(form, name, property) } }
           : Editor{ "text", SIGNAL(editingFinished()), { pqHapticTextRow(form, name, property) } };
}

Editor EditorOf(QFormLayout* form, const char* name, const char* property, const palpate::Setting& setting)
{
  switch (setting.kind)
  {
    case palpate::SettingKind::Flag:
      return { "checked", SIGNAL(toggled(bool)), { pqHapticSwitchRow(form, name, property) } };
    case palpate::SettingKind::Count:
      return { "value", SIGNAL(valueChanged(int)), { pqHapticCountRow(form, name, property) } };
    case palpate::SettingKind::Choice:
      return { "currentText", SIGNAL(currentTextChanged(const QString&)), { pqHapticChoiceRow(form, name, property) } };
    case palpate::SettingKind::Text:
      return TextEditor(form, name, property);
    default:
      return NumberEditor(form, name, property, setting);
  }
}
} // namespace

void pqHapticSettingRows::add(QFormLayout* form, const char* group)
{
  for (const palpate::Setting& setting : palpate::sessionSettings())
  {
    if (setting.at.group != group)
    {
      continue;
    }
    const std::string property(setting.name);
    std::string name = property;
    name.front() = QChar(name.front()).toLower().toLatin1();
    const Editor editor = EditorOf(form, name.c_str(), property.c_str(), setting);
    for (int element = 0; element < editor.Widgets.size(); ++element)
    {
      const int index = editor.Widgets.size() > 1 ? element : -1;
      this->Fields.push_back(
        { group, QString::fromStdString(property), index, editor.Value, editor.Changed, editor.Widgets[element] });
    }
  }
}

void pqHapticSettingRows::link(pqPropertyLinks& links, vtkSMProxy* proxy) const
{
  for (const Field& field : this->Fields)
  {
    const QByteArray name = field.Property.toUtf8();
    auto* const choices = qobject_cast<QComboBox*>(field.Widget);
    if (choices && !qobject_cast<pqHapticSourceChoice*>(choices))
    {
      pqHapticFill(choices, proxy->GetProperty(name));
    }
    pqHapticLink::add(links, field.Widget, field.Value, field.Changed, proxy, name, field.Element);
  }
}

QList<QWidget*> pqHapticSettingRows::fields(const char* group) const
{
  QList<QWidget*> widgets;
  for (const Field& field : this->Fields)
  {
    if (field.Group == group)
    {
      widgets << field.Widget;
    }
  }
  return widgets;
}
