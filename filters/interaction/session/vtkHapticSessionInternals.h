// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSessionInternals_h
#define vtkHapticSessionInternals_h

#include "devices/DeviceFactory.h"
#include "devices/FedDevice.h"
#include "devices/common/LinkedDevice.h"
#include "haptics/geometry/measure/ContactPlace.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LoopReport.h"
#include "haptics/session/plan/AskedParameters.h"
#include "haptics/session/plan/HandMap.h"
#include "haptics/session/scene/FeltField.h"
#include "haptics/session/scene/FeltScene.h"
#include "haptics/session/settings/SettingStore.h"
#include "haptics/session/settings/TickFields.h"
#include "vtkHapticFieldData.h"
#include "vtkHapticMarkRecords.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticSession.h"
#include "vtkTimeStamp.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

class vtkHapticFeltSource;
class vtkHapticHeldMechanism;
class vtkHapticTool;
class vtkHapticPressedBody;
class vtkHapticRecordings;
class vtkHapticSceneSurfaces;
class vtkHapticServerSurfaces;
struct vtkHapticCheckState;
struct vtkHapticContactForce;
struct vtkHapticContactState;
struct vtkHapticGameState;

/// The core's session, its options, and its last state. Parts that have a folder of their own are known by name: their
/// folders include this header, and it includes none of theirs.
class vtkHapticSession::Internals
{
public:
  static constexpr double PeriodSeconds = 1e-3;

  explicit Internals(vtkHapticSession& session);
  ~Internals();
  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;

  vtkHapticSession& Session;
  palpate::SettingStore Settings;
  palpate::HapticSession Core;
  palpate::AskedParameters Asked{ palpate::sessionDefaults() };
  std::vector<palpate::KnownDevice> Known;
  vtkHapticMaterialSettings Materials;
  vtkTimeStamp MaterialTime;
  palpate::FeltScene Scene{ Core, PeriodSeconds };
  vtkHapticFieldArrays FieldArrays;
  std::string FieldName;
  vtkSmartPointer<vtkDataObject> FieldData, CompareData, SnapData;
  vtkMTimeType BesideTime = 0; ///< of both when they were taken
  palpate::FieldEnds FieldEnds{ 1.0, 0.0 };
  palpate::FeltField FeltField;
  bool FieldIsNew = false;   ///< no block has come of it yet
  double FieldAdded_s = 0.0; ///< when it was added, as Now() has it
  std::string FieldProblem;  ///< why the data that was added is not felt
  std::string FieldText;
  std::string FieldGone;               ///< that the touched data are gone
  std::array<double, 6> FieldBounds{}; ///< of the data that was added [u]
  double FieldGradient[3] = { 0.0, 0.0, 0.0 };
  palpate::Quat HandTurn_W = palpate::Quat::Identity(); ///< where a program holds it
  bool Raises = false;                                  ///< lines, as the surfaces were told
  std::string PlanText;
  std::string MaterialText;

  std::string CalibrationFolder;
  std::optional<palpate::Calibration> Felt; ///< calibration of a device without serial number, walls included

  std::vector<palpate::Vec3> Stroke_W;
  palpate::WorkspaceMap LastFitted = palpate::sessionDefaults().map;
  palpate::HandMap HandMap;
  std::optional<palpate::Quat> View_WD; ///< right, up and towards of the camera
  bool FitAsked = false;                ///< while the scene was being built
  double Begun_s = 0.0;                 ///< when touching began, as Now() has it
  std::string Preferred;
  std::optional<palpate::Vec3> Hand_W; ///< where a program holds it, once it said so

  std::uint64_t CommitSeen = 0; ///< of the scene that marks and arrays were last compared with
  std::string MissingArrays;    ///< of that scene, a line each
  std::string UnitOfFiles;      ///< of lengths, as the files of the scene say; "" or "u": they say none
  std::string LooseText, LooseRefused;
  std::set<std::string> LooseGone; ///< names of loose sources that the pipeline has not

  palpate::HapticState State;
  palpate::LoopReport Report;
  palpate::StabilityLimits Limits;
  std::string StabilityText;
  std::string DeviceKind, DeviceNotes, LinkText, FaultText, DeviceButton;
  std::string DeviceFile; ///< that a person chose for a device's step
  std::string Scheduling;
  std::string Warning;
  std::string Cancelled; ///< that the newest data are not touched; "" once there are others
  int ScenesCancelled = 0;
  std::string Around;                 ///< message on a surface that came over the hand; "" with the next scene
  double AroundSaid_s = 0.0;          ///< time of that message
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

private:
  struct Parts;
  std::unique_ptr<Parts> Owned;

public:
  vtkHapticSceneSurfaces& Surfaces;
  vtkHapticServerSurfaces& Server;
  vtkHapticTool& Tool;
  vtkHapticPressedBody& Soft;
  vtkHapticHeldMechanism& Mechanism;
  vtkHapticCheckState& Check;
  vtkHapticContactState& Contact;
  vtkHapticGameState& Game;
  vtkHapticRecordings& Recorded;
  const std::array<vtkHapticFeltSource*, 3> FeltSources;

