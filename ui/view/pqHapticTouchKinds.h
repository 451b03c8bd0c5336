// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticTouchKinds_h
#define pqHapticTouchKinds_h

#include <QObject>
#include <QString>

class pqHapticController;
class pqHapticSimulatedHand;
class pqPipelineSource;
class pqView;
class vtkHapticTouchAs;

/// Has sources touched as the kinds of vtkHapticTouchAs, each as one step of undo. ParaView's status bar reports the
/// result, or why nothing was done.
class pqHapticTouchKinds : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticTouchKinds(pqHapticController* controller);

  /// False if the data do not fit; "": as the kind that is most likely.
  bool touchAs(pqPipelineSource* source, const QString& kind);
  /// As the kind that is most likely; then the hand touches.
  void touch(pqPipelineSource* source);

public Q_SLOTS:
  /// Before a person touches: where nothing can be touched as it is shown, the first of the lines and volumes that are
  /// shown can. A simulated hand that was chosen gets a path.
  void prepare(bool touching);

private:
  void aim(vtkHapticTouchAs& at) const;
  void takeLikely(const pqView& view);

  pqHapticController* Controller;
  pqHapticSimulatedHand* Simulated;
};

#endif
