// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticViewFollower_h
#define pqHapticViewFollower_h

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>

#include "pqProxyWidget.h" // QPointer needs the whole class
#include "pqRenderView.h"
#include "vtkNew.h"

#include <vector>

class pqView;
class vtkHapticSession;
class vtkHapticViewScene;
class vtkSMProxy;

/**
 * Keeps the session's scene the same as the surfaces that the active render view shows.
 *
 * The follower looks after every frame and change of visibility; nothing is handed over unless something touchable
 * changed. Not after updates of the pipeline: until the frame that shows one, a surface may have new points and old
 * cells. A view that closes leaves an empty scene at once. GUI thread only.
 */
class pqHapticViewFollower : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticViewFollower(QObject* parent = nullptr);
  ~pqHapticViewFollower() override;

  void setSession(vtkHapticSession* session);
  /// Only while active is the view looked at: untouched surfaces cost nothing.
  void setActive(bool active);

  pqRenderView* view() const { return this->View; }
  /// Touched surfaces, and refusals with their reasons.
  QString report() const;
  /// Reason why no visible data can be touched, whether the view is followed or not; "" with touchable data.
  QString refusal() const;
  /// See vtkHapticViewScene::TakeColorRange().
  QString takeColorRange(vtkSMProxy* session) const;
  /// See vtkHapticLengthUnitOf().
  QString lengthUnit(QString& reason) const;
  /// Of the points and cells of visible data, touched or not.
  QStringList arrayNames() const;
  /// See vtkHapticShownArrays().
  QStringList shownArrays() const;
  /// Of all sources that are shown, however they are drawn, with so many components; 0: any.
  QStringList fieldNames(int components) const;

public Q_SLOTS:
  void setView(pqView* view);
  void refresh();
  /// Passes visible data to the session, active or not; also at the session's request.
  void handOver();

Q_SIGNALS:
  void viewChanged(pqRenderView* view);
  /// The view that was touched is being destroyed.
  void viewClosing();

private:
  void viewRemoved(pqView* view);
  void connectView();
  bool drewCoarser() const;
  /// The active source, if it was made and not applied yet and its widget is shown; else null.
  vtkSMProxy* newDrawing();

  vtkNew<vtkHapticViewScene> Scene;
  QPointer<pqRenderView> View;
  QPointer<pqProxyWidget> Panel;   ///< of the last new source: the window is not searched for it every frame
  const pqView* Touched = nullptr; ///< the last render view; compared only: no view is active while one closes
  std::vector<QMetaObject::Connection> Connections;
  unsigned long Observer = 0; ///< of the session
  bool Active = false;
};

#endif
