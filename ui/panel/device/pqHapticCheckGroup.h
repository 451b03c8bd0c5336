// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticCheckGroup_h
#define pqHapticCheckGroup_h

#include "pqHapticGroup.h"

#include <QString>

class QProgressBar;

/// The group "Device check" of the panel: a check of the chosen device, what the person must do for it, what it found.
class pqHapticCheckGroup : public pqHapticGroup
{
  Q_OBJECT
  typedef pqHapticGroup Superclass;

public:
  explicit pqHapticCheckGroup(QWidget* parent = nullptr);

  void refresh(vtkHapticSession* session) override;
  QList<QWidget*> fields() const override;

private:
  void startOrStop();
  void keep();

  QPushButton* Verify;
  QPushButton* Adjust;
  QProgressBar* Progress;
  QLabel* Ask;
  QLabel* Result;
  QString Note; ///< stands there instead of a result: what was refused or kept
};

#endif
