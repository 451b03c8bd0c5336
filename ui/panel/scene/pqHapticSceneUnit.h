// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSceneUnit_h
#define pqHapticSceneUnit_h

#include <QString>

class QWidget;
class pqHapticViewFollower;
class vtkHapticSession;

/// Has a panel show the unit of the scene's lengths.
class pqHapticSceneUnit
{
public:
  /// Null: no session. Called ten times a second.
  void refresh(QWidget& panel, vtkHapticSession* session, const pqHapticViewFollower& follower);
  /// The unit, and where it is from.
  const QString& sentence() const { return this->Sentence; }

private:
  QString Sentence;
  int Refreshes = 0;
};

#endif
