// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/recording/writing/EndedRecording.h"
#include "haptics/recording/writing/Recorder.h"

namespace palpate
{

/// The recordings of a run as its owner sees them: the one that goes on, and those of which the servo has still to say
/// that they are whole. Nothing here waits for the servo.
class Recordings
{
public:
  /// `link`: where the servo finds the recorder; null: none. In virtual time no thread writes: see pump().
  Recordings(std::atomic<Recorder*>& link, bool virtualTime) : link_(link), virtualTime_(virtualTime) {}

  /// From the next tick on; the one before ends there. Empty, or one sentence; then the one before goes on.
  [[nodiscard]] std::string begin(
    const std::string& file, const std::string& device, const TickInputs::Each<input::OwnedInput>& felt);
  /// The servo lets go of it before its next tick.
  void end();
  [[nodiscard]] bool running() const noexcept { return this->current_.has_value(); }
  /// In those that end, too: the servo may have taken a value before it saw the end of a recording.
  template<class K>
  void store(const std::shared_ptr<const typename K::Value>& value)
  {
    this->inEach([&value](Recorder& recorder) { recorder.store<K>(value); });
  }
  /// Writes the entries that have arrived, in virtual time.
  void pump();
  /// Ends recordings without space on their disk, and closes those that have ended: each is told once.
  [[nodiscard]] std::optional<EndedRecording> takeEnded();
  /// The servo is gone: everything is closed. The last one, if there was any, with the faults of all.
  [[nodiscard]] std::optional<EndedRecording> finish();

private:
  template<class Function>
  void inEach(const Function& function)
  {
    if (this->current_)
    {
      function(*this->current_->recorder);
    }
    for (const Going& going : this->ending_)
    {
      function(*going.recorder);
    }
  }

  std::atomic<Recorder*>& link_;
  bool virtualTime_;
  struct Going
  {
    std::string file;
    std::unique_ptr<Recorder> recorder;
  };
  [[nodiscard]] static EndedRecording close(const Going& going);

  std::optional<Going> current_;
  std::vector<Going> ending_;
};

} // namespace palpate
