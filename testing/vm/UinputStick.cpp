// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/UinputStick.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <linux/uinput.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "testing/devices/evdev/FakeEvdevBus.h"

namespace palpate::test
{
namespace
{

using SteadyClock = std::chrono::steady_clock;
constexpr auto millisecond = std::chrono::milliseconds(1);
constexpr auto mostBehind = std::chrono::milliseconds(20);
constexpr int endOfTravel = 32767;

void must(bool done, const char* what)
{
  if (!done)
  {
    throw std::system_error(errno, std::generic_category(), what);
  }
}

template<std::size_t N>
void offer(int file, unsigned long request, const std::bitset<N>& bits)
{
  for (std::size_t bit = 0; bit < N; ++bit)
  {
    must(!bits[bit] || ::ioctl(file, request, static_cast<int>(bit)) == 0, "/dev/uinput: a bit");
  }
}

} // namespace

UinputStick::UinputStick(std::uint16_t product) : driver_(stickTraits())
{
  this->create(product);
  this->driver_.position = { 0.01, 0.01 }; // of a place where all is 0 the kernel says nothing
  this->thread_ = std::thread([this] { this->run(); });
}

UinputStick::~UinputStick()
{
  this->stop_ = true;
  this->thread_.join();
  static_cast<void>(::ioctl(this->file_, UI_DEV_DESTROY));
  ::close(this->file_);
}

void UinputStick::create(std::uint16_t product)
{
  this->file_ = ::open("/dev/uinput", O_RDWR | O_NONBLOCK | O_CLOEXEC);
  must(this->file_ >= 0, "/dev/uinput");
  const EvdevTraits traits = stickTraits();
  for (const int type : { EV_KEY, EV_ABS, EV_FF })
  {
    must(::ioctl(this->file_, UI_SET_EVBIT, type) == 0, "UI_SET_EVBIT");
  }
  offer(this->file_, UI_SET_ABSBIT, traits.axes);
  offer(this->file_, UI_SET_KEYBIT, traits.keys);
  offer(this->file_, UI_SET_FFBIT, traits.forces);
  for (std::size_t axis = 0; axis < traits.axes.size(); ++axis)
  {
    uinput_abs_setup range{};
    range.code = static_cast<std::uint16_t>(axis);
    range.absinfo.minimum = -endOfTravel;
    range.absinfo.maximum = endOfTravel;
    must(!traits.axes[axis] || ::ioctl(this->file_, UI_ABS_SETUP, &range) == 0, "UI_ABS_SETUP");
  }
  uinput_setup is{};
  is.id = { BUS_USB, vendor, product, 1 };
  is.ff_effects_max = VirtualDriver::memory;
  std::strcpy(is.name, "Palpate test stick");
  must(::ioctl(this->file_, UI_DEV_SETUP, &is) == 0, "UI_DEV_SETUP");
  must(::ioctl(this->file_, UI_DEV_CREATE) == 0, "UI_DEV_CREATE");
}

void UinputStick::run()
{
  SteadyClock::time_point next = SteadyClock::now() + millisecond;
  while (!this->stop_)
  {
    pollfd waiting{ this->file_, POLLIN, 0 };
    const auto left = std::max(next - SteadyClock::now(), SteadyClock::duration::zero());
    const timespec wait{ 0, std::chrono::nanoseconds(left).count() };
    if (::ppoll(&waiting, this->hangs ? 0 : 1, &wait, nullptr) > 0)
    {
      this->answer();
    }
    if (const SteadyClock::time_point now = SteadyClock::now(); now >= next)
    {
      this->alone([](VirtualDriver& driver) { driver.advance(1); });
      this->showHandle();
      ++this->time_ms_;
      next = now - next > mostBehind ? now : next + millisecond;
    }
  }
}

void UinputStick::answer()
{
  input_event asked{};
  if (::read(this->file_, &asked, sizeof asked) != static_cast<ssize_t>(sizeof asked))
  {
    return;
  }
  if (asked.type == EV_UINPUT && asked.code == UI_FF_UPLOAD)
  {
    this->answerUpload(asked.value);
  }
  else if (asked.type == EV_UINPUT && asked.code == UI_FF_ERASE)
  {
    this->answerErase(asked.value);
  }
  else if (asked.type == EV_FF)
  {
    this->alone([&](VirtualDriver& driver) { driver.told(asked.code, asked.value); });
  }
}

void UinputStick::answerUpload(std::int32_t request)
{
  uinput_ff_upload upload{};
  upload.request_id = static_cast<std::uint32_t>(request);
  if (::ioctl(this->file_, UI_BEGIN_FF_UPLOAD, &upload) == 0)
  {
    this->alone([&](VirtualDriver& driver) { driver.store(upload.effect); });
    upload.retval = 0;
    static_cast<void>(::ioctl(this->file_, UI_END_FF_UPLOAD, &upload));
  }
}

void UinputStick::answerErase(std::int32_t request)
{
  uinput_ff_erase erase{};
  erase.request_id = static_cast<std::uint32_t>(request);
  if (::ioctl(this->file_, UI_BEGIN_FF_ERASE, &erase) == 0)
  {
    erase.retval = -this->alone([&](VirtualDriver& driver) { return driver.erase(static_cast<int>(erase.effect_id)); });
    static_cast<void>(::ioctl(this->file_, UI_END_FF_ERASE, &erase));
  }
}

void UinputStick::say(std::uint16_t type, std::uint16_t code, std::int32_t value) const
{
  input_event event{};
  event.type = type;
  event.code = code;
  event.value = value;
  static_cast<void>(::write(this->file_, &event, sizeof event));
}

void UinputStick::showHandle()
{
  const VirtualDriver::Axes at = this->alone([](VirtualDriver& driver) { return driver.position; });
  if (at != this->shown_)
  {
    this->shown_ = at;
    this->say(EV_ABS, ABS_X, static_cast<std::int32_t>(std::lround(endOfTravel * at[0])));
    this->say(EV_ABS, ABS_Y, static_cast<std::int32_t>(std::lround(endOfTravel * at[1])));
    this->say(EV_SYN, SYN_REPORT, 0);
  }
}

} // namespace palpate::test
