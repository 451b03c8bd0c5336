// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <sys/types.h>

#include "haptics/core/Outcome.h"

namespace palpate
{

/// The program of the guard that belongs to a library in this file: in `libexec/palpate` of the folder above its own,
/// or of one higher, as libraries stand in `lib` or in `lib/<machine>`. Where there is none, the path that was tried
/// first.
[[nodiscard]] std::string guardProgramOf(const std::filesystem::path& library);

/// The other end of a guard: a process of its own that holds a copy of an open link and writes "no torque" to it once
/// this end is closed, which the death of this process does, too. For devices that keep their torque when their host is
/// silent.
class Guard
{
public:
  Guard() = default; ///< none is needed
  Guard(Guard&& other) noexcept;
  Guard& operator=(Guard&& other) noexcept;
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
  ~Guard();

  /// Starts one for a link, or says why not. `endpoint`: of a USB device, 0 where the link is a file that is written
  /// to.
  [[nodiscard]] static Outcome<Guard> start(int link, unsigned endpoint, std::span<const std::uint8_t> noTorque);
  /// False: it has ended, so that nothing would end the torque. True where none is needed.
  [[nodiscard]] bool watches() const noexcept;
  /// The process; -1: none is needed.
  [[nodiscard]] pid_t process() const noexcept { return this->process_; }

private:
  Guard(pid_t process, int pipe) noexcept : process_(process), pipe_(pipe) {}

  pid_t process_ = -1;
  int pipe_ = -1;
};

} // namespace palpate
