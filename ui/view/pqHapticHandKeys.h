// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticHandKeys_h
#define pqHapticHandKeys_h

#include <QObject>

#include "vtkSmartPointer.h"

class vtkSMProxy;

/**
 * Keys that hold the hand wherever the keyboard's focus is: the clutch while Ctrl+Shift+C is down, precision while
 * Ctrl+Shift+P is. GUI thread only.
 */
class pqHapticHandKeys : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticHandKeys(QObject* parent);
  ~pqHapticHandKeys() override;

  void setProxy(vtkSMProxy* proxy);
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  /// Property of the pressed key; null: none.
  void hold(const char* property);
  void letGo();

  vtkSmartPointer<vtkSMProxy> Proxy;
  const char* Held = nullptr;
};

#endif