  /// The device and options when touching started; another choice waits until it starts again.
  struct RunningChoice
  {
    std::string DeviceName;
    palpate::DeviceInfo Info;
    bool VirtualTime;
  };
  std::optional<RunningChoice> Running;

  /// Reports a refusal; "": none.
  void Refuse(const std::string& problem);
  /// Stores a refusal, or without a problem clears the earlier refusal, because the request succeeded now.
  void Follow(const std::string& what, const std::string& problem);
  void ForgetSettled();

  /// A new value by name: takes it, or says why not.
  void Put(const char* name, const palpate::SettingValue& value);
  /// The value of a setting now.
  palpate::SettingValue& ValueOf(const palpate::Setting& setting);
  /// Takes a value that the table allows, with all that follows from it. Empty, or why it cannot be: the old one stays.
  std::string Take(const palpate::Setting& setting, const palpate::SettingValue& value);
  /// Sets parameters of the tick changed by `change`; keeps the old ones if those are refused.
  void Change(const std::function<void(palpate::HapticParameters&)>& change);

  /// Applies a new value in Settings; empty, or the reason against the value.
  using Follower = std::string (Internals::*)();
  static const std::map<std::string_view, Follower>& Followers();
  std::string FollowDetentLevels();
  std::string FollowDeviceName();
  std::string FollowFieldArrays();
  std::string FollowFriction();
  std::string FollowHolder();
  std::string FollowLinesAsWalls();
  std::string FollowLooseSettings();
  std::string FollowMarksText();
  std::string FollowMaterials();
  std::string FollowMechanismConstraints();
  std::string FollowPlaneWishes();
  std::string FollowRadii();
  std::string FollowRadiusLimit();
  std::string FollowRecordingWish();
  std::string FollowServerLimit();
  std::string FollowSimplify();
  std::string FollowSoftRate();
  std::string FollowSourcesText();
  std::string FollowToolHandle();
  std::string FollowTouching();
  std::string FollowWallRate();
  std::string FollowWheel();

  void Start();
  void Stop();
  palpate::DeviceOptions Options() const;
  /// Searches the devices again, and updates the description of the chosen one.
  void LookForDevices();
  void LearnChosen();
  /// Of the running device, else of the chosen one.
  const std::string& DeviceNameNow() const;
  const palpate::DeviceInfo& InfoNow() const;
  bool VirtualTimeNow() const;
  /// Another device runs now than a moment ago, or none: updates dependent values.
  void FollowDevice();
  /// Updates the state of a check; ends the check once there is a verdict.
  void FollowCheck();
  /// A check that felt a fault in walls that the device holds ends the trust in them.
  void TakeBackTrust();
  /// Tells a fed device where the program holds the hand, if it said so. `placed`: there without a motion.
  void FeedTo(palpate::FedDevice& fed, bool placed) const;
  /// The same for the running device, if it is one.
  void Feed(bool placed = false);
  /// No program holds the hand until it is fed again.
  void Withdraw();
  /// The running device where it is behind a link, else null; how the link goes.
  const palpate::LinkedDevice* Linked();
  palpate::LinkReport Link();
  /// Seconds of the session: ticks in virtual time.
  double Now();
  /// How simpler surfaces are looked for now.
  palpate::SimplifyPlan PlanNow() const;
  /// Surfaces that came over the hand: the action and the message.
  void StayOutside(const std::optional<palpate::CameAround>& around);
  /// Takes back that message once a person could read the message, and a force that ended with it has returned.
  void ForgetAround();
  /// The surface that would contain a device's hand under this map.
  std::optional<palpate::CameAround> PutInto(const palpate::WorkspaceMap& map);
  /// Takes the worker's scene, or with `wait` the last commit. A hand that it surrounds stays outside.
  void TakeScene(bool wait = false);
  void TakeOutSqueezed();
  void FollowCameAround();
  /// The mouse's hand begins anew, where it is put without a motion.
  void LeadMouseAnew();
  /// Applies clutch, precision and view to the map.
  void FollowHand();
  void FollowMouseClutch();
  void AlignOnTouch(palpate::HapticDevice& device);
  /// Touching has ended: no button is pressed any more.
  void LetHandGo();
  /// Neither precise nor clutched, as the panel shows it.
  void LetButtonsGo();
  /// The map that the session makes by itself.
  void TakeMap(const palpate::HandMapChange& change);
  /// Whether the hand is said in the scene, not in the workspace of a device.
  bool LedInScene();
  /// The rotation that is wanted while the view is followed.
  std::optional<palpate::Quat> ViewRotation(const palpate::DeviceInfo& device) const;
  /// Bounds of the data for a fit of the hand, and whether there are data.
  palpate::BuiltScene Fittable() const;
  bool IsFittable() const;
  bool HasSurfaces() const;
  void Fit();
  void FitTo(const palpate::BuiltScene& scene);
  /// Whether touching that begins now, or began with this scene, fits the hand.
  bool FitsNow() const;
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
  std::string PlaneText() const;
  /// Passes the surroundings of the hand to the servo, once a worker has them. True after a change.
  bool FollowField(bool wait);
  /// Takes numbers in space, or says why they cannot be felt.
  bool FeelField(const std::string& name, const vtkHapticFieldResult& made);
  void TakeField(bool wait);
  /// Applies the present material settings to added surfaces.
  void FeelFieldAnew();
  /// The surface that contains the hand; nothing outside.
  std::optional<palpate::FieldSample> FieldAtHand() const;
  void ShowState();
  double* GradientNow();

