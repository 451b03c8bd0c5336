// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "haptics/core/HapticDevice.h"
#include "haptics/realtime/RealtimeThread.h"
#include "haptics/tick/HapticParameters.h"
#include "haptics/tick/base/HapticState.h"

namespace palpate
{

class FieldBlock;
class Recordings;
class Scene;
enum class EventKind : std::uint8_t;
struct EndedRecording;
struct LoopReport;
struct LooseSources;
struct MechanismGrip;
struct MechanismInputs;
struct PressedBody;
struct ServoLinks;
struct SessionWorkers;
struct StabilityLimits;
struct ToolChoice;
struct ToolReport;

/// How a session is to run. Fixed while it runs.
struct SessionOptions
{
  double period_s = 1e-3;
  bool virtualTime = false; ///< nothing runs by itself: step() computes ticks in the caller's thread
  std::string recordFile;   ///< empty: no recording
  bool engage = true;       ///< ask for force at once
  RealtimeBrokers brokers;  ///< who is asked for real-time priority where the user's limits do not allow it
};

/// Owner of a device, a servo and their shared buffers, for programs and the user interface. One thread, the owner's,
/// calls every method. No method waits for the servo except stop() and the destructor, which end it with zero force.
class HapticSession
{
public:
  HapticSession();
  ~HapticSession();
  HapticSession(const HapticSession&) = delete;
  HapticSession& operator=(const HapticSession&) = delete;

  /// Opens the device and starts the servo. Empty, or one sentence why not; then nothing runs.
  [[nodiscard]] std::string start(std::unique_ptr<HapticDevice> device, const SessionOptions& options = {});
  /// Zero force, servo joined, device closed, recording complete. Returns empty, or the fault of the recording. A
  /// pushed hand is let go in the release ramp, which is waited for; a ramp longer than half a second is cut there. In
  /// virtual time nobody is pushed, and the session ends at once.
  std::string stop();
  [[nodiscard]] bool running() const noexcept;
  /// The running device, or null: to feed a FedDevice.
  [[nodiscard]] HapticDevice* device() noexcept;

  /// Takes effect at the next tick. Empty, or one sentence; then nothing changes. `comesFrom_W`: where the ball comes
  /// from then, so that a hand which these parameters put into a surface stays on its other side.
  [[nodiscard]] std::string setParameters(
    const HapticParameters& parameters, const std::optional<Vec3>& comesFrom_W = {});
  [[nodiscard]] const HapticParameters& parameters() const noexcept { return this->parameters_; }
  /// How stiff the running device can be with these parameters, and why in one sentence; unlimited and empty while
  /// nothing runs.
  [[nodiscard]] StabilityLimits limits() const;
  [[nodiscard]] std::string limitsText() const;
  /// Null: nothing to touch. Kept over stop() and start(). `comesFrom_W`: where the ball comes from when the servo
  /// takes the scene, so that a surface that has come around it stays on its other side.
  void setScene(std::shared_ptr<const Scene> scene, const std::optional<Vec3>& comesFrom_W = {});
  [[nodiscard]] const std::shared_ptr<const Scene>& scene() const noexcept;

