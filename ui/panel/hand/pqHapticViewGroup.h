// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticViewGroup_h
#define pqHapticViewGroup_h

#include "pqHapticGroup.h"

class QCheckBox;

/// The group "Hand and view" of the panel: pose of the device's workspace in the view, precision and clutch.
class pqHapticViewGroup : public pqHapticGroup
{
  Q_OBJECT
  typedef pqHapticGroup Superclass;

public:
  explicit pqHapticViewGroup(QWidget* parent = nullptr);

  void link(pqPropertyLinks& links, vtkSMProxy* proxy) override;
  QList<QWidget*> fields() const override;

private:
  QPushButton* Fit;
  QPushButton* Align;
  QCheckBox* Precise;
  QCheckBox* Clutch;
};

#endif
