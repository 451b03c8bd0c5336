// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/OtherProgram.h"

#include <cerrno>
#include <csignal>
#include <system_error>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace palpate::test
{

OtherProgram::OtherProgram(std::vector<std::string> arguments)
{
  std::string self = "/proc/self/exe";
  std::vector<char*> words{ self.data() };
  for (std::string& argument : arguments)
  {
    words.push_back(argument.data());
  }
  words.push_back(nullptr);
  const int problem = posix_spawn(&this->process_, self.c_str(), nullptr, nullptr, words.data(), environ);
  if (problem != 0)
  {
    throw std::system_error(problem, std::generic_category(), self);
  }
}

void OtherProgram::kill() noexcept
{
  if (this->process_ > 0)
  {
    ::kill(this->process_, SIGKILL);
    ::waitpid(this->process_, nullptr, 0);
    this->process_ = -1;
  }
}

} // namespace palpate::test