  /// The result of that task's worker is felt from a tick soon after on; none: nothing. Kept over stop() and start(). A
  /// tool takes the place of the ball. A soft body is felt beside the scene by a ball, or by a tool that is one; any
  /// other tool presses it as a mechanism of these two and the other surfaces of the scene, and so does each tool where
  /// a surface is loose. While a mechanism is felt, ball, tool and soft body rest. Include SessionWorkers.h for these.
  template<class Task>
  void choose(const typename Task::Choice& choice);
  template<class Task>
  [[nodiscard]] const typename Task::Choice& chosen() const noexcept;
  template<class Task>
  [[nodiscard]] typename Task::Status status() const;
  /// Why the tool is not held or cannot touch the scene; "": it can. And how its thread does.
  [[nodiscard]] std::string toolRefusal() const;
  [[nodiscard]] std::string toolBesideSoft() const; ///< why the tool is not held beside the soft body; "": it is
  [[nodiscard]] bool toolPresses() const; ///< whether tool or ball, soft body and loose sources are a mechanism
  [[nodiscard]] const ToolReport& toolReport();
  /// Surfaces of the scene that are loose from a tick soon after on: with them the hand is felt in a mechanism of its
  /// tool or ball, the soft body and all surfaces. Kept over stop() and start().
  void setLoose(const LooseSources& loose);
  /// Why none of them is loose, with the remedy; "": all are that the scene has.
  [[nodiscard]] const std::string& looseRefusal() const;
  /// That mechanism begins anew, its loose bodies where their surfaces are; false: there is none.
  bool putBack();
  /// The mechanism that is chosen, or else that of toolPresses(); null: neither.
  [[nodiscard]] std::shared_ptr<const MechanismInputs> feltMechanism() const;
  /// The faults that a mechanism would have in this hand, or "". `atRest`: its soft bodies.
  [[nodiscard]] std::string refuseMechanism(
    const MechanismInputs& inputs, const std::vector<std::shared_ptr<const PressedBody>>& atRest) const;
  /// By its place in the mechanism: it holds nothing from the next tick on, until another mechanism is taken.
  void breakConstraint(std::uint32_t law);

  /// An input that the owner publishes: taken at the next tick; null: none. Kept over stop() and start(). For kinds
  /// without a method of their own include SessionInputs.h.
  template<class K>
  void setInput(std::shared_ptr<const typename K::Value> value);
  template<class K>
  [[nodiscard]] const std::shared_ptr<const typename K::Value>& inputNow() const noexcept;
  /// The field around the hand.
  void setFieldBlock(std::shared_ptr<const FieldBlock> brick);
  [[nodiscard]] const std::shared_ptr<const FieldBlock>& brick() const noexcept;

  /// Records from the next tick on into that file, and no more into the one before: empty, or one sentence; then
  /// nothing changes. While a field is felt none begins. A recording ends with endRecording() or the session, or when
  /// its disk is full.
  [[nodiscard]] std::string record(const std::string& file);
  void endRecording();
  [[nodiscard]] bool recording() const noexcept;
  /// A recording that has ended, told once; stop() ends the last one.
  [[nodiscard]] std::optional<EndedRecording> takeRecorded();

  void engage();
  void release();
  void mark();
  /// Another game in the labyrinth, if one is played: the hand is brought to its start.
  void play();
  /// Virtual time: computes that many ticks now. Returns how many the device allowed.
  int step(int ticks);

  /// The newest state and report; after stop() the last ones.
  [[nodiscard]] const HapticState& state();
  [[nodiscard]] const LoopReport& report();
  /// Scheduling of the servo thread; empty message in virtual time or before the thread has started.
  [[nodiscard]] SchedulingReport scheduling() const;

private:
  struct Run;
  struct Chosen;
  struct Kept;
  [[nodiscard]] ServoLinks* links() noexcept; ///< null: nothing runs
  [[nodiscard]] Recordings& recordings() noexcept;
  void push(EventKind kind, std::uint64_t value = 0);
  [[nodiscard]] double characteristic_u() const noexcept;
  [[nodiscard]] MechanismGrip grip(const HapticParameters& adapted) const noexcept;
  [[nodiscard]] const SessionWorkers* workers() const noexcept; ///< null: nothing runs
  /// Whether the tool is held as far as the soft body is concerned, and toolPresses().
  using Holding = std::pair<bool, bool>;
  [[nodiscard]] Holding holding() const;
  [[nodiscard]] double heldLever_u() const;
  void pairTool(); ///< with the soft body and the scene
  void followChoice(bool handChanges);
  void adapt(Run& run, bool first) const;
  void orderWork(Run& run) const;
  void storePublished(bool again = false);
  /// A tool beside a soft body that it does not press would feel its surface of before.
  [[nodiscard]] ToolChoice heldTool() const;

  HapticParameters parameters_;
  std::uint64_t version_ = 0;
  std::unique_ptr<Kept> kept_; ///< those of workers are not kept
  std::unique_ptr<Chosen> chosen_;
  HapticState lastState_;
  std::unique_ptr<Run> run_;
};

} // namespace palpate
