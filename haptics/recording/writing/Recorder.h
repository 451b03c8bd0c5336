// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "haptics/realtime/SpscRing.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/writing/RecordingFile.h"

namespace palpate
{

namespace input
{

/// The values of one input that are to be written.
template<class K>
struct Stored
{
  std::vector<std::shared_ptr<const typename K::Value>> waiting;
  std::set<std::uint64_t> written; ///< by their names
};

/// Beside the recorder's other ring, whose entries would all be as large as these: each has its event there.
template<ComesByValue K>
struct Stored<K>
{
  using Ring = SpscRing<typename K::Value, 1024>;
  std::unique_ptr<Ring> values = std::make_unique<Ring>();
};

} // namespace input

/// Writes a recording while the servo runs: the servo pushes into a ring, a thread of its own writes the file. A
/// recording begins and ends where the servo says so.
class Recorder
{
public:
  Recorder() = default;
  ~Recorder() { this->close(); }

  /// Opens the file. Returns empty, or one sentence. `background`: write from a thread; else pump() writes.
  [[nodiscard]] std::string open(const std::string& path, const std::string& device, bool background);
  /// Writes the rest and the closing chunk, once the servo pushes no more. Returns empty, or the fault.
  std::string close();
  [[nodiscard]] bool isOpen() const noexcept { return this->file_.isOpen(); }
  /// The servo has said that this was all, and it is written: close() need not wait.
  [[nodiscard]] bool hasEnded() const noexcept { return this->ended_.load(std::memory_order_acquire); }
  /// Entries from now on are not written any more.
  [[nodiscard]] bool isFull() const noexcept { return this->file_.isFull(); }

  /// Closed, and there is a file.
  [[nodiscard]] bool isKept() const noexcept { return this->file_.isKept(); }

  /// Servo thread; wait-free. The first and the last push; false: the ring was full, to be tried again.
  [[nodiscard]] bool pushStart(const HapticParameters& parameters, const RendererState& state) noexcept;
  [[nodiscard]] bool pushEnd() noexcept;
  /// Servo thread; wait-free. A full ring is counted and makes the recording one that cannot be recomputed.
  void pushTick(const TickRecord& record) noexcept;
  void pushEvent(const HapticEvent& event, const input::RecordedName& name = {}) noexcept;
  void pushParameters(std::uint64_t tick, const HapticParameters& parameters) noexcept;
  /// The tick takes another value, or none.
  template<class K>
  void pushInput(std::uint64_t tick, const typename K::Value* value) noexcept
  {
    if constexpr (input::ComesByValue<K>)
    {
      if (value != nullptr && !std::get<input::Stored<K>>(this->stored_).values->tryPush(*value))
      {
        return;
      }
    }
    const input::RecordedName name = input::nameOf<K>(value);
    this->pushEvent({ tick, K::event, name.id }, name);
  }

  /// Any other thread: stores a value that the servo may take, once for each name, with the values of other inputs that
  /// a recording needs for it.
  template<class K>
  void store(const std::shared_ptr<const typename K::Value>& value)
  {
    if (!this->isOpen() || !value)
    {
      return;
    }
    if constexpr (requires { K::forEachPart(*value, [](auto, const auto&) {}); })
    {
      K::forEachPart(
        *value, [this]<class Part>(std::type_identity<Part>, const auto& part) { this->store<Part>(part); });
    }
    const std::lock_guard lock(this->storedMutex_);
    std::get<input::Stored<K>>(this->stored_).waiting.push_back(value);
  }
  /// Writes the entries that have arrived. The thread that calls close().
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
    input::RecordedName name;
    HapticParameters parameters;
  };

  void writeStart(const HapticParameters& parameters);
  void writeEntry(const Entry& entry);
  void writeValueOf(const HapticEvent& event);
  template<class K>
  void writeChunk(
    const ChunkKind& kind, const typename K::Value& value, void (*write)(ByteWriter&, const typename K::Value&));
  void writeStored();

  std::unique_ptr<SpscRing<Entry, 8192>> ring_ = std::make_unique<SpscRing<Entry, 8192>>();
  RendererState first_; ///< the servo's until it has pushed the start
  RecordingFile file_;
  bool started_ = false; ///< its first chunk is written
  std::atomic<bool> ended_ = false;
  std::mutex storedMutex_; ///< between store() and the writing thread; the servo never takes it
  TickInputs::Each<input::Stored> stored_;
  std::jthread writer_;
};

} // namespace palpate
