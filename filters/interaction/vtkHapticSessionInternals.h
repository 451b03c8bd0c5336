// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSessionInternals_h
#define vtkHapticSessionInternals_h

#include "devices/DeviceFactory.h"
#include "devices/FedDevice.h"
#include "devices/RecordedHand.h"
#include "devices/calibration/SelfTestRun.h"
#include "devices/common/LinkedDevice.h"
#include "haptics/geometry/measure/ContactPlace.h"
#include "haptics/labyrinth/GameLog.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/plan/AskedParameters.h"
#include "haptics/session/plan/HandMap.h"
#include "haptics/session/scene/FeltField.h"
#include "haptics/session/scene/FeltScene.h"
#include "haptics/session/settings/TickFields.h"
#include "vtkHapticFieldData.h"
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticHeldTool.h"
#include "vtkHapticMarkRecords.h"
#include "vtkHapticPressedBody.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticServerSurfaces.h"
#include "vtkHapticSession.h"
#include "vtkHapticSourceProbe.h"
#include "vtkTimeStamp.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The core's session, what it is started with, and the last that it said.
class vtkHapticSession::Internals
{
public:
  static constexpr double PeriodSeconds = 1e-3;

  palpate::HapticSession Core;
  palpate::AskedParameters Asked{ palpate::sessionDefaults() };
  std::map<std::string, std::vector<double>> Fields; ///< as they were asked for last
  double FrictionKinetic = 0.0;                      ///< as set; the parameters have no more than the static one
  std::vector<palpate::KnownDevice> Known;
  vtkHapticMaterialSettings Materials;
  double LineRadius_u = 0.0;
  double PointRadius_u = 0.0;
  vtkTimeStamp MaterialTime;
  vtkHapticSceneSurfaces Surfaces;
  palpate::FeltScene Scene{ Core, PeriodSeconds };
  vtkHapticServerSurfaces Server{ Core, Scene, Surfaces };
  vtkHapticFieldArrays FieldArrays;
  std::string FieldName;
  vtkSmartPointer<vtkDataObject> FieldData, CompareData, SnapData;
  std::string FeltSource, CompareSource, SnapSource; ///< names of data, for who follows a view
  std::string DetentLevels;                          ///< as they were asked for
  vtkMTimeType BesideTime = 0;                       ///< of both when they were taken
  palpate::FieldEnds FieldEnds{ 1.0, 0.0 };
  palpate::FeltField FeltField;
  bool FieldIsNew = false;  ///< no brick has come of it yet
  std::string FieldProblem; ///< why the data that was added is not felt
  std::string FieldSentence;
  std::string FieldGone;               ///< that what was felt is not there any more
  std::array<double, 6> FieldBounds{}; ///< of the data that was added [u]
  double FieldGradient[3] = { 0.0, 0.0, 0.0 };
  vtkHapticHeldTool Tool;
  vtkHapticPressedBody Soft;
  vtkHapticHeldMechanism Mechanism;
  palpate::Quat HandTurn_W = palpate::Quat::Identity(); ///< where a program holds it
  int Simplify = Auto;
  int LinesAsWalls = Auto;
  bool Raises = false;     ///< lines, as the surfaces were told
  double WallRate = 125.0; ///< [Hz]
  std::string PlanSentence;

  palpate::SelfTestRun Check;
  bool Checked = false;     ///< a check was started
  bool CheckedTwin = false; ///< of a device that had a twin then
  std::string CheckAsk;
  std::string CheckResult;
  std::string CalibrationFolder;
  std::optional<palpate::Calibration> Felt; ///< what was kept of a device without serial number, walls included
  bool Wheel = false;

