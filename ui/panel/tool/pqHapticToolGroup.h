// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticToolGroup_h
#define pqHapticToolGroup_h

#include "pqHapticSettingRows.h"

#include <QGroupBox>
#include <QList>
#include <QPointer>

class QLabel;
class QPushButton;
class pqHapticToolLine;
class pqPipelineSource;
class pqPropertyLinks;
class vtkHapticSession;
class vtkSMProxy;

/// The group "Tool" of the panel: which source the hand holds in place of the ball, how, and how it is.
class pqHapticToolGroup : public QGroupBox
{
  Q_OBJECT
  typedef QGroupBox Superclass;

public:
  explicit pqHapticToolGroup(QWidget* parent = nullptr);
  ~pqHapticToolGroup() override;

  void link(pqPropertyLinks& links, vtkSMProxy* proxy);
  /// Null where there is no session. Ten times a second.
  void refresh(vtkHapticSession* session);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  void useSelected();
  void takeBall();
  void placeHandle(bool shown);

  QPushButton* Use;
  QPushButton* Ball;
  QPushButton* PlaceHandle;
  pqHapticToolLine* Line;
  QPointer<pqPipelineSource> Placed; ///< whose handle is placed in the view
  QLabel* Text;
  QLabel* Contacts;
  pqHapticSettingRows Rows;
};

#endif
