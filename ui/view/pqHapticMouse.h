// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMouse_h
#define pqHapticMouse_h

#include <QObject>
#include <QPointer>
#include <QString>

#include "pqRenderView.h" // QPointer needs the whole class
#include "vtkNew.h"

class QWidget;
class vtkHapticMouse;
class vtkHapticMouseInput;
class vtkHapticSession;

/**
 * The mouse in the view that is touched, for a session whose device is "mouse".
 *
 * The camera keeps all it had but Shift with the left button and the wheel, and the arrow and page keys, and these only
 * while the mouse leads a hand. The hand is lifted when the pointer or the keyboard's focus leaves the view. GUI thread
 * only.
 */
class pqHapticMouse : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticMouse(QObject* parent = nullptr);
  ~pqHapticMouse() override;

  void setSession(vtkHapticSession* session);
  /// Help for mouse and keyboard, and limits; empty while another device is chosen.
  QString help() const;

public Q_SLOTS:
  void setView(pqRenderView* view);
  /// While active the hand is led, and the status line says how, and the force [N].
  void setActive(bool active);
  /// Once a frame.
  void update();

Q_SIGNALS:
  /// The person made the hand press deeper or less deep [m of the hand].
  void depthChanged(double depth_m);

private:
  void deepened();
  void showStatus();
  void focusMoved(QWidget* from, QWidget* to);

  vtkNew<vtkHapticMouse> Mouse;
  vtkNew<vtkHapticMouseInput> Input;
  QPointer<pqRenderView> View;
  QString Status; ///< text of the status line
  bool Active = false;
};

#endif
