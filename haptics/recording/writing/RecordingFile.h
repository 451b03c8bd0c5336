// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <fstream>
#include <string>

#include "haptics/recording/bytes/RecordingLayout.h"

namespace palpate
{

/// The file of a recording while it is written: a temporary beside its name, which gets that name once it is whole, so
/// that a broken run leaves an old file alone. Once the disk is full nothing more is written; the file up to then is
/// kept, for a recording can end after any of its chunks. One thread at a time, but for isFull().
class RecordingFile
{
public:
  /// Empty, or one sentence. `header`: the bytes before the chunks.
  [[nodiscard]] std::string open(const std::string& path, const std::string& header);
  [[nodiscard]] bool isOpen() const noexcept { return !this->path_.empty(); }

  void write(const NewChunk& chunk);
  /// Has all that was written reach the disk, or finds out that the disk is full.
  void flush();
  [[nodiscard]] bool isFull() const noexcept { return this->full_.load(std::memory_order_relaxed); }

  /// Writes the closing chunk, and the file has its name. Empty, or the fault and the part that is kept.
  [[nodiscard]] std::string close(const NewChunk& endChunk);
  /// Whether there is a file of that name since.
  [[nodiscard]] bool isKept() const noexcept { return this->kept_; }

private:
  [[nodiscard]] std::string temporary() const { return this->path_ + ".part"; }
  void put(const char* bytes, std::size_t size);
  void checkDisk();
  bool cutBack(std::size_t room);

  std::string path_;
  std::ofstream file_;
  std::uint64_t given_ = 0; ///< bytes
  std::uint64_t chunks_ = 0;
  std::deque<std::uint64_t> ends_; ///< of chunks, as offsets: the last that surely is on the disk, and all after it
  std::uint64_t there_ = 0;        ///< bytes of the file when the disk was full
  bool kept_ = false;
  std::atomic<bool> full_ = false;
};

} // namespace palpate
