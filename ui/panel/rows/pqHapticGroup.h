// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticGroup_h
#define pqHapticGroup_h

#include "pqHapticSettingRows.h"

#include <QGroupBox>
#include <QList>

class QFormLayout;
class QLabel;
class QPushButton;
class pqOutputPort;
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

  const char* Name;
  QFormLayout* Form;

private:
  pqHapticSettingRows Rows;
};

/// A group about a source that the hand holds or presses, named by a property of the session: a button takes the source
/// that is active in the pipeline browser, another one lets go of it.
class pqHapticSourceUse : public pqHapticGroup
{
  Q_OBJECT
  typedef pqHapticGroup Superclass;

public:
  QList<QWidget*> fields() const override;

protected:
  struct Button
  {
    const char* Name;
    QString Title, Tip;
  };
  pqHapticSourceUse(const QString& title, const char* name, const char* property, QWidget* parent);

  void addButtons(const Button& use, const Button& leave);
  void refreshButtons(vtkHapticSession* session, const char* source);
  virtual void use(pqOutputPort& port);

private:
  const char* Property;
  QPushButton *Use, *Leave;
};

#endif
