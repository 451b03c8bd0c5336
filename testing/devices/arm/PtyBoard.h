// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

#include "testing/devices/arm/BoardModel.h"

namespace palpate::test
{

/// A board behind the other end of a pseudo terminal, which a program opens as a serial line.
class PtyBoard
{
public:
  explicit PtyBoard(BoardModel& board) : board_(board), master_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC))
  {
    if (this->master_ < 0 || grantpt(this->master_) != 0 || unlockpt(this->master_) != 0)
    {
      throw std::runtime_error("no pseudo terminal");
    }
    this->path_ = ptsname(this->master_);
  }
  ~PtyBoard() { ::close(this->master_); }
  PtyBoard(const PtyBoard&) = delete;
  PtyBoard& operator=(const PtyBoard&) = delete;

  [[nodiscard]] const std::string& path() const noexcept { return this->path_; }
  [[nodiscard]] int file() const noexcept { return this->master_; }

  /// Receives the bytes that come within that time, and answers.
  void serve(int timeout_ms)
  {
    pollfd input{ this->master_, POLLIN, 0 };
    if (poll(&input, 1, timeout_ms) <= 0 || (input.revents & POLLIN) == 0)
    {
      return;
    }
    std::array<std::uint8_t, 256> bytes;
    const ssize_t count = ::read(this->master_, bytes.data(), bytes.size());
    this->board_.take({ bytes.data(), static_cast<std::size_t>(count > 0 ? count : 0) });
    const std::vector<std::uint8_t> said(this->board_.said.begin(), this->board_.said.end());
    this->board_.said.clear();
    static_cast<void>(!said.empty() && ::write(this->master_, said.data(), said.size()) < 0);
  }

private:
  BoardModel& board_;
  int master_;
  std::string path_;
};

} // namespace palpate::test
