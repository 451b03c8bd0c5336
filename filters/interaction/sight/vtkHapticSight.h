// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticSight
 * @brief   a session as pictures and followers of a view need it
 */
#ifndef vtkHapticSight_h
#define vtkHapticSight_h

#include "vtkHapticSessionPart.h"

#include <functional>
#include <string>

struct vtkHapticFieldResult;
class vtkCamera;
class vtkDataObject;
class vtkHapticServerSurfaces;
class vtkMatrix4x4;
class vtkPolyData;

class VTKHAPTICINTERACTION_EXPORT vtkHapticSight : public vtkHapticSessionPart
{
public:
  vtkAbstractTypeMacro(vtkHapticSight, vtkHapticSessionPart);
  static vtkSmartPointer<vtkHapticSight> Of(vtkHapticSession& session);

  /// The camera of the view that is looked at: said before each Update() of the session.
  void FollowCamera(vtkCamera* camera);
  /// From where the hand of the device "mouse" is seen, in W [u]: a surface that comes between stays behind the hand,
  /// which begins anew in front of it (StartEvent). Said before each Update() too.
  void SetEye(const double p_W[3]);

  vtkMTimeType GetMaterialTime() const; ///< changes whenever a setting of surfaces does
  bool GetUsesMaterialArrays() const;   ///< whether any is named
  /// Whether AddSurface() would not hold its caller for longer than a picture takes; else a thread begins to read these
  /// data, and the answer is true once it is done.
  bool PrepareSurface(const char* name, vtkDataObject* data, vtkMatrix4x4* matrix);
  /// Cancels PrepareSurface(), because other data are visible.
  void ForgetPrepared();
  int GetScenesCancelled() const; ///< how often CancelScene() did that
  /// Other data that the field is compared with, and whose points and lines the hand snaps to; null: none. Kept by
  /// reference. FeltSource, CompareSource and SnapSource name all of them for followers of a view.
  void SetComparedField(vtkDataObject* compared, vtkDataObject* snap);
#ifndef __VTK_WRAP__
  bool AddRemoteField(const char* name, const vtkHapticFieldResult& made); ///< of data elsewhere, made there
  vtkHapticServerSurfaces& ServerSurfaces() const;                         ///< loaded parts of remote surfaces
#endif

  /// Where the ball is first stopped between one point and another: its centre and the unit normal of the surface that
  /// stops it, to its side. False, and both unchanged, where nothing does.
  bool PickSurface(const double from_W[3], const double to_W[3], double ball_W[3], double normal_W[3]) const;
  /// Corners of the box around the ball that the device reaches, of bits x, y, z, [u].
  void GetWorkspaceCorners(double corners_W[24]) const;
  /// Where the hand is in its device's workspace: from the middle [m], and its turn, a quaternion w, x, y, z; and the
  /// map from there into the scene that puts it where the scene has it, as a clutch or a later map does too. False, and
  /// all unchanged: nobody touches, or the device has no hand.
  bool GetDeviceHand(double hand_D[3], double turn_D[4], vtkMatrix4x4* toScene) const;
  /// The field at the proxy: patch, streamline, level, the place that is snapped to [u].
  void GetFieldShape(vtkPolyData* shape) const;
  void GetToolShape(vtkPolyData* shape) const;
  /// How a loose source has gone from where its data are, in W; false, and unchanged: it is where they are.
  bool GetLooseWay(const char* name, vtkMatrix4x4* way) const;
  /// Whether any source is loose; and the unit of lengths that the files of the visible data have ("mm", "u": unknown),
  /// by which loose sources have their mass where SceneUnit is automatic.
  bool GetHasLoose() const;
  void SetUnitOfFiles(const char* unit);
#ifndef __VTK_WRAP__
  /// Which of the loose sources the pipeline has, as LooseText says.
  void LookForLoose(const std::function<bool(const std::string& name)>& isThere);
#endif
  /// The contacts of the tool, or of the held mesh of a mechanism, as of the last Update(): a point for each. The
  /// arrays are Force (n, 3), the force there on the tool before limits [N], along the normal where the scene is rigid;
  /// Touched (strings), the name of the surface or body that presses; and Pair (int), a number for each name. A proxy
  /// sphere has none.
  void GetContactForces(vtkPolyData* points) const;
  /// How far the tool reaches from its tip against a direction, turned as it is [u]; 0: none is held.
  double GetToolReach(const double direction_W[3]) const;
  /// The held tool or mechanism as it is turned now: from the hand to its tip [u], and its axis, a unit vector. The tip
  /// of a tool without handle is its middle. False, and both unchanged: none is held.
  bool GetHeldAxis(double tip_W[3], double axis_W[3]) const;
  /// Turns the hand by the least rotation that has the held axis point there.
  void TurnHeldAxis(const double direction_W[3]);
  /// The displacement of the hand at which the spring pushes with the largest force [m].
  double GetLargestDepth() const;
  /// Whether a mechanism is held, and whether a field is felt.
  bool GetHoldsMechanism() const;
  bool GetFeelsField() const;
  /// Whether the hand would feel the field at a place: its values there have been read, or there are none.
  bool GetFieldIsReady(const double p_W[3]) const;
  /// The box of all that the hand meets: surfaces, field, bodies of the mechanism other than the held one [u]; false:
  /// none.
  bool GetMetBounds(double bounds[6]) const;

private:
  explicit vtkHapticSight(vtkHapticSession& session) : vtkHapticSessionPart(session) {}
};

#endif