  std::string RecordFile;
  bool Recording = false; ///< wanted
  std::string Recorded;   ///< the last that is whole
  bool Saved = false;     ///< under a name that the person gave
  double RecordingBegun_s = 0.0;
  double RecordedSeconds = 0.0;
  std::string RecordingText;
  std::string ReplayFile;
  std::optional<palpate::RecordedHand> Played; ///< by the running device
  bool SceneKnown = false;                     ///< it touched what was shown since it is played
  std::string PlayedSentence;
  std::vector<palpate::Vec3> Stroke_W;
  double StrokeSpeed = 0.05;
  double PressDepth_m = 0.002;
  std::string HeldBy = palpate::DeviceOptions().hand;
  bool VirtualTime = false;
  bool FitOnTouch = false;
  palpate::WorkspaceMap LastFitted = palpate::sessionDefaults().map;
  palpate::HandMap HandMap;
  int ViewAlignment = AlignNever;
  std::optional<palpate::Quat> View_WD; ///< right, up and towards of the camera
  bool Clutch = false;
  int ClutchButton = 0;
  bool Precision = false;
  double PrecisionFactor = 5.0;
  int PrecisionButton = 0;
  bool ShowWorkspace = false;
  bool FitAsked = false; ///< while the scene was being built
  double Begun_s = 0.0;  ///< when touching began, as Now() has it
  std::string Preferred;
  double Corridor_u = 0.0; ///< of the labyrinth that was played last
  palpate::GameLog Game;
  std::optional<palpate::Vec3> Hand_W; ///< where a program holds it, once it said so

  std::optional<vtkHapticMarkRecord> Contact; ///< what was found at it when it was looked up last
  vtkHapticMarkRecords Marks;
  vtkHapticSourceProbe Probe;
  bool Inspect = false;
  int MarkButton = 0;
  std::uint32_t MarkButtons = ~0u; ///< that were down at the last look; what is down at the first was not pressed
  std::string ContactText;
  std::string ContactArrays;
  std::string MarksText;
  std::vector<int> MarkStates;  ///< one a mark
  std::string MarksNote;        ///< of those that are stale
  std::uint64_t CommitSeen = 0; ///< of the scene that marks and arrays were last compared with
  std::string MissingArrays;    ///< of that scene, a line each
  std::string SourcesText;
  double ContactPosition[3] = { 0.0, 0.0, 0.0 };
  double ContactNormal[3] = { 0.0, 0.0, 0.0 };
  double ContactCurvature[2] = { 0.0, 0.0 };

  palpate::HapticState State;
  palpate::LoopReport Report;
  palpate::StabilityLimits Limits;
  std::string StabilitySentence;
  std::string DeviceKind, DeviceNotes, LinkText, LossText;
  std::string Scheduling;
  std::string Warning;
  std::string Cancelled; ///< that the newest data are not touched; "" once there are others
  int ScenesCancelled = 0;
  std::string Around; ///< what has come around the hand, and what was done; "" once another scene is felt
  std::optional<palpate::Vec3> Eye_W; ///< of the view that the mouse is in
  std::string Problem;
  std::string ProblemOf; ///< subject of the problem, which is taken back when the subject succeeds
  static constexpr const char* OfSurface = "surface ";
  static constexpr const char* OfFormerSurface =
    "former surface"; ///< cleared; the next scene has it refused again, or not
  double Proxy[3] = { 0.0, 0.0, 0.0 };
  double Hand[3] = { 0.0, 0.0, 0.0 };
  double Force[3] = { 0.0, 0.0, 0.0 };

  std::shared_ptr<palpate::HidBus> Bus; ///< null: this computer's
  palpate::KnownDevice Chosen;          ///< as it was when it was seen last: it may have been unplugged

  /// What was chosen when touching started; another choice waits until it starts again.
  struct RunningChoice
  {
    std::string DeviceName;
    palpate::DeviceInfo Info;
    bool VirtualTime;
  };
  std::optional<RunningChoice> Running;

