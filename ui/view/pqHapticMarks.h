// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMarks_h
#define pqHapticMarks_h

#include <QObject>
#include <QPointer>

#include "pqRenderView.h" // QPointer needs the whole class
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class pqPipelineSource;
class vtkHapticMarkProps;
class vtkHapticSession;
class vtkSMProxy;

/**
 * Draws the marks of the session in the render view that was active last, whether anything is touched or not.
 *
 * Where a source Touch Marks shows the same marks, that source is the picture. A new source Touch Marks gets the marks
 * that were saved last, or those of the session where none were.
 */
class pqHapticMarks : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticMarks(QObject* parent = nullptr);
  ~pqHapticMarks() override;

  void setProxy(vtkSMProxy* proxy);
  /// The camera looks at a mark, from the same direction and distance as before.
  void goTo(int mark) const;

public Q_SLOTS:
  void setView(pqRenderView* view);
  /// The view is closing.
  void leaveView();

private:
  void proxyUpdated();
  void follow();
  bool isShownBySource() const;
  void fill(pqPipelineSource* source) const;
  vtkHapticSession* session() const;

  vtkNew<vtkHapticMarkProps> Props;
  vtkSmartPointer<vtkSMProxy> Proxy;
  unsigned long Observer = 0;
  std::string Drawn; ///< text of the marks that are drawn
  QPointer<pqRenderView> View;
  std::vector<QMetaObject::Connection> Connections; ///< to the view
};

#endif
