// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <fstream>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "haptics/realtime/SpscRing.h"
#include "haptics/recording/Recording.h"

namespace palpate
{

/// Writes a recording while the servo runs: the servo pushes into a ring, a thread of its own writes the file.
class Recorder
{
public:
  Recorder() = default;
  ~Recorder() { this->close(); }

  /// Opens a temporary beside `path`; close() gives it its name, so that a broken run leaves an old file alone.
  /// Returns empty, or one sentence. `background`: write from a thread; else pump() writes.
  [[nodiscard]] std::string open(const std::string& path, const std::string& device, const HapticParameters& parameters,
    const RendererState& state, bool background);
  /// Writes the rest and the closing chunk. Returns empty, or what went wrong.
  std::string close();
  [[nodiscard]] bool isOpen() const noexcept { return this->file_.is_open(); }

  /// Servo thread; wait-free. A full ring is counted and makes the recording one that cannot be recomputed.
  void pushTick(const TickRecord& record) noexcept;
  void pushEvent(const HapticEvent& event) noexcept;
  void pushParameters(std::uint64_t tick, const HapticParameters& parameters) noexcept;
  void pushScene(std::uint64_t tick, const Scene* scene) noexcept;
  void pushBrick(std::uint64_t tick, const Brick* brick) noexcept;

  /// Any other thread: stores a scene that the servo may take, once for each content.
  void storeScene(const std::shared_ptr<const Scene>& scene);
  /// Likewise a field.
  void storeBrick(const std::shared_ptr<const Brick>& brick);
  /// Writes what has come in. The thread that calls close().
  void pump();

private:
  enum class EntryKind : std::uint8_t
  {
    Tick,
    Change,
    Parameters,
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

  void write(const std::vector<char>& chunk);
  void writeEntry(const Entry& entry);

  std::unique_ptr<SpscRing<Entry, 8192>> ring_ = std::make_unique<SpscRing<Entry, 8192>>();
  std::string path_;
  std::ofstream file_;
  std::mutex fileMutex_; ///< between storeScene() and the writing thread; the servo never takes it
  std::set<std::uint64_t> stored_;
  std::jthread writer_;
};

} // namespace palpate
