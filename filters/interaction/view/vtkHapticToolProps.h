// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticToolProps
 * @brief   the picture of a haptic session: proxy, hand and force
 *
 * Two balls, or a tool or the held body of a mechanism, solid where it is felt and as a ghost where the hand would have
 * it; a grey ball where the hand was when soft bodies were computed last, if the session has ShowSoftHand; arrows of
 * force and torque, and at each contact of a tool if the session has ShowContactForces; start (green) and exit (red) of
 * a labyrinth and the path through it, and the box of the device's workspace where the session has ShowWorkspace. The
 * proxy's ball has the session's radius where that can be seen; the arrows start at the proxy and point along the force
 * on the hand and about the torque that a tool asks for. None is picked or counted in the bounds of a scene.
 */
#ifndef vtkHapticToolProps_h
#define vtkHapticToolProps_h

#include "vtkHapticInteractionModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for the implementation

class vtkActor;
class vtkHapticSession;
class vtkRenderer;

class VTKHAPTICINTERACTION_EXPORT vtkHapticToolProps : public vtkObject
{
public:
  static vtkHapticToolProps* New();
  vtkTypeMacro(vtkHapticToolProps, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// One renderer at a time; the props leave the one before. The renderer is watched, not kept alive.
  void AddToRenderer(vtkRenderer* renderer);
  void RemoveFromRenderer();
  ///@}

  /// Moves the props to the state of the session's last Update(); hides all but the path while it does not touch.
  void UpdateFrom(vtkHapticSession* session);

  ///@{
  /// Smallest radius at which the balls are drawn, as a fraction of the scene's diagonal. Default 0.01, 0..1.
  vtkSetClampMacro(RelativeSize, double, 0.0, 1.0);
  vtkGetMacro(RelativeSize, double);
  ///@}

  ///@{
  /// Length of the arrow for one newton, as a fraction of the scene's diagonal. Default 0.1, 0..10.
  vtkSetClampMacro(ForceScale, double, 0.0, 10.0);
  vtkGetMacro(ForceScale, double);
  ///@}

  ///@{
  /// Whether the path that the session remembers of a labyrinth is drawn. Default off.
  vtkSetMacro(ShowTrace, bool);
  vtkGetMacro(ShowTrace, bool);
  vtkBooleanMacro(ShowTrace, bool);
  ///@}

  ///@{
  /// Whether start and exit of the labyrinth that is played are drawn. Default on. While a hand has to go to the start
  /// the start is drawn in any case.
  vtkSetMacro(ShowPlaces, bool);
  vtkGetMacro(ShowPlaces, bool);
  vtkBooleanMacro(ShowPlaces, bool);
  ///@}

  ///@{
  vtkActor* GetProxyActor() const;
  vtkActor* GetHandActor() const;
  vtkActor* GetSoftHandActor() const; ///< the hand that soft bodies were computed for, where ShowSoftHand is on
  vtkActor* GetForceActor() const;
  vtkActor* GetTraceActor() const;
  vtkActor* GetStartActor() const;
  vtkActor* GetExitActor() const;
  vtkActor* GetWorkspaceActor() const;
  vtkActor* GetTorqueActor() const;
  vtkActor* GetHeldActor() const;     ///< the tool, or the held body of a mechanism, at its pose
  vtkActor* GetGhostActor() const;    ///< and where the hand would have it
  vtkActor* GetContactsActor() const; ///< arrows at the contacts of the tool, where ShowContactForces is on
  vtkActor* GetFieldActor() const;    ///< patch of an isosurface and streamline where the proxy is
  ///@}

protected:
  vtkHapticToolProps();
  ~vtkHapticToolProps() override;

private:
  double RelativeSize = 0.01;
  double ForceScale = 0.1;
  bool ShowTrace = false;
  bool ShowPlaces = true;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
