// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticGroup_h
#define pqHapticGroup_h

#include "pqHapticSettingRows.h"

#include <QGroupBox>
#include <QList>

class QFormLayout;
class QLabel;
class QPushButton;
class pqHapticSourceChoice;
class pqPropertyLinks;
class vtkHapticSession;
class vtkSMProxy;

/// A group of the panel: a box with a title and rows, among them those of the settings that name the group.
class pqHapticGroup : public QGroupBox
{
  Q_OBJECT
  typedef QGroupBox Superclass;

public:
  ~pqHapticGroup() override;

  /// Links all that can be set here to the properties of a session.
  virtual void link(pqPropertyLinks& links, vtkSMProxy* proxy);
  /// Shows the state of the session; null without a session. Ten times a second.
  virtual void refresh(vtkHapticSession* /*session*/) {}
  /// In the order of the Tab key.
  virtual QList<QWidget*> fields() const = 0;

protected:
  /// `name` is that of the settings' group; the object is named by it and "Group".
  pqHapticGroup(const QString& title, const char* name, QWidget* parent);

  QPushButton* addButton(const char* name, const QString& title, const QString& tip);
  QLabel* addText(const char* name, const QString& tip);
  void addSettings();
  QList<QWidget*> settings() const;
  /// The list of sources of a setting of the group.
  pqHapticSourceChoice* choiceOf(const QString& setting) const;

  const char* Name;
  QFormLayout* Form;

private:
  pqHapticSettingRows Rows;
};

#endif
