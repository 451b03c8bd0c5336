// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticSession
 * @brief   touches surfaces with a haptic device: settings in, state out
 *
 * Owns a device, a servo at 1 kHz and a scene. Settings take effect at the next tick; the state is that of the last
 * Update(). In ParaView it is the proxy "HapticSession" of group "haptics", written to the state file once registered.
 *
 * What each setting is, its unit, range and default, when it takes effect, and what each read-out says, is described
 * once in haptics/session/settings/: GetDescribed() has it as JSON, plugin/README.md as tables. A value that is not
 * allowed is an error, the old one stays, and GetProblem() says why until an allowed one is set.
 *
 * One thread, its maker's, calls every method; none waits for the servo but TouchingOff() and the destructor, which end
 * it at no force. Lengths and points are in scene units u and frame W unless said otherwise.
 */
#ifndef vtkHapticSession_h
#define vtkHapticSession_h

#include "vtkHapticInteractionModule.h" // for the export macro
#include "vtkHapticSessionDescribed.h"  // for settings and read-outs
#include "vtkHapticSessionMacros.h"     // for what no table describes
#include "vtkObject.h"

#include <functional>       // for an argument
#include <initializer_list> // for an argument
#include <memory>           // for the implementation
#include <string>           // for an argument

namespace palpate
{
struct BuiltScene;
class HapticDevice;
class HidBus;
struct HandMapChange;
struct HapticParameters;
} // namespace palpate

struct vtkHapticFieldArrays;
struct vtkHapticFieldResult;
struct vtkHapticMaterialSettings;
class vtkCamera;
class vtkHapticMarkRecords;
class vtkHapticServerSurfaces;
class vtkDataObject;
class vtkMatrix4x4;
class vtkPolyData;
class vtkTable;

