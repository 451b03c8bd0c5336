// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticPencil
 * @brief   draws lines freehand in a render view, with the left mouse button
 *
 * While active, a press of the left button without Shift begins a line, moving draws it, release ends it; all else is
 * left to the camera. Each line is a Poly Line Source, shown and applied point by point, so it is felt while it is
 * being drawn; at its end it is reduced to the points that hold it within a pixel and becomes the active source, whose
 * handles ParaView's widget shows. The line lies in the plane of the session's plane world; where there is none, on the
 * surfaces that are seen, if the line begins on one, and else in the plane through the camera's focal point parallel to
 * the screen.
 *
 * StartInteractionEvent, before the source of a line is made; InteractionEvent, a point was added; EndInteractionEvent.
 * GUI thread only.
 */
#ifndef vtkHapticPencil_h
#define vtkHapticPencil_h

#include "vtkHapticViewsModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for the implementation

class vtkHapticSession;
class vtkSMProxy;

class VTKHAPTICVIEWS_EXPORT vtkHapticPencil : public vtkObject
{
public:
  static vtkHapticPencil* New();
  vtkTypeMacro(vtkHapticPencil, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The proxy of the render view to draw in; null or a view of another kind: none. Watched, not kept alive. Another
  /// one, or its deletion, ends the line.
  void SetView(vtkSMProxy* view);
  vtkSMProxy* GetView() const;
  ///@}

  /// Whose plane world's plane is drawn in; null: none.
  void SetSession(vtkHapticSession* session);

  ///@{
  /// Whether the left button draws. Default off. Switched off it ends the line.
  void SetActive(bool active);
  bool GetActive() const;
  ///@}

  /// The source of the line that is being drawn; null between lines, and before a line has two points.
  vtkSMProxy* GetLine() const;

protected:
  vtkHapticPencil();
  ~vtkHapticPencil() override;

private:
  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
