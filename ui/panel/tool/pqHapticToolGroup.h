// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticToolGroup_h
#define pqHapticToolGroup_h

#include "pqHapticGroup.h"

#include <QPointer>

class pqHapticToolLine;
class pqPipelineSource;

/// The group "Tool" of the panel: which source the hand holds in place of the ball, how, and how it is.
class pqHapticToolGroup : public pqHapticGroup
{
  Q_OBJECT
  typedef pqHapticGroup Superclass;

public:
  explicit pqHapticToolGroup(QWidget* parent = nullptr);

  void refresh(vtkHapticSession* session) override;
  QList<QWidget*> fields() const override;

private:
  void hideTool() const;
  void placeHandle(bool shown);

  QPushButton* PlaceHandle;
  pqHapticToolLine* Line;
  QPointer<pqPipelineSource> Placed; ///< whose handle is placed in the view
  QLabel* Text;
  QLabel* Contacts;
};

#endif
