// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/link/SerialPort.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "devices/arm/link/FileLock.h"
#include "devices/hid/HidapiBus.h"

namespace palpate
{
namespace
{

constexpr int serialWrite_ms = 20;

/// 0, or the system's number for the reason. The lock lies on the open file, which a guard has, too.
int makeRaw(int file)
{
  termios settings{};
  if (tcgetattr(file, &settings) != 0)
  {
    return errno;
  }
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL;
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  if (const int refused = lockAlone(file); refused != 0)
  {
    return refused;
  }
  if (ioctl(file, TIOCEXCL) != 0)
  {
    return errno;
  }
  return tcsetattr(file, TCSANOW, &settings) == 0 && tcflush(file, TCIOFLUSH) == 0 ? 0 : errno;
}

} // namespace

Outcome<std::unique_ptr<SerialPort>> SerialPort::open(const std::string& path)
{
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0)
  {
    return { nullptr, openProblem(path, errno) };
  }
  std::unique_ptr<SerialPort> port(new SerialPort(file));
  const int failed = makeRaw(file);
  return failed == 0 ? Outcome<std::unique_ptr<SerialPort>>{ std::move(port), {} }
                     : Outcome<std::unique_ptr<SerialPort>>{ nullptr, openProblem(path, failed) };
}

SerialPort::~SerialPort()
{
  ioctl(this->file_, TIOCNXCL);
  ::close(this->file_);
}

bool SerialPort::send(std::span<const std::uint8_t> bytes) noexcept
{
  pollfd room{ this->file_, POLLOUT, 0 };
  if (poll(&room, 1, serialWrite_ms) <= 0)
  {
    this->failed_ = ETIMEDOUT;
    return false;
  }
  const ssize_t written = ::write(this->file_, bytes.data(), bytes.size());
  const int refused = errno == EIO ? ENODEV : errno; // so a system refuses a line that was hung up
  this->failed_ = written < 0 ? refused : EIO;
  return written == static_cast<ssize_t>(bytes.size());
}

int SerialPort::receive(std::span<std::uint8_t> bytes, int timeout_ms) noexcept
{
  pollfd input{ this->file_, POLLIN, 0 };
  const int ready = poll(&input, 1, timeout_ms);
  if (ready <= 0)
  {
    return 0;
  }
  const ssize_t count = ::read(this->file_, bytes.data(), bytes.size());
  this->failed_ = count < 0 ? errno : 0;
  const bool gone = count < 0 ? errno != EAGAIN : count == 0 && (input.revents & (POLLHUP | POLLERR)) != 0;
  return gone ? -1 : count < 0 ? 0 : static_cast<int>(count);
}

std::string SerialPort::error() const
{
  return std::strerror(this->failed_);
}

} // namespace palpate
