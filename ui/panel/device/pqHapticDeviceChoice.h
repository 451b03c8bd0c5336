// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticDeviceChoice_h
#define pqHapticDeviceChoice_h

#include <QComboBox>

#include "vtkWeakPointer.h"

class vtkHapticSession;

/// The devices that a session knows, searched anew at each opening. The tip of one that cannot be
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
  /// Shows the choice of the session, even if a person could not choose it.
  void follow();

private:
  void list();

  vtkWeakPointer<vtkHapticSession> Session;
};

#endif
