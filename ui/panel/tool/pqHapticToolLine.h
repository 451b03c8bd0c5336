// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticToolLine_h
#define pqHapticToolLine_h

#include "vtkWeakPointer.h"

#include <QObject>
#include <QPointer>

class pqLinePropertyWidget;
class pqPipelineSource;
class pqView;
class vtkSMProxy;

/// A line in the view from the handle of a tool to its tip, both drawn with the mouse where the tool's data are.
class pqHapticToolLine : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticToolLine(QWidget* parent);
  ~pqHapticToolLine() override;

  /// The session is held at the handle from then on. A handle and a tip that were never placed, or for a tool
  /// elsewhere, stand at the ends of the tool's longest side.
  void show(vtkSMProxy* session, pqPipelineSource* tool);
  void hide();

private:
  void apply();

  QWidget* Panel;
  vtkWeakPointer<vtkSMProxy> Session;
  QPointer<pqPipelineSource> Tool;
  QPointer<pqView> View; ///< where the tool and the line are shown
  QPointer<pqLinePropertyWidget> Line;
};

#endif
