// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "devices/common/AttributeFile.h"
#include "devices/evdev/EvdevSysfs.h"
#include "devices/hid/HidapiBus.h"

namespace palpate
{
namespace
{

namespace fs = std::filesystem;

const fs::path classFolder = "/sys/class/input";

fs::path folderOf(const HidEntry& entry)
{
  return classFolder / fs::path(entry.path).filename();
}

class EventFile final : public EvdevConnection
{
public:
  EventFile(int file, fs::path settings) : file_(file), settings_(std::move(settings)) {}
  ~EventFile() override { ::close(this->file_); }
  EventFile(const EventFile&) = delete;
  EventFile& operator=(const EventFile&) = delete;

  int read(std::span<input_event> events, int timeout_ms) noexcept override
  {
    pollfd waiting{ this->file_, POLLIN, 0 };
    if (::poll(&waiting, 1, timeout_ms) < 0)
    {
      return errno == EINTR ? 0 : -1;
    }
    const ssize_t size = (waiting.revents & POLLIN) != 0 ? ::read(this->file_, events.data(), events.size_bytes()) : 0;
    const bool gone = (waiting.revents & (POLLHUP | POLLERR)) != 0 || (size < 0 && errno != EAGAIN && errno != EINTR);
    return gone ? -1 : size <= 0 ? 0 : static_cast<int>(static_cast<std::size_t>(size) / sizeof(input_event));
  }

  std::optional<input_absinfo> axis(std::uint16_t code) noexcept override
  {
    input_absinfo info{};
    return this->ask(EVIOCGABS(code), &info) ? std::optional(info) : std::nullopt;
  }

  std::bitset<KEY_CNT> keys() noexcept override
  {
    std::array<std::uint8_t, KEY_CNT / 8> bytes{};
    std::bitset<KEY_CNT> down;
    if (this->ask(EVIOCGKEY(sizeof bytes), bytes.data()))
    {
      for (std::size_t key = 0; key < KEY_CNT; ++key)
      {
        down.set(key, (bytes[key / 8] >> (key % 8) & 1U) != 0);
      }
    }
    return down;
  }

  EvdevTaken upload(ff_effect& effect) noexcept override
  {
    return this->ask(EVIOCSFF, &effect) ? EvdevTaken::Yes : this->error_ == EAGAIN ? EvdevTaken::Later : EvdevTaken::No;
  }

  bool erase(int effect) noexcept override { return this->noted(::ioctl(this->file_, EVIOCRMFF, effect) >= 0); }

  bool tell(std::uint16_t code, std::int32_t value) noexcept override
  {
    input_event event{};
    event.type = EV_FF;
    event.code = code;
    event.value = value;
    return this->noted(::write(this->file_, &event, sizeof event) == static_cast<ssize_t>(sizeof event));
  }

  std::optional<int> setting(const std::string& name) noexcept override
  {
    const std::string text = contentOf(this->settings_ / name);
    int value = 0;
    const bool read = std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
    return read ? std::optional(value) : std::nullopt;
  }

  std::string error() const override { return std::strerror(this->error_); }

private:
  bool ask(unsigned long request, void* answer) noexcept
  {
    int result = -1;
    do
    {
      result = ::ioctl(this->file_, request, answer);
    } while (result < 0 && errno == EINTR);
    return this->noted(result >= 0);
  }
  bool noted(bool good) noexcept
  {
    this->error_ = good ? 0 : errno;
    return good;
  }

  int file_;
  fs::path settings_;          ///< folder of the driver's files
  std::atomic<int> error_ = 0; ///< reader and writer ask at once
};

class SystemEvdevBus final : public EvdevBus
{
public:
  std::vector<HidEntry> devices() override
  {
    std::vector<HidEntry> all;
    std::error_code problem;
    for (fs::directory_iterator it(classFolder, problem), end; !problem && it != end; it.increment(problem))
    {
      if (it->path().filename().string().starts_with("event"))
      {
        all.push_back(entryOf(it->path()));
      }
    }
    return all;
  }

  Descriptor descriptor(const HidEntry& entry) override
  {
    const std::vector<std::vector<std::uint8_t>> all = this->behindPlug(entry);
    return { all.empty() ? std::vector<std::uint8_t>{} : all.front(), {} };
  }

  EvdevTraits traits(const HidEntry& entry) override { return traitsOf(folderOf(entry)); }

  std::vector<std::vector<std::uint8_t>> behindPlug(const HidEntry& entry) override
  {
    std::vector<std::vector<std::uint8_t>> all;
    for (const fs::path& folder : hidFolders(folderOf(entry)))
    {
      const std::string bytes = contentOf(folder / "report_descriptor");
      all.emplace_back(bytes.begin(), bytes.end());
    }
    return all;
  }

  Opened open(const HidEntry& entry) override
  {
    const std::vector<fs::path> folders = hidFolders(folderOf(entry));
    if (const std::string holder = hidrawHolder(folders); !holder.empty())
    {
      return { nullptr,
        "the program " + holder + " drives the device and bypasses the kernel driver: close that program first" };
    }
    const int file = ::open(entry.path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
    {
      return { nullptr, openProblem(entry.path, errno) };
    }
    return { std::make_unique<EventFile>(file, folders.empty() ? fs::path() : folders.front()), {} };
  }
};

} // namespace

std::shared_ptr<EvdevBus> systemEvdevBus()
{
  return std::make_shared<SystemEvdevBus>();
}

} // namespace palpate
