// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSettingRows_h
#define pqHapticSettingRows_h

#include <QList>
#include <QString>

class QFormLayout;
class QWidget;
class pqPropertyLinks;
class vtkSMProxy;

/// The rows of settings that name a group of the panel (haptics/session/settings/), in the order of the table: each a
/// field by its kind, named like its property with a small first letter.
class pqHapticSettingRows
{
public:
  void add(QFormLayout* form, const char* group);
  void link(pqPropertyLinks& links, vtkSMProxy* proxy) const;
  /// From top to bottom.
  QList<QWidget*> fields(const char* group) const;

private:
  struct Field
  {
    QString Group;
    QString Property;
    int Element;       ///< of the property; -1: all of it
    const char* Value; ///< Qt's property of the widget, and the signal that it changed
    const char* Changed;
    QWidget* Widget;
  };
  QList<Field> Fields;
};

#endif
