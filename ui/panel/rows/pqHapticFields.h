// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticFields_h
#define pqHapticFields_h

#include <QList>
#include <QString>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;
class QWidget;
class pqHapticQuantityBox;
class pqHapticSourceChoice;
class vtkSMProperty;

/// Fields of the panel for settings as haptics/session/settings/ describes them: range, unit beside the number, and a
/// tip that explains it. `name` is the field's own, `property` the setting's. Numbers take effect once they are
/// typed.

/// A number without a row of its own. Lengths of the scene and values of data can be of any size.
pqHapticQuantityBox* pqHapticNumber(QWidget* parent, const QString& name, const QString& property, int decimals);

/// Has the fields of a panel show the unit of the scene's lengths that holds from now on.
void pqHapticFollowUnit(const QWidget& panel);

/// A row with a number and its unit.
QDoubleSpinBox* pqHapticNumberRow(QFormLayout* form, const char* name, const char* property, int decimals);
/// A row with the three numbers of a vector, named name_x, name_y and name_z, and their unit.
QList<QDoubleSpinBox*> pqHapticVectorRow(QFormLayout* form, const char* name, const char* property, int decimals);
/// A text, which takes effect once it is typed.
QLineEdit* pqHapticTextRow(QFormLayout* form, const char* name, const char* property);
/// A source of the pipeline, by its name.
pqHapticSourceChoice* pqHapticSourceRow(QFormLayout* form, const char* name, const char* property);
QSpinBox* pqHapticCountRow(QFormLayout* form, const char* name, const char* property);
QCheckBox* pqHapticSwitchRow(QFormLayout* form, const char* name, const char* property);
/// The proxy's domain has its choices: pqHapticFill().
QComboBox* pqHapticChoiceRow(QFormLayout* form, const char* name, const char* property);
void pqHapticFill(QComboBox* box, vtkSMProperty* property);

/// The title of a setting's row, with the mark of its letter, and the help text of the setting.
QString pqHapticTitle(const QString& property);
QString pqHapticTip(const QString& property);
/// The property that a field is for, which the search finds; "": it names none.
void pqHapticSetProperty(QWidget* field, const QString& property);
QString pqHapticProperty(const QWidget& field);
/// The value of a read-out.
QString pqHapticReadoutTip(const QString& property);

#endif
