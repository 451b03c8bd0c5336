// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "haptics/realtime/SpscRing.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/writing/RecordingFile.h"

namespace palpate
{

/// Writes a recording while the servo runs: the servo pushes into a ring, a thread of its own writes the file. A
/// recording begins and ends where the servo says so.
class Recorder
{
public:
  Recorder() = default;
  ~Recorder() { this->close(); }

  /// Opens the file. Returns empty, or one sentence. `background`: write from a thread; else pump() writes.
  [[nodiscard]] std::string open(const std::string& path, const std::string& device, bool background);
  /// Writes the rest and the closing chunk, once the servo pushes no more. Returns empty, or what went wrong.
  std::string close();
  [[nodiscard]] bool isOpen() const noexcept { return this->file_.isOpen(); }
  /// The servo has said that this was all, and it is written: close() need not wait.
  [[nodiscard]] bool hasEnded() const noexcept { return this->ended_.load(std::memory_order_acquire); }
  /// What comes now is not written any more.
  [[nodiscard]] bool isFull() const noexcept { return this->file_.isFull(); }

  /// Closed, and there is a file.
  [[nodiscard]] bool isKept() const noexcept { return this->file_.isKept(); }

  /// Servo thread; wait-free. The first and the last push; false: there was no room, to be tried again.
  [[nodiscard]] bool pushStart(const HapticParameters& parameters, const RendererState& state) noexcept;
  [[nodiscard]] bool pushEnd() noexcept;
  /// Servo thread; wait-free. A full ring is counted and makes the recording one that cannot be recomputed.
  void pushTick(const TickRecord& record) noexcept;
  void pushEvent(const HapticEvent& event) noexcept;
  void pushParameters(std::uint64_t tick, const HapticParameters& parameters) noexcept;
  void pushScene(std::uint64_t tick, const Scene* scene) noexcept;
  void pushBrick(std::uint64_t tick, const Brick* brick) noexcept;
  void pushTool(std::uint64_t tick, const ToolContacts* contacts) noexcept;
  void pushBody(std::uint64_t tick, const PressedBody* body) noexcept;
  void pushMechanism(std::uint64_t tick, const FeltMechanism* mechanism) noexcept;

  /// Any other thread: stores a scene that the servo may take, once for each content.
  void storeScene(const std::shared_ptr<const Scene>& scene);
  /// Likewise a field.
  void storeBrick(const std::shared_ptr<const Brick>& brick);
  /// Likewise a packet of a soft body, with its scene.
  void storeBody(const std::shared_ptr<const PressedBody>& body);
  /// Likewise a mechanism, with the scenes of its bodies.
  void storeMechanism(const std::shared_ptr<const FeltMechanism>& mechanism);
  /// Writes what has come in. The thread that calls close().
  void pump();

private:
  enum class EntryKind : std::uint8_t
  {
    Start,
    Tick,
    Change,
    Parameters,
    End,
  };
  struct Entry
  {
    EntryKind kind = EntryKind::Tick;
    TickRecord tick;
    HapticEvent event;
    std::uint64_t sceneHash = 0;
    std::uint64_t sceneRevision = 0;
    HapticParameters parameters;
  };

  void writeStart(const HapticParameters& parameters);
  void writeEntry(const Entry& entry);
  void writeScenes();

  std::unique_ptr<SpscRing<Entry, 8192>> ring_ = std::make_unique<SpscRing<Entry, 8192>>();
  /// Beside the other ring, whose entries would all be as large as these: each has its event there.
  std::unique_ptr<SpscRing<ToolContacts, 1024>> tools_ = std::make_unique<SpscRing<ToolContacts, 1024>>();
  RendererState first_; ///< the servo's until it has pushed the start
  RecordingFile file_;
  bool started_ = false; ///< its first chunk is written
  std::atomic<bool> ended_ = false;
  std::mutex scenesMutex_; ///< between storeScene() and the writing thread; the servo never takes it
  std::vector<std::shared_ptr<const Scene>> scenes_;             ///< to be written
  std::vector<std::shared_ptr<const Brick>> bricks_;             ///< likewise
  std::vector<std::shared_ptr<const PressedBody>> bodies_;       ///< likewise
  std::vector<std::shared_ptr<const FeltMechanism>> mechanisms_; ///< likewise
  std::set<std::uint64_t> stored_;
  std::set<std::uint64_t> storedBodies_;     ///< their revisions
  std::set<std::uint64_t> storedMechanisms_; ///< likewise
  std::jthread writer_;
};

} // namespace palpate
