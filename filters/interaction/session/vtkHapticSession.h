// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticSession
 * @brief   touches surfaces with a haptic device: settings in, state out
 *
 * Owns a device, a servo at 1 kHz and a scene. Settings take effect at the next tick; the state is that of the last
 * Update(). In ParaView it is the proxy "HapticSession" of group "haptics", written to the state file once registered.
 *
 * Each setting, its unit, range and default, the time it takes effect, and each read-out are described once in
 * haptics/session/settings/: GetDescribed() has it as JSON, plugin/README.md as tables. A value that is not allowed is
 * an error, the old one stays, and GetProblem() says why until an allowed one is set.
 *
 * One thread, its maker's, calls every method; none waits for the servo but TouchingOff() and the destructor, which end
 * it at no force. Lengths and points are in scene units u and frame W unless said otherwise.
 */
#ifndef vtkHapticSession_h
#define vtkHapticSession_h

#include "vtkHapticInteractionModule.h" // for the export macro
#include "vtkHapticSessionDescribed.h"  // for read-outs
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for a result

#include <memory> // for the implementation

class vtkHapticDeviceCheck;
class vtkHapticInspection;
class vtkHapticKnownDevices;
class vtkHapticLabyrinthGame;
class vtkHapticSight;
class vtkHapticTouchedMechanism;
class vtkDataObject;
class vtkMatrix4x4;
class vtkPolyData;

