// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace palpate::test
{

/// This very program once more, with other arguments, in a process of its own.
class OtherProgram
{
public:
  /// Throws std::system_error where it cannot be started.
  explicit OtherProgram(std::vector<std::string> arguments);
  ~OtherProgram() { this->kill(); }
  OtherProgram(const OtherProgram&) = delete;
  OtherProgram& operator=(const OtherProgram&) = delete;

  /// SIGKILL: it gets no chance to leave anything in order. Returns when it is gone.
  void kill() noexcept;

private:
  pid_t process_ = -1;
};

} // namespace palpate::test
