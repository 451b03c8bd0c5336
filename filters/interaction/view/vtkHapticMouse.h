// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticMouse
 * @brief   the motion of a hand from a pointer in a view: hovers over the surface under it, presses on it, lifts
 *
 * For a session whose device is "mouse". The pointer's ray is swept with the ball that touches. The hand hovers in
 * front of the surface that the ray meets; a pressing hand goes behind that along the normal by the session's
 * PressDepth, so that a plain surface pushes with stiffness x depth. A tool that is held reaches as deep as the ball
 * would. Where the ray meets nothing the hand goes in the plane through the proxy that is parallel to the screen. Where
 * the straight path is barred by a surface, and when the pointer leaves, it first rises towards the eye, in front of
 * everything. The hand presses only while the session is engaged. In a plane world the hand is where the ray meets the
 * plane, and walls push by how far they keep the proxy from there; when the pointer leaves it rests at the proxy.
 *
 * A held body is led by its tip: the handle's tip, the end of a rod, the middle of another tool. A mechanism, and a
 * tool for which HoldAlong says so, is aimed across its axis by the pointer and advanced along its axis, by pressing or
 * by Advance(), from where it meets nothing. In a field without a surface under the pointer the same holds along the
 * direction of view, from the middle of the data. An advancing hand goes at 0.15 m/s at most, PressDepth beyond its
 * proxy, and while it presses as far as the largest force. When the pointer leaves it stays where its proxy is.
 *
 * While the session is precise, and the hand presses or is in a plane world, a displacement of the pointer moves the
 * hand PrecisionFactor times less; while its clutch is pressed the hand stays. Both go on from there: the hand is under
 * the pointer again once it was lifted, or the pointer has left.
 *
 *     mouse.SetRenderer(renderer)
 *     mouse.SetSession(session)
 *     mouse.SetPointer(120, 80)
 *     mouse.SetPressing(True)
 *     mouse.Update()
 *
 * Update() once a frame and after every change leads the hand; between two of them the device glides. GUI thread only.
 */
#ifndef vtkHapticMouse_h
#define vtkHapticMouse_h

#include "vtkHapticInteractionModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for the implementation

class vtkHapticSession;
class vtkRenderer;

class VTKHAPTICINTERACTION_EXPORT vtkHapticMouse : public vtkObject
{
public:
  static vtkHapticMouse* New();
  vtkTypeMacro(vtkHapticMouse, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Through whose camera the pointer looks, and whose hand it leads; null: none. The renderer is watched, not kept.
  void SetRenderer(vtkRenderer* renderer);
  void SetSession(vtkHapticSession* session);
  vtkHapticSession* GetSession() const;
  ///@}

  /// True while the session touches with the device "mouse".
  bool GetLeads() const;

  ///@{
  /// Where the pointer is [pixels from the lower left corner of the window]; by how much it moves; that it is gone,
  /// which lifts the hand and ends pressing. Outside of the renderer's viewport it is gone.
  void SetPointer(double x, double y);
  void MovePointer(double dx, double dy);
  void Leave();
  ///@}

  ///@{
  /// Whether the hand presses. Default off.
  void SetPressing(bool on);
  bool GetPressing() const;
  ///@}

  /// Multiplies the session's PressDepth by `factor` > 0, within 0.05 mm and 50 mm; InteractionEvent tells of it.
  void Deepen(double factor);

  ///@{
  /// Whether the hand advances along an axis: a mechanism or a tool that is held along one, or a hand in a field where
  /// no surface stands before it. Advance() moves the plane in which the pointer leads the hand along that axis, by
  /// notches of 2 mm of the hand, no more than a twentieth of the scene's diagonal each. Pressing goes on along it.
  bool GetAdvances() const;
  void Advance(double notches);
  ///@}

  ///@{
  /// While the hand advances, a bar at the left edge of the view shows how far, from before all that can be met to
  /// behind it. GrabDepth(): true where the pointer is on that bar, whose handle then follows DragDepth() until
  /// DropDepth(), while the hand stays under the place where the pointer came from.
  bool GrabDepth(double x, double y);
  void DragDepth(double y);
  void DropDepth();
  bool GetDragsDepth() const;
  ///@}

  /// Ends pressing, and has a hand that advanced go back to where it began.
  void Lift();

  /// How deep it presses now [u]: PressDepth, no more than a twentieth of the scene's diagonal.
  double GetUsedDepth() const;

  /// The ray through where the hand is led to on the screen, from the near to the far plane of the camera [u]; false
  /// without a renderer in a window.
  bool GetRay(double near_W[3], double far_W[3]) const;

  /// Leads the hand to where it is to be now.
  void Update();

protected:
  vtkHapticMouse();
  ~vtkHapticMouse() override;

private:
  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