class VTKHAPTICINTERACTION_EXPORT vtkHapticSession : public vtkObject
{
public:
  static vtkHapticSession* New();
  vtkTypeMacro(vtkHapticSession, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Every setting and read-out as JSON: {"settings": [{"name", "unit", "defaults", ...}, ...], "readouts": [...]}.
  static const char* GetDescribed();

  /// Order of the choices as SetSimplify() and SetLinesAsWalls() take them.
  enum SimplifyChoices
  {
    Auto,
    Off,
    On
  };

  /// Order of the methods as SetVelocityMethod() takes them.
  enum VelocityMethods
  {
    BackwardDifference,
    LowPass,
    AdaptiveWindow
  };

  /// Order of the choices as SetViewAlignment() takes them.
  enum ViewAlignments
  {
    AlignNever,
    AlignWhenTouched,
    AlignAlways
  };

  /** @name Settings
   * Those of surfaces (LineRadius, LinesAsWalls, arrays) are felt on surfaces that are added later. Velocities: Janabi-
   * Sharifi et al. 2000; passivity: Hannaford & Ryu 2002, one tick ahead; friction: Harwin & Melder 2002, in any order
   * of the two calls; shading: Morgenbesser & Srinivasan 1996, which has no potential: a closed way may take or give a
   * little work. Held walls drag a handle along a slanted line by stiffness * speed / WallRate / 2. If touching cannot
   * start it stays off; StartEvent is the last moment to say where a program's hand begins, and comes again when scale,
   * rotation or offset change meanwhile. */
  ///@{
  vtkHapticSettingsMacro();
  ///@}

  ///@{
  /// Devices this build knows and those that were plugged in when they were last looked for, why one cannot be used (""
  /// when it can), and whether a program must lead its hand. Looking takes milliseconds.
  void LookForDevices();
  int GetNumberOfKnownDevices() const;
  const char* GetKnownDeviceName(int index) const;
  const char* GetKnownDeviceProblem(int index) const;
  bool GetKnownDeviceForPrograms(int index) const;
  /// What a person most likely means: what is plugged in and pushes, else what is plugged in, else the mouse.
  const char* GetPreferredDevice() const;
  ///@}

#ifndef __VTK_WRAP__
  /// Where devices of the USB bus are looked for; null (default): on this computer.
  void SetHidBus(std::shared_ptr<palpate::HidBus> bus);
#endif

  ///@{
  /// Whether somebody simulated holds the chosen device; of the running device, else the chosen one: whether it can
  /// push the hand, is the mouse in the view, has lines as walls.
  vtkHapticReadoutsMacro(bool, DeviceTakesHand, DeviceGivesForce, FollowsMouse);
  bool GetRaisesLines() const;
  ///@}

  ///@{
  /// The link to a running device of this computer's USB bus: reports with the hand in the last second [Hz]; writes
  /// that hung, losses (stalls included), reports that were no known ones or too short, effects that were renewed.
  double GetLinkRate() const;
  vtkHapticReadoutsMacro(vtkIdType, LinkStalls, LinkLosses, LinkStrange);
  vtkIdType GetLinkRestarts() const;
  ///@}

  /// Order of the states as GetSelfTestState() gives them; all from CheckPassed on are final.
  enum SelfTestStates
  {
    CheckNone,
    CheckRuns,
    CheckPassed,
    CheckFaulty,
    CheckInconclusive,
    CheckAborted
  };

  ///@{
  /**
   * Checks the chosen device with a person who does what GetSelfTestAsk() says: noise, ends, then pushes of at most a
   * tenth of its force and half a second each, by motors alone, into walls that the device holds, and against its
   * viscosity; anything unexpected ends them at once. Not while touching; a device without force is refused. Simulated
   * hands do what is asked. Update() follows it; the result is "" before the end, progress 0 to 1.
   */
  void StartSelfTest();
  void StopSelfTest();
  int GetSelfTestState() const;
  double GetSelfTestProgress() const;
  const char* GetSelfTestAsk() const;
  const char* GetSelfTestResult() const;
  ///@}

  ///@{
  /**
   * Folder with what is known of devices: directions, ends, and whether walls may be left to them; that holds for this
   * session only where a device has no serial number. Applied whenever a device is opened; one whose file is damaged is
   * refused by name. "" (default): none is. KeepCalibration() adds what a passed check found; false, with GetProblem(),
   * if there is none or it cannot be written.
   */
  vtkHapticSettingMacro(CalibrationFolder, const char*);
  bool KeepCalibration();
  ///@}

  ///@{
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
  /// Whether AddSurface() would not hold its caller for longer than a picture takes; else a thread begins to read these
  /// data, and the answer is true once it is done.
  bool PrepareSurface(const char* name, vtkDataObject* data, vtkMatrix4x4* matrix);
  /// What is being made of the newest data is not wanted: what was touched before stays, and the warning says so until
  /// there is another scene or touching begins. How often that was done.
  void CancelScene();
  /// What PrepareSurface() began is not wanted any more, for something else is shown.
  void ForgetPrepared();
  int GetScenesCancelled() const;
  ///@}

  /**
   * Puts a surface that was added under `name` where `matrix` says (null: as its data is), with the next CommitScene().
   * While what changes is rigid the surface moves there, in as long as it took from the last commit to this one, 0.2 s
   * at most, and carries or pushes the hand; anything else, and any new data with AddSurface(), is there at once, and
   * the hand stays on its side. False, with GetProblem(), for a matrix that is not finite, singular or a perspective.
   */
  bool SetSurfacePose(const char* name, vtkMatrix4x4* matrix);

  /// In virtual time the simpler surfaces of Simplify wait for this, which waits for them; true if any is felt. They
  /// are no further from the others than a hand notices (7 % of a depth of 1 mm, or what the device resolves).
  bool FinishSimplification();

  ///@{
  /**
   * How one source is touched, by the name it is added under, from the next time it is added on: not at all, or with a
   * stiffness [N/m], as felt and no more than that of the session, and frictions [1] of its own; infinite, and below 0,
   * as the session has them. An array still says more. False, with GetProblem(), for what cannot be.
   */
  void SetSourceTouched(const char* name, bool touched);
  bool GetSourceTouched(const char* name) const;
  bool SetSourceMaterial(const char* name, double stiffness, double frictionStatic, double frictionKinetic);
  void GetSourceMaterial(const char* name, double material[3]) const;
  ///@}

  ///@{
  /**
   * Numbers in space that are felt around the hand, beside whatever surfaces are, as the settings of a field say. Kept
   * by reference; added again after a change. A worker brings what is around the hand, FinishField() waits for that;
   * true if there is something. False, with GetProblem(), for what cannot be felt so; null data: no field.
   */
  bool AddField(const char* name, vtkDataObject* data);
  bool FinishField();
  const char* GetFieldName() const;
  bool AddRemoteField(const char* name, const vtkHapticFieldResult& made); ///< of data elsewhere, made there
  vtkHapticServerSurfaces& ServerSurfaces() const;                         ///< what is there of surfaces elsewhere
  /// Other data that the field is compared with, and whose points and lines the hand snaps to; null: none. Kept by
  /// reference. FeltSource, CompareSource and SnapSource name all of them for whoever follows a view.
  void SetFieldBeside(vtkDataObject* compared, vtkDataObject* snap);
  /// What is felt of it where the proxy is, to be drawn: patch, streamline, level, the place that is snapped to [u].
  void GetFieldShape(vtkPolyData* shape) const;
  ///@}

  ///@{
  /// What the source that ToolSource names has, polygons as they are: held in place of the ball from then on, null: not
  /// there. Added again after a change. False, with GetProblem(), for what cannot be held. Its shape is drawn.
  bool AddTool(const char* name, vtkDataObject* data);
  void GetToolShape(vtkPolyData* shape) const;
  /// How far it reaches from the hand against a direction, turned as it is [u]; 0: none is held.
  double GetToolReach(const double direction_W[3]) const;
  /// Likewise of SoftSource, made by vtkHapticSoftBody: it gives way. True where it has bent since it was asked last.
  bool AddSoftBody(const char* name, vtkDataObject* data);
  bool BendSoftBody(vtkDataObject* body);
  /// Likewise of MechanismSource, made by vtkHapticMechanism: the hand holds a body of it, whose shape and poses are
  /// those of a tool. Without data: why there are none. Moves and bends shapes; false: they are as at first.
  bool AddMechanism(const char* name, vtkDataObject* data, const char* reason = nullptr);
  const char* GetAddedMechanism() const; ///< whose was added last; "": none since MechanismSource is another
  void SetMechanismMoved(bool moved);    ///< whether it is drawn elsewhere than it is felt, for MechanismText to say so
  bool MoveMechanism(vtkPolyData* shapes);
  void GetMechanismTable(vtkTable* table) const; ///< a row a law: what it is, Phase, Force [N], Inside [u]
  /// What MechanismLaws is with another law, an object as in a scene file, and with one less; "", with GetProblem().
  std::string GetLawsWith(const char* law);
  std::string GetLawsWithout(const char* name);
  bool BreakLaw(const char* name); ///< it holds no more until the mechanism begins anew; false: there is none
  ///@}

  vtkMTimeType GetMaterialTime() const; ///< changes whenever a setting of surfaces does
  bool GetUsesMaterialArrays() const;   ///< whether any is named

  /// Bounds of the touched scene, else of a mechanism's bodies at first [u]; false and an empty box when there is none.
  bool GetSceneBounds(double bounds[6]) const;
  bool GetSceneMoves() const; ///< whether a surface is felt by a pose: it moves, or has rested for less than a second

  /// Scale and offset such that the device's workspace holds the whole committed scene, once it is built, life size no
  /// longer, and the rotation of a plane world for a device that moves in a plane (PropertyModifiedEvent).
  /// UpdateDataEvent comes before: whoever follows a view hands over what it shows now.
  void FitWorkspace();
  /// Whether lines that are walls across one plane are all that is touched; a point of that plane and its unit normal,
  /// in W [u]; how many walls the device holds now; how much of the guide to the plane acts, 0 to 1.
  bool GetPlaneWorld() const;
  bool GetPlane(double point_W[3], double normal_W[3]) const;
  int GetWallsHeld() const;
  double GetGuideShare() const;
  ///@}

  /// The same for surfaces of some sources, by the names they were added under, a line each; not touched: an error.
  void FitToSources(const char* names);

  ///@{
  /// The camera of the view that is looked at: whoever follows one says it before each Update(). AlignWithView() turns
  /// the workspace about the hand, such that right, up and towards of the device are those of the view; not for a hand
  /// that is said in the scene (devices "fed" and "mouse"), nor for a device that moves in a plane world.
  void FollowCamera(vtkCamera* camera);
  void AlignWithView();
  ///@}
  /// Corners of the box around the ball that the device reaches, of bits x, y, z, [u].
  void GetWorkspaceCorners(double corners_W[24]) const;

  ///@{
  /// Where a program holds the hand (devices "fed" and "mouse"): a point in W [u]. Before the first there is no hand.
  void SetHandPosition(double x, double y, double z);
  void SetHandPosition(const double p_W[3]);
  /// How it is turned, a quaternion in W.
  void SetHandTurn(double w, double x, double y, double z);
  /// Where a simulated hand is led. A path longer than one point replaces the one before.
  void SetStrokePath(vtkPolyData* path);
  void ClearStrokePoints();
  void AddStrokePoint(double x, double y, double z);
  int GetNumberOfStrokePoints() const;
  ///@}

  /// Where the ball is first stopped on its way from one point to another: its centre and the unit normal of what stops
  /// it, to its side. False, and both unchanged, where nothing does.
  bool PickSurface(const double from_W[3], const double to_W[3], double ball_W[3], double normal_W[3]) const;

  /// From where the hand of the device "mouse" is seen, in W [u]: a surface that comes between stays behind the hand,
  /// which begins anew in front of it (StartEvent). Whoever follows a camera says it before each Update().
  void SetEye(const double p_W[3]);

  ///@{
  /**
   * What is at the contact: its source, cell, point and arrays as it was added, the place and normal in W, curvature
   * and the wall behind it. InspectContact() looks it up as of the last Update(), which does so by itself with Inspect;
   * false without a contact. AddMark() does the same, keeps what it found and marks the recording. GetMarks() gives
   * points, GetMarksTable() a table, GetMarksText() what HapticMarks takes; WriteMarks() writes csv or vtp by the
   * suffix; false with GetProblem(). The first place on a source takes longer: a second for a million cells. A mark
   * holds while the cell that it was set on is where the mark is; else its source has changed or moved, and it is
   * stale. One whose source is not in the scene is unseen.
   */
  enum MarkStates
  {
    MarkUnseen,
    MarkHolds,
    MarkStale
  };
  bool InspectContact();
  bool AddMark();
  void ClearMarks();
  int GetMarkState(int mark) const;
  bool WriteMarks(const char* file);
  void GetMarks(vtkPolyData* points) const;
  void GetMarksTable(vtkTable* table) const;
  double GetContactValue(const char* name) const; ///< of an array there, name_k of a vector; NaN where there is none
  ///@}

  /// The game of finding the way through lines with the field arrays Start and Exit (vtkHapticLabyrinth): it sets ball,
  /// scale and place so that the device's workspace holds the whole. Once force is engaged the hand is brought to the
  /// start, at most 0.2 m/s fast, and let go; at the exit it is shaken. Who lets go of the dead-man and holds it again
  /// starts anew, as does PlayAgain(). What is touched are the surfaces, so the lines are added as one. A world without
  /// start or exit is fitted too and explored without a game: false, and GetProblem() says which it lacks. False with
  /// an error and nothing changed for what is no plane world.
  bool PlayLabyrinth(vtkDataObject* maze, const char* name);

  ///@{
  /// Phases: "off", "waits", "leads", "lets go", "explores", "arrived" or "rests", as text in words for the person;
  /// time of exploring [s]; where the labyrinth that was played last begins and ends, in W, and how near counts as
  /// there [u].
  void PlayAgain();
  void EndLabyrinth();
  bool GetLabyrinthPlayed() const;
  const char* GetLabyrinthPhase() const;
  const char* GetLabyrinthText() const;
  double GetLabyrinthTime() const;
  void GetLabyrinthPlaces(double start_W[3], double exit_W[3]) const;
  double GetLabyrinthReach() const;
  /// By how much that labyrinth must be enlarged for neighbouring corridors to be told apart [1], at least 1, infinite
  /// without stiffness; the narrowest corridor that can be: 2 F / K [m of the hand], F = 1 N.
  double GetFeelableZoom() const;
  double GetFeelableWidth() const;
  /// The way of the proxy since it was let go, until now or the exit: a polyline in W [u], as the calls of Update() saw
  /// it. At most 4096 points, a tenth of a corridor apart; twice as far each time that is not enough.
  void GetLabyrinthTrace(vtkPolyData* trace) const;
  /// Which labyrinth the device's buttons asked for since the last call, while no game is played: button n for number
  /// n, a button of the dead-man for none; 0: none.
  int TakeLabyrinthWish();
  ///@}

  /// Gives the last recording (RecordedFile) that name, after Recording has gone off. What is recorded goes to
  /// RecordFile, or without one to a temporary file until it is saved; an error leaves it there.
  void SaveRecording(const char* file);

  ///@{
  /// Engage again after a fault; let go at once; a mark in the recording; n ticks of 1 ms of virtual time, in the
  /// calling thread, deterministic to the last bit.
  void Engage();
  void Release();
  void Mark();
  void Step(int ticks);
  ///@}

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

  ///@{
  /// As of the last Update().
  int GetEngageState() const;
  double* GetHandPosition() VTK_SIZEHINT(3);
  vtkHapticTableReadoutsMacro();
  ///@}

protected:
  vtkHapticSession();
  ~vtkHapticSession() override;

private:
  vtkHapticSession(const vtkHapticSession&) = delete;
  void operator=(const vtkHapticSession&) = delete;

  void Refuse(const std::string& problem);
  void KeepMarks(vtkHapticMarkRecords marks);
  void HoldTool(const std::string& problem);
  /// The styles of sources have changed.
  void FollowSources();
  /// Looks at it if that is wanted, and sets a mark if its button was pressed.
  void FollowContact();
  void Start();
  void Stop();
  /// Takes over what has ended, and says what went wrong with it.
  void FollowRecording();
  /// A device that plays a recording moves the hand where it moved: the map of the recording.
  void Play(palpate::HapticDevice& device);
  /// The map does what clutch, precision and view ask for.
  void FollowHand();
  void FollowMouseClutch();
  void AlignOnTouch(palpate::HapticDevice& device);
  /// Touching has ended: nothing is held any more.
  void LetHandGo();
  /// The map that the session makes by itself.
  void TakeMap(const palpate::HandMapChange& change);
  /// Takes what the worker has built, or with `wait` what was committed last. A hand that it surrounds stays outside.
  void TakeScene(bool wait = false);
  void TakeOutSqueezed();
  void FollowCameAround();
  void Fit();
  void FitTo(const palpate::BuiltScene& scene);
  /// Whether a described setting may have these values; else that is refused and said.
  bool Allows(const char* setting, std::initializer_list<double> values);
  /// Setting and getting what is a field of the tick's parameters; the numbers stay until the same is asked for again.
  void SetField(const char* setting, std::initializer_list<double> values);
  double* GetField(const char* setting) const;
  /// Sets parameters changed by `change`; keeps the old ones if those are refused or the setting does not allow them.
  void Change(const std::function<void(palpate::HapticParameters&)>& change);
  void Change(const char* setting, std::initializer_list<double> values,
    const std::function<void(palpate::HapticParameters&)>& change);
  void TakeField(bool wait);
  void FeelFieldAnew();
  void NameSource(std::string& kept, const char* name);
  void ChangeField(const char* setting, std::initializer_list<double> values,
    const std::function<void(vtkHapticFieldArrays&)>& change);
  void ChangeMaterial(const char* setting, std::initializer_list<double> values,
    const std::function<void(vtkHapticMaterialSettings&)>& change);

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
