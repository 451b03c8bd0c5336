// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticController_h
#define pqHapticController_h

#include <QObject>
#include <QPointer>

#include "vtkSmartPointer.h"

#include <memory>

class QAction;
class pqHapticFrames;
class pqHapticHandKeys;
class pqHapticMarks;
class pqHapticMouse;
class pqHapticPencil;
class pqHapticRecordings;
class pqHapticScript;
class pqHapticViewFollower;
class pqHapticTouchKinds;
class pqServer;
class vtkHapticSession;
class vtkSMProxy;

/**
 * Owns the one haptic session of the client: its proxy, the view it follows, and the actions of menu and toolbar.
 *
 * All state is in the proxy (group "haptics", name "HapticSession"): panel, Python and state files change the same
 * thing. A session proxy that Python or a state file registers replaces the present one. GUI thread only.
 */
class pqHapticController : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  /// The application's controller; made at the first call, owned by the application.
  static pqHapticController* instance();

  ~pqHapticController() override;

  vtkSMProxy* sessionProxy() const;
  /// Null when no server is connected.
  vtkHapticSession* session() const;
  pqHapticViewFollower* follower() const { return this->Follower; }
  pqHapticMouse* mouse() const { return this->Mouse; }
  pqHapticMarks* marks() const { return this->Marks; }
  pqHapticTouchKinds* kinds() const { return this->Kinds; }
  pqHapticRecordings* recordings() const { return this->Recordings; }

  QAction* touchAction() const { return this->TouchAction; }
  QAction* releaseAction() const { return this->ReleaseAction; }
  QAction* markAction() const { return this->MarkAction; }
  QAction* drawAction() const { return this->DrawAction; }

  bool touching() const;
  /// Reason why nothing can be touched here, and the remedy; "" with touchable data.
  QString refusal() const;

public Q_SLOTS:
  /// Through the proxy, so that Python traces and state files see it.
  void setTouching(bool on);
  /// Lets go at once: force to zero, touch off.
  void release();
  /// Such a map that the device's workspace holds the whole scene.
  void fitWorkspace();
  /// Sets a mark at the contact; without one the session says why not.
  void mark();
  /// The same for the sources that are selected in the pipeline browser.
  void fitSelection();
  /// Right, up and towards of the device are those of the view, now.
  void alignWithView();
  /// Whether the path through a labyrinth is drawn.
  void showTrace(bool shown);
  /// Whether start and exit of a labyrinth are drawn while touching.
  void showPlaces(bool shown);
  /// Before the application ends: lets go and gives everything back.
  void shutdown();

Q_SIGNALS:
  /// Another session proxy, or none.
  void sessionChanged(vtkSMProxy* proxy);

private:
  explicit pqHapticController(QObject* parent);

  void connectApplication();
  void makeActions();
  void serverAdded(pqServer* server);
  void serverLeaves(pqServer* server);
  void proxyRegistered(const QString& group, vtkSMProxy* proxy);
  void proxyUnregistered(const QString& group, vtkSMProxy* proxy);
  void adopt(vtkSMProxy* proxy);
  void proxyChanged();
  void setPressDepth(double depth_m);

  vtkSmartPointer<vtkSMProxy> Proxy;
  unsigned long ProxyObserver = 0;
  pqHapticViewFollower* Follower;
  pqHapticFrames* Frames;
  pqHapticMouse* Mouse;
  pqHapticPencil* Pencil;
  pqHapticRecordings* Recordings;
  pqHapticHandKeys* Keys;
  pqHapticScript* Script;
  pqHapticTouchKinds* Kinds;
  pqHapticMarks* Marks;
  QAction* TouchAction;
  QAction* ReleaseAction;
  QAction* MarkAction;
  QAction* DrawAction;
};

#endif
