// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticSession
 * @brief   touches surfaces with a haptic device: settings in, state out
 *
 * Owns a device, a servo at 1 kHz and a scene. Settings take effect at the next tick; the state is that of the last
 * Update(). In ParaView it is the proxy "HapticSession" of group "haptics", written to the state file once registered.
 *
 *     session = vtkHapticSession()
 *     session.SetDeviceName("fed")
 *     session.AddSurface("sphere", poly_data, None)
 *     session.CommitScene()
 *     session.TouchingOn()
 *     session.SetHandPosition(0, 0, 0.4)
 *     session.Update()
 *     session.GetForce()
 *
 * One thread, the one that made it, calls every method; none waits for the servo except TouchingOff() and the
 * destructor, which end it with the force at zero. Lengths and points are in scene units u and frame W unless said
 * otherwise.
 */
#ifndef vtkHapticSession_h
#define vtkHapticSession_h

#include "vtkHapticInteractionModule.h" // for the export macro
#include "vtkObject.h"

#include <functional> // for an argument
#include <memory>     // for the implementation
#include <string>     // for an argument

namespace palpate
{
class HidBus;
struct HapticParameters;
} // namespace palpate

struct vtkHapticMaterialSettings;
class vtkDataObject;
class vtkMatrix4x4;
class vtkPolyData;

