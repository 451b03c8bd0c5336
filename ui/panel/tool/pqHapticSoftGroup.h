// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSoftGroup_h
#define pqHapticSoftGroup_h

#include "pqHapticGroup.h"

/// The group "Soft body" of the panel: which source is soft, how often it is computed, and its status.
class pqHapticSoftGroup : public pqHapticGroup
{
  Q_OBJECT
  typedef pqHapticGroup Superclass;

public:
  explicit pqHapticSoftGroup(QWidget* parent = nullptr);

  void refresh(vtkHapticSession* session) override;
  QList<QWidget*> fields() const override;

private:
  QLabel* Text;
};

#endif