  /// Sentences that are put together when somebody asks.
  const char* SayDeviceKind();
  const char* SayDeviceNotes();
  const char* SayFaultText();
  const char* SayFieldText();
  const char* SayFrictionText();
  const char* SayMaterialText();
  const char* SayLinkText();
  const char* SayLooseText();
  /// Of a source that is to be loose and is not felt as such, with the remedy.
  std::string WhyNotLoose(const std::string& name) const;
  const char* SayDeviceButton();
  const char* SayPlanText();
  const char* SayToolContacts();
  /// Where the tool, or the held mesh of a mechanism, is pressed; none of a ball.
  std::vector<vtkHapticContactForce> ContactForces(const palpate::HapticState& touched) const;

  /// A setting may name another source.
  void FollowSource(vtkHapticFeltSource& felt, const palpate::Setting& setting);
  /// Takes the data of a source, or reports the problem; false, then.
  bool AddFelt(vtkHapticFeltSource& felt, const char* name, vtkDataObject* data, const char* reason = nullptr);
  /// Feels it as it was made, or says the problem.
  void Feel(vtkHapticFeltSource& felt, const std::string& problem);
  /// How all such sources are.
  void FollowFelt();
  /// The styles of sources have changed.
  void FollowSources();
  /// Empty, or why no source has that density.
  std::string PutDensity(const std::string& source, double density);
  /// Tells the core which surfaces are loose.
  void FollowLoose();
  /// Refuses loose sources that cannot be, once for a reason. Not before the scene is there that has them: with the
  /// scene comes the unit of its lengths. Nor while a surface goes to another shape, as after an edit of its source.
  void JudgeLoose();
  /// The mechanism of the hand among loose sources or on a soft body; null: there is none.
  std::shared_ptr<const palpate::MechanismInputs> AmongLoose() const;
  /// Whether the state of the last tick has the bodies of that mechanism.
  bool LooseAreSeen() const;
  /// Why no source is loose though some should be, with the remedy; "": all of these are.
  std::string LooseProblem() const;
  /// The first loose source that has gone so far that it sleeps for good; "": none has.
  std::string LooseFallen() const;
  /// Of these two the one that the hand meets, as a sentence with the remedy; "".
  std::string LooseTrouble() const;
  /// How a loose source has gone from where its data are, in W; nothing: it is where they are.
  std::optional<palpate::Pose> LooseWay(const std::string& name) const;
  /// Where the ball touched then, or the tool most; nothing where neither did.
  std::optional<palpate::ContactPlace> PlaceOfContact(const palpate::HapticState& touched) const;
  void ForgetContact();
  /// The data at the last contact; nothing without one.
  std::optional<vtkHapticMarkRecord> LookAtContact();
  /// Looks at it if that is wanted, and sets a mark if its button was pressed.
  void FollowContact();
  void ShowContact(std::optional<vtkHapticMarkRecord> contact);
  /// Whether a mark lies on its source as that was committed last.
  int StateOf(const vtkHapticMarkRecord& mark) const;
  void KeepMarks(vtkHapticMarkRecords marks);
  void JudgeMarks();
  /// Another scene was committed: marks may be stale, arrays gone.
  void FollowCommit();
  /// Its path goes on, or begins anew; buttons ask for another one.
  void FollowGame();
  /// The setting, limited to the device's stable stiffness [N/m].
  double FeltStiffness() const;
  /// Stable stiffness of the running device, else of the chosen one: takes milliseconds, only after a change of its
  /// inputs.
  void JudgeStability();
};

#endif
