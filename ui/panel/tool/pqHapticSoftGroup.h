// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSoftGroup_h
#define pqHapticSoftGroup_h

#include "pqHapticSettingRows.h"

#include <QGroupBox>
#include <QList>

class QLabel;
class QPushButton;
class pqPropertyLinks;
class vtkHapticSession;
class vtkSMProxy;

/// The group "Soft body" of the panel: which source gives way, how often it is computed, and how it is.
class pqHapticSoftGroup : public QGroupBox
{
  Q_OBJECT
  typedef QGroupBox Superclass;

public:
  explicit pqHapticSoftGroup(QWidget* parent = nullptr);
  ~pqHapticSoftGroup() override;

  void link(pqPropertyLinks& links, vtkSMProxy* proxy);
  /// Null where there is no session. Ten times a second.
  void refresh(vtkHapticSession* session);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  QPushButton* Use;
  QPushButton* Leave;
  QLabel* Text;
  pqHapticSettingRows Rows;
};

#endif
