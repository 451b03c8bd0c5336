// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSimulatedHand_h
#define pqHapticSimulatedHand_h

#include "vtkHapticSession.h"
#include "vtkWeakPointer.h"

#include <QObject>

#include <array>
#include <vector>

class pqHapticController;
class pqRenderView;

/**
 * Leads the hand of a simulated device that a person chose, and that no script gave a path.
 *
 * The hand strokes to and fro over the surface that the view shows, along a row of the screen through the middle of
 * the data: the part of the row with the most neighbouring places that face the camera. The hand goes under the
 * surface by the depth to which the mouse presses, and begins in front of the surface. Where the view shows no surface,
 * as with a volume, the hand goes to and fro from the front of the data to their middle.
 */
class pqHapticSimulatedHand : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticSimulatedHand(pqHapticController* controller);
  ~pqHapticSimulatedHand() override;

  /// Before a touch: looks where the surface is. The path of that touch alone is set once its scale is known.
  void prepare();

private:
  using Point = std::array<double, 3>;
  struct Place
  {
    Point At_W, Normal_W; ///< on the surface, towards the camera
  };
  using Places = std::vector<Place>;
  void forget();
  void lead();
  static Places seenIn(pqRenderView& view);
  static Places seenInRow(pqRenderView& view, double y, double from, double to, const Point& toCamera);

  pqHapticController* Controller;
  Places Way;
  vtkWeakPointer<vtkHapticSession> Prepared;
  unsigned long Observer = 0; ///< of the prepared session
};

#endif
