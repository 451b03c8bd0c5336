// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticPencil_h
#define pqHapticPencil_h

#include <QObject>
#include <QPointer>

#include "pqRenderView.h" // QPointer needs the whole class
#include "vtkNew.h"

class vtkHapticPencil;
class vtkHapticSession;

/**
 * Drawing lines freehand in the active render view: the pointer is a cross, each line is one step that can be undone.
 *
 * GUI thread only.
 */
class pqHapticPencil : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticPencil(QObject* parent = nullptr);
  ~pqHapticPencil() override;

  void setSession(vtkHapticSession* session);

public Q_SLOTS:
  void setView(pqRenderView* view);
  /// While active the left button draws instead of turning the camera.
  void setActive(bool active);

private:
  void begin();
  void showLine();
  void end();
  void showCursor();
  void leaveView();

  vtkNew<vtkHapticPencil> Pencil;
  QPointer<pqRenderView> View;
};

#endif
