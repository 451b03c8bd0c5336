// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/core/Outcome.h"

namespace palpate
{

/// Locks an open file for its holder alone, as far as other programs ask for such a lock. 0, or the system's number for
/// the reason: EBUSY where another one has it.
[[nodiscard]] int lockAlone(int file) noexcept;

/// The same lock on the file of a device that something else has opened; it ends with this object or with the process.
class FileLock
{
public:
  FileLock() = default; ///< none
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

  /// Takes it, or says why not. None where there is no file that can be opened: whoever opens the device tells that.
  [[nodiscard]] static Outcome<FileLock> take(const std::string& path);

private:
  explicit FileLock(int file) noexcept : file_(file) {}

  int file_ = -1;
};

} // namespace palpate
