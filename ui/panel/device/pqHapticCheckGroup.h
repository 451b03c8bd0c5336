// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticCheckGroup_h
#define pqHapticCheckGroup_h

#include "pqHapticGroup.h"

#include <QString>

class QProgressBar;

/// The group "Device check" of the panel: a check of the chosen device, its instructions and its result.
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
  QString Note; ///< replaces the result: a refusal, or the note that it was saved
};

#endif
