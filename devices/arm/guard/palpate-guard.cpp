// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-guard ENDPOINT HEX: sleeps until the pipe on descriptor 3 breaks or the program that started this one has
// ended, then writes the bytes of HEX to the device on descriptor 4 and ends. ENDPOINT 0: the device is a file that is
// written to; else a USB device whose bulk endpoint has that number. Exit code 0: the device took them.
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <linux/usbdevice_fs.h>
#include <poll.h>
#include <string_view>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <unistd.h>
#include <vector>

namespace
{

constexpr int pipeEnd = 3, device = 4;
constexpr int attempts = 20;
constexpr unsigned attempt_ms = 50;

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

/// A child of that program that was forked and holds a copy of the pipe would hide its death, so it is looked besides
/// whether the program is still the parent.
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
  if (count != 3)
  {
    return 2;
  }
  const std::string_view number = arguments[1];
  unsigned endpoint = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), endpoint);
  std::vector<std::uint8_t> bytes = bytesOf(arguments[2]);
  if (error != std::errc() || end != number.data() + number.size() || bytes.empty())
  {
    return 2;
  }
  prctl(PR_SET_NAME, "palpate-guard");
  sleepUntilItIsOver(getppid());
  // A message that its program's death cut short takes the first of these bytes as its own, so they are sent again.
  bool taken = false;
  for (int i = 0; i < attempts; ++i)
  {
    taken = writeTo(bytes, endpoint) || taken;
    usleep(5000);
  }
  return taken ? 0 : 1;
}
