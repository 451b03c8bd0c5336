// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticDeviceChoice_h
#define pqHapticDeviceChoice_h

#include <QComboBox>

#include "vtkWeakPointer.h"

class vtkHapticSession;

/// Who moves the hand: what a session knows, looked for anew whenever this is opened. The tip of one that cannot be
/// used says why.
class pqHapticDeviceChoice : public QComboBox
{
  typedef QComboBox Superclass;

public:
  explicit pqHapticDeviceChoice(QWidget* parent = nullptr);
  ~pqHapticDeviceChoice() override;

  /// Whose devices these are; null: none.
  void setSession(vtkHapticSession* session);
  void showPopup() override;
  /// Shows what the session has chosen, also where that is nothing a person could choose.
  void follow();

private:
  void list();

  vtkWeakPointer<vtkHapticSession> Session;
};

#endif