class VTKHAPTICINTERACTION_EXPORT vtkHapticSession : public vtkObject
{
public:
  static vtkHapticSession* New();
  vtkTypeMacro(vtkHapticSession, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Order of the states as GetEngageState() gives them.
  enum EngageStates
  {
    Safe = 0,
    Armed = 1,
    Engaged = 2,
    Faulted = 3,
  };

  ///@{
  /**
   * Who moves the hand: a name from GetKnownDeviceName(). Default "fed": poses come from SetHandPosition(). An unknown
   * name is an error that names the known ones, and what was there before stays. Takes effect when touching starts.
   */
  virtual void SetDeviceName(const char* name);
  virtual const char* GetDeviceName() const;
  ///@}

  ///@{
  /// Devices this build knows and those that were plugged in when they were last looked for, and why one cannot be used
  /// ("" when it can). Looking takes milliseconds.
  void LookForDevices();
  int GetNumberOfKnownDevices() const;
  const char* GetKnownDeviceName(int index) const;
  const char* GetKnownDeviceProblem(int index) const;
  ///@}

#ifndef __VTK_WRAP__
  /// Where devices of the USB bus are looked for; null (default): on this computer.
  void SetHidBus(std::shared_ptr<palpate::HidBus> bus);
#endif

  ///@{
  /// What the chosen device is ("2 axes of force"), and why it cannot be used or what it cannot do, "" if nothing; of a
  /// running one what it really cannot.
  const char* GetDeviceKind() const;
  const char* GetDeviceNotes() const;
  ///@}

  ///@{
  /**
   * The link to a running device of this computer's USB bus: in one sentence, "" for other devices; reports with the
   * hand in the last second [Hz]; writes that hung, times it was lost (stalls included), reports that were no known
   * ones or too short, effects that were renewed before they ended by themselves.
   */
  const char* GetLinkText() const;
  double GetLinkRate() const;
  vtkIdType GetLinkStalls() const;
  vtkIdType GetLinkLosses() const;
  vtkIdType GetLinkStrange() const;
  vtkIdType GetLinkRestarts() const;
  ///@}

  /// Order of the states as GetSelfTestState() gives them; all from CheckPassed on are final.
  enum SelfTestStates
  {
    CheckNone = 0,
    CheckRuns = 1,
    CheckPassed = 2,
    CheckFaulty = 3,
    CheckInconclusive = 4,
    CheckAborted = 5,
  };

  ///@{
  /**
   * The chosen device is a wheel, whatever it calls itself: only its x is there. From the next touch or check on; off
   * by default. A check finds it out by itself where nobody can move a second axis.
   */
  virtual void SetWheel(bool on);
  virtual bool GetWheel() const;
  vtkBooleanMacro(Wheel, bool);
  ///@}

  ///@{
  /**
   * Checks the chosen device with a person who does what GetSelfTestAsk() says: noise, ends, then pushes of at most a
   * tenth of its force and half a second each, by motors alone, into walls that the device holds, and against its
   * viscosity; anything unexpected ends them at once. Not while touching; a device
   * without force is refused. Simulated hands do what is asked. Update() follows it; GetSelfTestResult() says what was
   * found, "" before the end; progress is 0 to 1.
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
   * session only where a device has no serial number. It is applied to a device whenever it is opened; a device
   * whose file is damaged is refused by name. "" (default): none is. KeepCalibration() adds what a passed check found;
   * false, with GetProblem(), if there is none or it cannot be written.
   */
  virtual void SetCalibrationFolder(const char* folder);
  virtual const char* GetCalibrationFolder() const;
  bool KeepCalibration();
  ///@}

  ///@{
  /**
   * Device on, servo on, force engaged through its ramp; off: force to zero, servo ended. If it cannot start it stays
   * off and GetProblem() says why. Default off. StartEvent is the last moment to say where a program's hand begins; it
   * comes again when scale, rotation or offset change meanwhile.
   */
  virtual void SetTouching(bool touching);
  virtual bool GetTouching() const;
  vtkBooleanMacro(Touching, bool);
  ///@}

  ///@{
  /// Spring between hand and proxy [N/m], >= 0, default 500.
  virtual void SetStiffness(double stiffness_N_per_m);
  virtual double GetStiffness() const;
  ///@}

  ///@{
  /// One-sided damping [N s/m], >= 0, default 0: brakes a hand that goes in, never one that leaves.
  virtual void SetDamping(double damping_Ns_per_m);
  virtual double GetDamping() const;
  ///@}

  ///@{
  /// Stiffness no higher than what the device and the rate can hold (GetLargestStiffness()). Default on.
  virtual void SetLimitStiffness(bool on);
  virtual bool GetLimitStiffness() const;
  vtkBooleanMacro(LimitStiffness, bool);
  ///@}

  ///@{
  /**
   * Damps the spring just as much as a force held for a period would otherwise give back more than it took (Hannaford &
   * Ryu 2002, one tick ahead). No force in free air, none on devices that push nobody. Default on.
   */
  virtual void SetPassivity(bool on);
  virtual bool GetPassivity() const;
  vtkBooleanMacro(Passivity, bool);
  ///@}

  ///@{
  /**
   * Ticks between a force and its effect beyond the hold itself, 0 to 16, default 0: what is known of the device's
   * link. The link of a simulated device has that delay, from when touching starts.
   */
  virtual void SetDelay(int ticks);
  virtual int GetDelay() const;
  ///@}

  /// Order of the methods as SetVelocityMethod() takes them.
  enum VelocityMethods
  {
    BackwardDifference = 0,
    LowPass = 1,
    AdaptiveWindow = 2,
  };

  ///@{
  /// How the hand's velocity is made from its positions. Default AdaptiveWindow (Janabi-Sharifi et al. 2000).
  virtual void SetVelocityMethod(int method);
  virtual int GetVelocityMethod() const;
  ///@}

  ///@{
  /**
   * Who holds a simulated device: "none", "light", "stylus" (default) or "firm". Another name is an error that lists
   * them. Takes effect when touching starts; GetDeviceTakesHand() is false for devices that nobody simulated holds.
   */
  virtual void SetHand(const char* name);
  virtual const char* GetHand() const;
  bool GetDeviceTakesHand() const;
  ///@}

  ///@{
  /// Ball that touches [u], >= 0, default 0: a point.
  virtual void SetRadius(double radius_u);
  virtual double GetRadius() const;
  ///@}

  ///@{
  /**
   * Ball no larger than one whose work fits into a tick: GetRadiusLimit() [u], which the worker counts in the trees of
   * a new scene; infinity where any ball does, and before there is a scene. GetRadiusUsed() is the ball that touches.
   * Off: the one asked for, however large; it may lag. Default on.
   */
  virtual void SetLimitRadius(bool on);
  virtual bool GetLimitRadius() const;
  vtkBooleanMacro(LimitRadius, bool);
  double GetRadiusLimit() const;
  double GetRadiusUsed() const;
  ///@}

  ///@{
  /// Radius of the tubes as which lines (streamlines, centre lines, fibres) are touched [u], >= 0, default 0: they are
  /// not touched, which GetSceneReport() says. Surfaces that are added later feel it.
  virtual void SetLineRadius(double radius_u);
  virtual double GetLineRadius() const;
  ///@}

  /** @name Plane worlds
   * Lines that lie in one plane, as Image Curves and slices give them, are walls across it, felt in that plane by a
   * disc. */
  ///@{
  /// Whether lines that lie in a plane are such walls, instead of tubes of LineRadius: with Auto (default) on devices
  /// that move in a plane only. Surfaces that are added later feel it.
  virtual void SetLinesAsWalls(int choice);
  virtual int GetLinesAsWalls() const;
  /// What that comes to with the running device, else the chosen one.
  bool GetRaisesLines() const;
  ///@}

  ///@{
  /// Whether a device that can holds the walls of a plane world by itself, at most four, in its own loop and with the
  /// viscosity that keeps narrow corridors still; the plan's sentence says if it does. Default on.
  virtual void SetHoldWalls(bool on);
  virtual bool GetHoldWalls() const;
  vtkBooleanMacro(HoldWalls, bool);
  ///@}

  ///@{
  /// How often held walls are moved on at most [Hz], 20 to 1000, default 125: along a slanted line a handle is dragged
  /// by stiffness * speed / rate / 2.
  virtual void SetWallRate(double rate_Hz);
  virtual double GetWallRate() const;
  ///@}

  ///@{
  /// Leads the hand to the plane of a plane world with 200 N/m and at most 2 N, from nothing within half a second, and
  /// touches what is below the hand in that plane. Default on; where not all that is touched is walls across one plane
  /// it does nothing.
  virtual void SetPlaneGuide(bool on);
  virtual bool GetPlaneGuide() const;
  vtkBooleanMacro(PlaneGuide, bool);
  ///@}

  ///@{
  /// Whether what is touched is a plane world; how many walls the device holds now; how much of the guide acts, 0 to 1.
  bool GetPlaneWorld() const;
  int GetWallsHeld() const;
  double GetGuideShare() const;
  ///@}

  /// A point of the plane of a plane world and its unit normal, in W [u]; false where what is touched is none.
  bool GetPlane(double point_W[3], double normal_W[3]) const;

  ///@{
  /**
   * The game of finding the way through lines with the field arrays Start and Exit (vtkHapticLabyrinth): it sets ball,
   * scale and place so that the device's workspace holds the whole. Once force is engaged the hand is brought to the
   * start, at most 0.2 m/s fast, and let go; at the exit it is shaken. Who lets go of the dead-man and holds it again
   * starts anew, as does PlayAgain(). What is touched are the surfaces, so the lines are added as one. A world without
   * start or exit is fitted too and explored without a game: false, and GetProblem() says which it lacks. False with an
   * error and nothing changed for what is no plane world.
   */
  bool PlayLabyrinth(vtkDataObject* maze, const char* name);
  void PlayAgain();
  void EndLabyrinth();
  bool GetLabyrinthPlayed() const;
  /// Where the labyrinth that was played last begins and where it ends, in W, and how near counts as there [u].
  void GetLabyrinthPlaces(double start_W[3], double exit_W[3]) const;
  double GetLabyrinthReach() const;
  /// "off", "waits", "leads", "lets go", "explores", "arrived" or "rests"; time of exploring [s].
  const char* GetLabyrinthPhase() const;
  double GetLabyrinthTime() const;
  /// The phase in words for the person: who has a device without force goes to the start alone.
  const char* GetLabyrinthText() const;
  /// Whether the running device, else the chosen one, can push the hand, so bring it to the start.
  bool GetDeviceGivesForce() const;
  ///@}

  ///@{
  /**
   * By how much the labyrinth that was played last must be enlarged, about the hand say, for neighbouring corridors to
   * be told apart [1], at least 1: 1 where everything can be felt, or nothing was played; infinite without stiffness.
   * The narrowest corridor that can be told apart is 2 F / K wide [m of the hand], F = 1 N, K the stiffness that is
   * used.
   */
  double GetFeelableZoom() const;
  double GetFeelableWidth() const;
  ///@}

  /**
   * The way of the proxy since it was let go, until now or until the exit: a polyline in W [u], as the calls of
   * Update() saw it. At most 4096 points, a tenth of a corridor apart; twice as far each time that is not enough. Null
   * is left alone.
   */
  void GetLabyrinthTrace(vtkPolyData* trace) const;

  /// Which labyrinth the device's buttons asked for since the last call, while no game is played: button n for number n,
  /// a button of the dead-man for none; 0: none.
  int TakeLabyrinthWish();

  /// Order of the choices as SetSimplify() and SetLinesAsWalls() take them.
  enum SimplifyChoices
  {
    Auto = 0,
    Off = 1,
    On = 2,
  };

  ///@{
  /**
   * Whether surfaces that are finer than a hand feels are replaced by simpler ones: once a scene is felt as it is they
   * are looked for meanwhile, and swapped in where it is proven that no point of either surface is further from the
   * other than a hand notices (7 % of a depth of 1 mm, or what the device resolves) and half of the triangles go. Lines
   * are felt at their coarsest level within that distance, joined and crossed as before. Never those that move, deform
   * or have material arrays; with Auto (default) no surface of fewer than 50,000 triangles, and no lines of which fewer
   * than 64 segments are shorter than 1/32 mm in the hand. In virtual time they wait for FinishSimplification(), which
   * waits for them; true if any is felt.
   */
  virtual void SetSimplify(int choice);
  virtual int GetSimplify() const;
  bool FinishSimplification();
  ///@}

  /// What is felt of the scene and why, in one sentence: how many triangles, by a point or a ball, with what friction.
  const char* GetPlanSentence() const;

  ///@{
  /// Scene units per metre of the hand's motion, > 0. Default 1000: data in millimetres feels as large as it is.
  virtual void SetScale(double scale_u_per_m);
  virtual double GetScale() const;
  ///@}

  ///@{
  /**
   * Coulomb friction between ball and surfaces [1]: what holds at rest, 0 (none, default) to 10, and what brakes while
   * it slides, 0 (default) or more. No more than the static one is used of the kinetic one (GetFrictionKineticUsed()),
   * so the order of the two calls does not matter (Harwin & Melder 2002).
   */
  virtual void SetFrictionStatic(double coefficient);
  virtual double GetFrictionStatic() const;
  virtual void SetFrictionKinetic(double coefficient);
  virtual double GetFrictionKinetic() const;
  double GetFrictionKineticUsed() const;
  ///@}

  ///@{
  /**
   * What the hand must hold to be pushed: buttons (bit i: button i + 1 will do; default 0) or the grip sensor
   * (default off); none of both: nothing. Let go, the force is zero within 50 ms and starts again from a small one.
   */
  virtual void SetDeadManButtons(int mask);
  virtual int GetDeadManButtons() const;
  virtual void SetDeadManGrip(bool on);
  virtual bool GetDeadManGrip() const;
  vtkBooleanMacro(DeadManGrip, bool);
  ///@}

  ///@{
  /**
   * Smooth forces over the facets of a mesh (Morgenbesser & Srinivasan 1996), never across edges sharper than 30
   * degrees. Such a force has no potential: a closed way may take or give a little work. Default off.
   */
  virtual void SetForceShading(bool on);
  virtual bool GetForceShading() const;
  vtkBooleanMacro(ForceShading, bool);
  ///@}

  /** @name Material from data
   * From an array of the points, or else the cells, of a surface (cells: the mean of those around a point): its name
   * ("", default: none), its component (-1, default: the length of a vector, the value of a scalar), a data range
   * (equal ends, default: the array's own) and what its two ends feel like: linear between, level beyond. Where a value
   * is not finite the surface's own is felt. A surface without the array keeps its own; GetSceneReport() says what each
   * array gives. Surfaces that are added later feel it; none is built again for that.
   */
  ///@{
  /// [N/m], >= 0, default 100 to 1000: what is felt, up to the stiffness of the spring between hand and proxy.
  virtual void SetStiffnessArray(const char* name);
  virtual const char* GetStiffnessArray() const;
  virtual void SetStiffnessComponent(int component);
  virtual int GetStiffnessComponent() const;
  virtual void SetStiffnessDataRange(double low, double high);
  virtual double* GetStiffnessDataRange() VTK_SIZEHINT(2);
  virtual void SetStiffnessFeltRange(double atLow, double atHigh);
  virtual double* GetStiffnessFeltRange() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /// [1], 0 to 10, default 0 to 1: at rest and sliding alike.
  virtual void SetFrictionArray(const char* name);
  virtual const char* GetFrictionArray() const;
  virtual void SetFrictionComponent(int component);
  virtual int GetFrictionComponent() const;
  virtual void SetFrictionDataRange(double low, double high);
  virtual double* GetFrictionDataRange() VTK_SIZEHINT(2);
  virtual void SetFrictionFeltRange(double atLow, double atHigh);
  virtual double* GetFrictionFeltRange() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /// [u], default 0 to 1: heights, of which the highest is the surface and lower ones are hollows; their mean for a
  /// hand too fast for them.
  virtual void SetTextureArray(const char* name);
  virtual const char* GetTextureArray() const;
  virtual void SetTextureComponent(int component);
  virtual int GetTextureComponent() const;
  virtual void SetTextureDataRange(double low, double high);
  virtual double* GetTextureDataRange() VTK_SIZEHINT(2);
  virtual void SetTextureFeltRange(double atLow, double atHigh);
  virtual double* GetTextureFeltRange() VTK_SIZEHINT(2);
  ///@}

  /// Changes whenever one of these settings does; whether any array is named.
  vtkMTimeType GetMaterialTime() const;
  bool GetUsesMaterialArrays() const;

  ///@{
  /// From device to scene frame, a unit quaternion (w, x, y, z). Default (1, 0, 0, 0).
  virtual void SetRotation(double w, double x, double y, double z);
  virtual void SetRotation(const double wxyz[4]);
  virtual double* GetRotation() VTK_SIZEHINT(4);
  ///@}

  ///@{
  /// Where the device's origin is in the scene [u]. Default (0, 0, 0).
  virtual void SetOffset(double x, double y, double z);
  virtual void SetOffset(const double offset_W[3]);
  virtual double* GetOffset() VTK_SIZEHINT(3);
  ///@}

  /// Scale and offset such that the device's workspace holds the whole committed scene, life size no longer, and the
  /// rotation of a plane world for a device that moves in a plane. PropertyModifiedEvent says that they have changed.
  void FitWorkspace();

  ///@{
  /// Where a simulated hand is led: a polyline in W [u]. A path longer than one point replaces the one before.
  void SetStrokePath(vtkPolyData* path);
  void ClearStrokePoints();
  void AddStrokePoint(double x, double y, double z);
  int GetNumberOfStrokePoints() const;
  ///@}

  ///@{
  /// Speed of a simulated hand along its stroke [m/s of the hand], > 0, default 0.05.
  virtual void SetStrokeSpeed(double speed_m_per_s);
  virtual double GetStrokeSpeed() const;
  ///@}

  ///@{
  /// Recording that the device "replay" plays. Read when touching starts.
  virtual void SetReplayFile(const char* file);
  virtual const char* GetReplayFile() const;
  ///@}

  ///@{
  /// File that receives the recording while touching; "" for none (default). Read when touching starts.
  virtual void SetRecordFile(const char* file);
  virtual const char* GetRecordFile() const;
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
  ///@}

  /**
   * Puts a surface that was added under `name` where `matrix` says (null: as its data is), with the next CommitScene().
   * While what changes is rigid the surface moves there, in as long as it took from the last commit to this one, 0.2 s
   * at most, and carries or pushes the hand; anything else, and any new data with AddSurface(), is there at once, and
   * the hand stays on its side. False, with GetProblem(), for a matrix that is not finite, singular or a perspective.
   */
  bool SetSurfacePose(const char* name, vtkMatrix4x4* matrix);

  /// How late moving surfaces are felt [s]: the time between the two snapshots they are felt between, and what handing
  /// the last one over took. 0 when all of them are where they were shown last.
  double GetMotionLag() const;

  /// True while a surface is felt by a pose: it moves, or has rested for less than a second.
  bool GetSceneMoves() const;

  /// Bounds of the touched scene [u]; false and an empty box when there is none.
  bool GetSceneBounds(double bounds[6]) const;

  ///@{
  /// How deep the device "mouse" presses [m of the hand], LeastPressDepth to LargestPressDepth, default 0.002
  /// (vtkHapticMouse); whether it is the running device, else the chosen one.
  static constexpr double LeastPressDepth = 5e-5;
  static constexpr double LargestPressDepth = 0.05;
  virtual void SetPressDepth(double depth_m);
  virtual double GetPressDepth() const;
  bool GetFollowsMouse() const;
  ///@}

  /**
   * Where a ball as large as the one that touches is first stopped on its way from one point to another: its centre and
   * the unit normal of what stops it, to its side. False, and both unchanged, where nothing does.
   */
  bool PickSurface(const double from_W[3], const double to_W[3], double ball_W[3], double normal_W[3]) const;

  ///@{
  /// Where a program holds the hand (devices "fed" and "mouse"): a point in W [u]. Before the first there is no hand.
  void SetHandPosition(double x, double y, double z);
  void SetHandPosition(const double p_W[3]);
  ///@}

  ///@{
  /// Engage again after a fault; let go at once; a mark in the recording.
  void Engage();
  void Release();
  void Mark();
  ///@}

  ///@{
  /**
   * In virtual time nothing runs by itself: Step(n) computes n ticks of 1 ms in the calling thread, deterministic to
   * the last bit. Default off. Takes effect when touching starts.
   */
  virtual void SetVirtualTime(bool on);
  virtual bool GetVirtualTime() const;
  vtkBooleanMacro(VirtualTime, bool);
  void Step(int ticks);
  ///@}

  /// Takes the latest state of the servo and a scene that the worker has finished. Microseconds; call it every frame.
  void Update();

  ///@{
  /// "safe", "armed", "engaged" or "fault"; the reason and what to do, "" when there is none.
  int GetEngageState() const;
  const char* GetStateText() const;
  const char* GetFaultText() const;
  /// What needs attention without being a fault, and what to do: "" if nothing.
  const char* GetWarning() const;
  ///@}

  /// Last thing that was refused: one line, what and why; "" when nothing was.
  const char* GetProblem() const;

  ///@{
  /// Proxy and hand [u], force on the hand [N], all in W; planes that push; how deep the hand is behind the proxy [u].
  double* GetProxyPosition() VTK_SIZEHINT(3);
  double* GetHandPosition() VTK_SIZEHINT(3);
  double* GetForce() VTK_SIZEHINT(3);
  double GetForceMagnitude() const;
  double GetPeakForce() const;
  int GetContacts() const;
  double GetDepth() const;
  ///@}

  /// What friction does now: "sticks", "slips", or "" without contact or friction.
  const char* GetFrictionText() const;

  ///@{
  /**
   * How stiff a wall the device can hold with these settings [N/m], infinite where nothing is known to limit it, and
   * why in one sentence: of the running device, else of the chosen one.
   */
  double GetLargestStiffness() const;
  const char* GetStabilitySentence() const;
  ///@}

  ///@{
  /// Stiffness of the last tick after every limit [N/m], 0 before the first; whether it is less than was set because
  /// the device or the rate cannot hold that; size of the part of the force that passivity control added, now and the
  /// largest of all ticks [N].
  double GetStiffnessUsed() const;
  bool GetStiffnessLimited() const;
  double GetStabiliserForce() const;
  double GetPeakStabiliserForce() const;
  ///@}

  ///@{
  /**
   * Energy of the force [J]: net work on the hand since touching started (negative: taken from it); by how much the
   * contact of now has given more than its spring holds; the most of that so far.
   */
  double GetDeliveredEnergy() const;
  double GetExcessEnergy() const;
  double GetPeakExcessEnergy() const;
  ///@}

  ///@{
  /// Ticks computed, periods missed (never caught up), their sum, ticks that met a work limit, time in contact [s],
  /// largest |F - stabiliser - StiffnessUsed (proxy - hand) / Scale| of the ticks whose force nothing limited [N].
  vtkIdType GetTicks() const;
  vtkIdType GetMissed() const;
  vtkIdType GetPeriods() const;
  vtkIdType GetCappedTicks() const;
  double GetContactSeconds() const;
  double GetForceResidual() const;
  ///@}

  ///@{
  /// Ticks per second [Hz]; how late ticks start and what they cost, median and 99th percentile [us].
  double GetRate() const;
  double GetLatenessP50() const;
  double GetLatenessP99() const;
  double GetCostP50() const;
  double GetCostP99() const;
  ///@}

  ///@{
  /// What the operating system granted the servo and why; what was repaired, refused and planned, a line a surface.
  const char* GetSchedulingReport() const;
  const char* GetSceneReport() const;
  ///@}

protected:
  vtkHapticSession();
  ~vtkHapticSession() override;

private:
  vtkHapticSession(const vtkHapticSession&) = delete;
  void operator=(const vtkHapticSession&) = delete;

  void Refuse(const std::string& problem);
  void Start();
  void Stop();
  /// Sets parameters that were changed by `change`, or refuses them and keeps the old ones.
  void Change(const std::function<void(palpate::HapticParameters&)>& change);

  /// Sets arrays and ranges that were changed by `change`, or refuses them and keeps the old ones.
  void ChangeMaterial(const std::function<void(vtkHapticMaterialSettings&)>& change);

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
