// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-guard PROCESS ENDPOINT HEX: sleeps until the pipe on descriptor 3 breaks or its parent is not PROCESS any
// more, then writes the bytes of HEX to the device on descriptor 4 and ends. ENDPOINT 0: the device is a file that is
// written to; else a USB device whose bulk endpoint has that number. Exit code 0: the device took them.
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <linux/usbdevice_fs.h>
#include <optional>
#include <poll.h>
#include <string_view>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <unistd.h>
#include <vector>

namespace
{

constexpr int pipeEnd = 3, device = 4;
constexpr int attempts = 15;
constexpr unsigned attempt_ms = 20, pause_ms = 5;

/// None: this is no number.
template<typename Number>
std::optional<Number> numberOf(std::string_view digits)
{
  Number number{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = error == std::errc() && end == digits.data() + digits.size();
  return whole ? std::optional<Number>(number) : std::nullopt;
}

/// Empty: they are no such digits.
std::vector<std::uint8_t> bytesOf(std::string_view hex)
{
  std::vector<std::uint8_t> bytes(hex.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const char* const digits = hex.data() + 2 * i;
    const auto [end, error] = std::from_chars(digits, digits + 2, bytes[i], 16);
    if (error != std::errc() || end != digits + 2)
    {
      return {};
    }
  }
  return hex.size() % 2 == 0 ? bytes : std::vector<std::uint8_t>{};
}

/// A child of that program that was forked and holds a copy of the pipe would hide its death, so its being the parent
/// is looked at, too. The program tells its number, as it may have died before this one asks for its parent's.
void sleepUntilItIsOver(pid_t program)
{
  constexpr int look_ms = 50;
  int woken = 0;
  while (woken == 0 || (woken < 0 && errno == EINTR))
  {
    pollfd pipe{ pipeEnd, 0, 0 };
    woken = getppid() != program ? 1 : poll(&pipe, 1, look_ms);
  }
}

bool writeTo(std::vector<std::uint8_t>& bytes, unsigned endpoint)
{
  if (endpoint == 0)
  {
    return write(device, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  }
  usbdevfs_bulktransfer transfer{ endpoint, static_cast<unsigned>(bytes.size()), attempt_ms, bytes.data() };
  return ioctl(device, USBDEVFS_BULK, &transfer) == static_cast<int>(bytes.size());
}

} // namespace

int main(int count, char** arguments)
{
  if (count != 4)
  {
    return 2;
  }
  const std::optional<pid_t> program = numberOf<pid_t>(arguments[1]);
  const std::optional<unsigned> endpoint = numberOf<unsigned>(arguments[2]);
  std::vector<std::uint8_t> bytes = bytesOf(arguments[3]);
  if (!program || !endpoint || bytes.empty())
  {
    return 2;
  }
  prctl(PR_SET_NAME, "palpate-guard");
  sleepUntilItIsOver(*program);
  bool taken = writeTo(bytes, *endpoint);
  for (int i = 1; i < attempts && !taken; ++i)
  {
    usleep(1000 * pause_ms);
    taken = writeTo(bytes, *endpoint);
  }
  return taken ? 0 : 1;
}