  /// Remembers what was refused, or without a problem takes its refusal back, for it succeeded now.
  void Follow(const std::string& what, const std::string& problem);
  palpate::DeviceOptions Options() const;
  /// Looks again which devices there are, and what is known of the chosen one.
  void LookForDevices();
  void LearnChosen();
  /// Of what runs, else of what was chosen.
  const std::string& DeviceNameNow() const;
  const palpate::DeviceInfo& InfoNow() const;
  bool VirtualTimeNow() const;
  /// Another device runs now than a moment ago, or none: what depends on it follows.
  void FollowDevice();
  /// What a check says now; ends it once there is a verdict.
  void FollowCheck();
  /// A check that felt a fault in walls that the device holds ends the trust in them.
  void TakeBackTrust();
  /// Tells a fed device where the program holds the hand, if it said so. `placed`: there without a way.
  void FeedTo(palpate::FedDevice& fed, bool placed) const;
  /// The same for the running device, if it is one.
  void Feed(bool placed = false);
  /// No program holds the hand until it is fed again.
  void Withdraw();
  /// The running device where it is behind a link, else null; how the link goes.
  const palpate::LinkedDevice* Linked();
  palpate::LinkReport Link();
  /// Where a recording that begins now goes.
  std::string NextRecording() const;
  /// Whether what is played was recorded on what is shown.
  void FollowReplay();
  /// Seconds of the session: ticks in virtual time.
  double Now();
  /// How simpler surfaces are looked for now.
  palpate::SimplifyPlan PlanNow() const;
  /// What has come around the hand, what is done, and what the person is told of it.
  void StayOutside(const std::optional<palpate::CameAround>& around);
  /// What a device's hand that this map puts elsewhere would be in.
  std::optional<palpate::CameAround> PutInto(const palpate::WorkspaceMap& map);
  /// Whether the hand is said in the scene, not in the workspace of a device.
  bool LedInScene();
  /// The rotation that is wanted while the view is followed.
  std::optional<palpate::Quat> ViewRotation(const palpate::DeviceInfo& device) const;
  /// What there is to fit a hand to, and whether there is anything.
  palpate::BuiltScene Fittable() const;
  bool IsFittable() const;
  /// Whether touching that begins now, or began with this scene, fits the hand.
  bool FitsNow() const
  {
    return this->FitOnTouch && !this->Played && palpate::isSame(this->Asked.asked().map, this->LastFitted);
  }
  /// The servo gets the ball of the scene that is felt; never in the tick of a swap, in which a pressed hand changes
  /// over.
  void FollowRadius();
  /// Whether lines are walls for the running device, else the chosen one.
  bool RaisesLines() const;
  /// Tells the surfaces so.
  void FollowWalls();
  /// Walls that the device may hold and the guide to their plane, as the scene that is felt allows.
  void FollowPlane();
  /// "; ..." about a plane world, or "".
  std::string PlaneSentence() const;
  /// The servo gets what is around the hand, once a worker has it. True where that changed.
  bool FollowField(bool wait);
  /// What the hand is in; nothing outside.
  std::optional<palpate::FieldSample> FieldAtHand() const;
  void ShowState();
  /// Where the ball touches, or the tool most; nothing where neither does.
  /// Takes the mechanism as it was read, or says the problem.
  void HoldMechanism(vtkHapticSession& session, const std::string& problem);
  std::optional<palpate::ContactPlace> PlaceOfContact() const;
  /// A setting of the tool, if it may have these numbers: the tool is made anew, or has only another lever.
  template<class Value>
  static void ChangeTool(vtkHapticSession* session, const char* setting, std::initializer_list<double> numbers,
    Value& held, const Value& value, bool anew);
  /// What is at the contact now; nothing without one.
  std::optional<vtkHapticMarkRecord> LookAtContact();
  void ShowContact(std::optional<vtkHapticMarkRecord> contact);
  /// Whether a mark lies on its source as that was committed last.
  int StateOf(const vtkHapticMarkRecord& mark) const;
  void JudgeMarks();
  /// Another scene was committed: marks may be stale, arrays gone.
  void FollowCommit();
  /// Its way goes on, or begins anew; buttons ask for another one.
  void FollowGame();
  /// What is set, but no more than the device can hold [N/m].
  double FeltStiffness() const;
  /// How stiff the running device can be, else the chosen one: milliseconds, for changes of what it depends on only.
  void JudgeStability();
};

#endif
