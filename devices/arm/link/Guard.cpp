// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/link/Guard.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace palpate
{
namespace
{

constexpr int pipeOfGuard = 3, linkOfGuard = 4; ///< the descriptors that the program expects
constexpr auto patience = std::chrono::milliseconds(500);

/// The same in the build tree as where the library is installed.
std::string guardProgram()
{
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&Guard::start), &info) == 0 || info.dli_fname == nullptr)
  {
    return {};
  }
  std::error_code ignored;
  const std::filesystem::path library = std::filesystem::canonical(info.dli_fname, ignored);
  return guardProgramOf(library);
}

std::string hexOf(std::span<const std::uint8_t> bytes)
{
  constexpr const char* digits = "0123456789abcdef";
  std::string hex;
  for (const std::uint8_t byte : bytes)
  {
    hex += digits[byte >> 4U];
    hex += digits[byte & 15U];
  }
  return hex;
}

/// Conditions of the start of the guard: descriptors of its own and no other, its own session, so that no terminal ends
/// it, and the signals blocked that end a crowd of programs politely.
class SpawnPlan
{
public:
  SpawnPlan(int pipe, int link)
  {
    posix_spawn_file_actions_init(&this->files);
    posix_spawnattr_init(&this->attributes);
    // Copies above all, first: the numbers wanted may be in use here.
    this->pipe_ = fcntl(pipe, F_DUPFD_CLOEXEC, linkOfGuard + 1);
    this->link_ = fcntl(link, F_DUPFD_CLOEXEC, linkOfGuard + 1);
    posix_spawn_file_actions_adddup2(&this->files, this->pipe_, pipeOfGuard);
    posix_spawn_file_actions_adddup2(&this->files, this->link_, linkOfGuard);
    posix_spawn_file_actions_addclosefrom_np(&this->files, linkOfGuard + 1);
    sigset_t polite;
    sigemptyset(&polite);
    for (const int asked : { SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE })
    {
      sigaddset(&polite, asked);
    }
    posix_spawnattr_setsigmask(&this->attributes, &polite);
    posix_spawnattr_setflags(&this->attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK);
  }
  ~SpawnPlan()
  {
    ::close(this->pipe_);
    ::close(this->link_);
    posix_spawn_file_actions_destroy(&this->files);
    posix_spawnattr_destroy(&this->attributes);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;

  [[nodiscard]] bool ok() const noexcept { return this->pipe_ >= 0 && this->link_ >= 0; }

  posix_spawn_file_actions_t files{};
  posix_spawnattr_t attributes{};

private:
  int pipe_ = -1, link_ = -1;
};

} // namespace

std::string guardProgramOf(const std::filesystem::path& library)
{
  const std::filesystem::path inPrefix = std::filesystem::path("libexec") / "palpate" / "palpate-guard";
  const std::filesystem::path above = library.parent_path().parent_path();
  const std::filesystem::path first = above / inPrefix, second = above.parent_path() / inPrefix;
  std::error_code ignored;
  return !std::filesystem::exists(first, ignored) && std::filesystem::exists(second, ignored) ? second.string()
                                                                                              : first.string();
}

Guard::Guard(Guard&& other) noexcept
  : process_(std::exchange(other.process_, -1)), pipe_(std::exchange(other.pipe_, -1))
{
}

Guard& Guard::operator=(Guard&& other) noexcept
{
  std::swap(this->process_, other.process_);
  std::swap(this->pipe_, other.pipe_);
  return *this;
}

Outcome<Guard> Guard::start(int link, unsigned endpoint, std::span<const std::uint8_t> noTorque)
{
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
  {
    return { {}, std::string("the guard cannot be started: ") + std::strerror(errno) };
  }
  std::string program = guardProgram(), watched = std::to_string(getpid()), where = std::to_string(endpoint),
              hex = hexOf(noTorque);
  const std::array<char*, 5> arguments{ program.data(), watched.data(), where.data(), hex.data(), nullptr };
  pid_t process = -1;
  int failed = 0;
  {
    const SpawnPlan plan(ends[0], link);
    std::array<char*, 1> noEnvironment{};
    failed = !plan.ok() ? EBADF
                        : posix_spawn(&process, program.c_str(), &plan.files, &plan.attributes, arguments.data(),
                            noEnvironment.data());
  }
  ::close(ends[0]);
  Guard guard(failed == 0 ? process : -1, ends[1]);
  if (failed != 0)
  {
    return { {}, "the guard \"" + program + "\", which ends the force when this program dies, cannot be started: " +
                   std::strerror(failed) + "; without it this device gives no force" };
  }
  return { std::move(guard), {} };
}

bool Guard::watches() const noexcept
{
  pollfd pipe{ this->pipe_, 0, 0 };
  return this->pipe_ < 0 || (::poll(&pipe, 1, 0) == 0);
}

/// It writes and ends as soon as its pipe breaks. One that hangs in the system is left to itself.
Guard::~Guard()
{
  if (this->pipe_ >= 0)
  {
    ::close(this->pipe_);
  }
  const auto until = std::chrono::steady_clock::now() + patience;
  while (
    this->process_ > 0 && waitpid(this->process_, nullptr, WNOHANG) == 0 && std::chrono::steady_clock::now() < until)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

} // namespace palpate
