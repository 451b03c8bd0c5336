// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticDeviceRows_h
#define pqHapticDeviceRows_h

#include <QList>
#include <QObject>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QWidget;
class vtkHapticSession;
class vtkSMProxy;

/// Rows of the panel about the chosen device: its kind and missing functions, whether it is a wheel, how its link goes,
/// the step that it waits for, and its dead-man switch.
class pqHapticDeviceRows : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticDeviceRows(QFormLayout* form);

  void setProxy(vtkSMProxy* proxy) { this->Proxy = proxy; }
  /// The state of the session; null: none.
  void refresh(vtkHapticSession* session);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  void choose(int row);
  void sayWheel(bool on);
  QString askForFile() const;
  void prepare();

  vtkSMProxy* Proxy = nullptr;
  QLabel* Notes;
  QCheckBox* Wheel;
  QComboBox* DeadMan;
  QLabel* Link;
  QPushButton* Step;
};

#endif