class VTKHAPTICINTERACTION_EXPORT vtkHapticSession : public vtkObject
{
public:
  static vtkHapticSession* New();
  vtkTypeMacro(vtkHapticSession, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Every setting and read-out as JSON: {"settings": [{"name", "unit", "defaults", ...}, ...], "readouts": [...]}.
  static const char* GetDescribed();

  /// Choices of Simplify and LinesAsWalls, in their order.
  enum SimplifyChoices
  {
    Auto,
    Off,
    On
  };

  /// Choices of VelocityMethod.
  enum VelocityMethods
  {
    BackwardDifference,
    LowPass,
    AdaptiveWindow
  };

  /// Choices of ViewAlignment.
  enum ViewAlignments
  {
    AlignNever,
    AlignWhenTouched,
    AlignAlways
  };

  /** @name Settings Those of surfaces (LineRadius, LinesAsWalls, arrays) are felt on surfaces that are added later.
   * Velocities: Janabi- Sharifi et al. 2000; passivity: Hannaford & Ryu 2002, one tick ahead; friction: Harwin & Melder
   * 2002, in any order of the two calls; shading: Morgenbesser & Srinivasan 1996, which has no potential: a closed path
   * may take or give a little work. Held walls drag a handle along a slanted line by stiffness * speed / WallRate / 2.
   * If touching cannot start it stays off; StartEvent is the last moment to say where a program's hand begins, and
   * comes again when scale, rotation or offset change meanwhile. */
  void SetSetting(const char* name, double value); ///< on and off are 1 and 0, choices count from 0 on
  void SetSetting(const char* name, double low, double high);
  void SetSetting(const char* name, double x, double y, double z);
  void SetSetting(const char* name, double w, double x, double y, double z);
  void SetSetting(const char* name, const char* text);
  double GetSetting(const char* name) const;          ///< the first number; NaN where there is none
  bool IsOn(const char* name) const;                  ///< whether that is 1
  const char* GetSettingText(const char* name) const; ///< "" for numbers; null for an unknown setting
  int GetSettingSize(const char* name) const;         ///< of numbers; 0 for a text
  double* GetSettingNumbers(const char* name) const VTK_SIZEHINT(GetSettingSize(name));
#ifndef __VTK_WRAP__
  void SetSetting(const char* name, int value); ///< so that 0 is a number
#endif
  void SetTouching(bool touching);
  bool GetTouching() const;
  vtkBooleanMacro(Touching, bool);

  /// Whether somebody simulated holds the chosen device; of the running device, else the chosen one: whether it can
  /// push the hand, is the mouse in the view, has lines as walls.
  bool GetDeviceTakesHand() const;
  bool GetDeviceGivesForce() const;
  bool GetFollowsMouse() const;
  bool GetRaisesLines() const;

  /**
   * A new scene: clear, add the surfaces, commit. AddSurface copies polygons and strips of any data object (composite
   * ones too; the skin of a volume mesh) placed by `matrix` (null: as they are); false, with GetProblem(), if there are
   * none. Committing cleans and builds on a worker; until it is done the scene before stays. With nothing touchable in
   * it the force ramps to zero and GetFaultText() says so. FinishScene() waits for the worker; true if something can be
   * touched. A surface added again under its name with unchanged data and matrix is not built again.
   */
  void ClearSurfaces();
  bool AddSurface(const char* name, vtkDataObject* data, vtkMatrix4x4* matrix);
  void CommitScene();
  bool FinishScene();
  /// Gives up the scene that is being made of the newest data: the scene before stays, and the warning says so until
  /// there is another scene or touching begins.
  void CancelScene();
  /// The step of DeviceButton is done, with that file where the button ends with dots. Nothing without such a step.
  void SetDeviceFile(const char* file);
  void PrepareDevice();

  /**
   * Puts a surface that was added under `name` where `matrix` says (null: as its data is), with the next CommitScene().
   * While the change is rigid the surface moves there, in as long as it took from the last commit to this one, 0.2 s at
   * most, and carries or pushes the hand; anything else, and any new data with AddSurface(), is there at once, and the
   * hand stays on its side. False, with GetProblem(), for a matrix that is not finite, singular or a perspective.
   */
  bool SetSurfacePose(const char* name, vtkMatrix4x4* matrix);

  /// In virtual time the simpler surfaces of Simplify wait for this, which waits for them; true if any is felt. They
  /// are no further from the others than a hand notices (7 % of a depth of 1 mm, or the resolution of the device).
  bool FinishSimplification();

  /**
   * How one source is touched, by the name it is added under, from the next time it is added on: not at all, or with a
   * stiffness [N/m], as felt and no more than that of the session, and frictions [1] of its own; infinite, and below 0,
   * as the session has them. An array still says more. False, with GetProblem(), for values that are not allowed.
   */
  void SetSourceTouched(const char* name, bool touched);
  bool GetSourceTouched(const char* name) const;
  bool SetSourceMaterial(const char* name, double stiffness, double frictionStatic, double frictionKinetic);
  void GetSourceMaterial(const char* name, double material[3]) const;

  /**
   * Numbers in space that are felt around the hand, beside whatever surfaces are, as the settings of a field say. Kept
   * by reference; added again after a change. A worker brings the block around the hand, FinishField() waits for that;
   * true if there is one. False, with GetProblem(), for data that cannot be felt so; null data: no field.
   */
  bool AddField(const char* name, vtkDataObject* data);
  bool FinishField();
  const char* GetFieldName() const;

  /// The data of the source that ToolSource names, with their polygons: held in place of the ball from then on, null:
  /// not there. Added again after a change. False, with GetProblem(), for unusable data. Its shape is drawn.
  bool AddTool(const char* name, vtkDataObject* data);
  /// Likewise of SoftSource, made by vtkHapticSoftBody: a soft body. True where the body has bent since the last call.
  bool AddSoftBody(const char* name, vtkDataObject* data);
  bool BendSoftBody(vtkDataObject* body);
  /// Likewise of MechanismSource, made by vtkHapticMechanism: the hand holds a body of it, whose shape and poses are
  /// those of a tool. Without data: why there are none.
  bool AddMechanism(const char* name, vtkDataObject* data, const char* reason = nullptr);

  /// Bounds of the touched scene, else of a mechanism's bodies at first [u]; false and an empty box when there is none.
  bool GetSceneBounds(double bounds[6]) const;
  bool GetSceneMoves() const; ///< whether a surface is felt by a pose: it moves, or has rested for less than a second
  /// Scale and offset such that the device's workspace holds the whole committed scene, once it is built, life size no
  /// longer, and the rotation of a plane world for a device that moves in a plane (PropertyModifiedEvent).
  /// UpdateDataEvent comes before: a follower of a view passes the visible data then.
  void FitWorkspace();
  /// The same for surfaces of some sources, by the names they were added under, a line each; not touched: an error.
  void FitToSources(const char* names);

  /// Whether lines that are walls across one plane are all that is touched; a point of that plane and its unit normal,
  /// in W [u]; how many walls the device holds now; how much of the guide to the plane acts, 0 to 1.
  bool GetPlaneWorld() const;
  bool GetPlane(double point_W[3], double normal_W[3]) const;
  int GetWallsHeld() const;
  double GetGuideShare() const;
  /// Turns the workspace about the hand, such that right, up and towards of the device are those of the view that is
  /// looked at; not for a hand that is said in the scene (devices "fed" and "mouse"), nor for a device that moves in a
  /// plane world.
  void AlignWithView();

  /// Where a program holds the hand (devices "fed" and "mouse"), a point in W [u], and how it is turned, a quaternion
  /// in W. Before the first point there is no hand.
  void SetHandPosition(double x, double y, double z);
  void SetHandPosition(const double p_W[3]);
  void SetHandTurn(double w, double x, double y, double z);
  /// Where a simulated hand is led. A path longer than one point replaces the one before.
  void SetStrokePath(vtkPolyData* path);
  void ClearStrokePoints();
  void AddStrokePoint(double x, double y, double z);
  int GetNumberOfStrokePoints() const;
  /// The data at the contact (vtkHapticInspection), as of the last Update(), which looks them up by itself with
  /// Inspect; without a contact those at the last one, which is kept until another scene is there. False before the
  /// first contact. AddMark() does the same, stores the data and marks the recording.
  bool InspectContact();
  bool AddMark();
  void ClearMarks();

  /// Subjects with methods of their own.
  vtkSmartPointer<vtkHapticKnownDevices> GetDevices();
  vtkSmartPointer<vtkHapticDeviceCheck> GetDeviceCheck();
  vtkSmartPointer<vtkHapticInspection> GetInspection();
  vtkSmartPointer<vtkHapticLabyrinthGame> GetLabyrinth();
  vtkSmartPointer<vtkHapticTouchedMechanism> GetMechanism();
  vtkSmartPointer<vtkHapticSight> GetSight();

  /// Gives the last recording (RecordedFile) that name, after Recording has gone off. A recording goes to
  /// RecordFile, or without one to a temporary file until it is saved; an error leaves it there.
  void SaveRecording(const char* file);
  /// Engage again after a fault; let go at once; a mark in the recording; n ticks of 1 ms of virtual time, in the
  /// calling thread, deterministic to the last bit.
  void Engage();
  void Release();
  void Mark();
  void Step(int ticks);

  /// Takes the latest state and a scene that the worker has finished. Microseconds; call it every frame.
  void Update();

  /// Order of the states as GetEngageState() gives them.
  enum EngageStates
  {
    Safe,
    Armed,
    Engaged,
    Faulted
  };

  /// As of the last Update().
  int GetEngageState() const;
  double* GetHandPosition() VTK_SIZEHINT(3);
  vtkHapticTableReadoutsMacro();

#ifndef __VTK_WRAP__
  class Internals; ///< for the parts behind a session
  Internals& Behind();
#endif

protected:
  vtkHapticSession();
  ~vtkHapticSession() override;

private:
  double GetReadout(const char* name) const;
  const char* GetReadoutText(const char* name) const;
  double* GetReadoutNumbers(const char* name) const;

  std::unique_ptr<Internals> Impl;
};

#endif
