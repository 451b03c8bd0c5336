// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticViewGroup_h
#define pqHapticViewGroup_h

#include "pqHapticSettingRows.h"

#include <QGroupBox>
#include <QList>

class QCheckBox;
class QPushButton;
class pqPropertyLinks;
class vtkSMProxy;

/// The group "Hand and view" of the panel: how the workspace of the device lies in the view, and what holds the hand.
class pqHapticViewGroup : public QGroupBox
{
  Q_OBJECT
  typedef QGroupBox Superclass;

public:
  explicit pqHapticViewGroup(QWidget* parent = nullptr);
  ~pqHapticViewGroup() override;

  void link(pqPropertyLinks& links, vtkSMProxy* proxy);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  QPushButton* Fit;
  QPushButton* Align;
  QCheckBox* Precise;
  QCheckBox* Clutch;
  pqHapticSettingRows Rows;
};

#endif
