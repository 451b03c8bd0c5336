// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticFrames_h
#define pqHapticFrames_h

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "pqRenderView.h" // QPointer needs the whole class
#include "vtkHapticKeptPicture.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkHapticSession;
class vtkHapticToolProps;

/**
 * Draws hand, proxy and force in a view while it is touched.
 *
 * The next frame is asked for only when the last has ended, so a slow renderer lowers the frame rate and nothing
 * else: requests never pile up and the servo thread is never waited for. GUI thread only.
 */
class pqHapticFrames : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticFrames(QObject* parent = nullptr);
  ~pqHapticFrames() override;

  void setSession(vtkHapticSession* session);
  void setActive(bool active);
  /// Whether the path through a labyrinth is drawn too, then also when nothing is touched any more; off at first.
  void showTrace(bool shown);
  /// Whether start and exit of a labyrinth are drawn too; on at first.
  void showPlaces(bool shown);

public Q_SLOTS:
  void setView(pqRenderView* view);

Q_SIGNALS:
  /// The newest state is known; the hand may be led on before it is drawn.
  void updated();
  /// A picture ended that ParaView knows nothing of, as only the hand was drawn anew.
  void handDrawn();

private:
  void nextFrame();
  /// Takes the newest state into the picture.
  void takeState();
  void frameEnded();
  /// Whether nothing but the hand is to be drawn anew.
  bool onlyTheHandMoved() const;
  void attach();
  void detach();
  /// Without a tool: the view after the end of a touch.
  void follow();

  vtkNew<vtkHapticToolProps> Props;
  vtkHapticKeptPicture Kept;
  vtkSmartPointer<vtkHapticSession> Session;
  QPointer<pqRenderView> View;
  QMetaObject::Connection FrameBegins, FrameEnded;
  QTimer Pause; ///< between the end of a frame and the request for the next
  bool Active = false;
  bool Attached = false;
};

#endif
