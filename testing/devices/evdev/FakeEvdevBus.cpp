// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/evdev/FakeEvdevBus.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>

namespace palpate::test
{
namespace
{

class FakeEventFile final : public EvdevConnection
{
public:
  explicit FakeEventFile(FakeEvdevPort& port) : port_(port) { ++this->port_.opened; }
  ~FakeEventFile() override
  {
    ++this->port_.closed;
    this->port_.driver.flush();
  }

  int read(std::span<input_event> events, int) noexcept override
  {
    std::size_t count = 0;
    for (; count < events.size() && !this->port_.events.empty(); ++count)
    {
      events[count] = this->port_.events.front();
      this->port_.events.pop_front();
    }
    return this->port_.present ? static_cast<int>(count) : -1;
  }

  std::optional<input_absinfo> axis(std::uint16_t code) noexcept override
  {
    const auto it = this->port_.axes.find(code);
    return it == this->port_.axes.end() ? std::nullopt : std::optional(it->second);
  }

  std::bitset<KEY_CNT> keys() noexcept override { return this->port_.keys; }

  EvdevTaken upload(ff_effect& effect) noexcept override
  {
    if (const auto happens = std::exchange(this->port_.whileUploading, nullptr))
    {
      happens();
    }
    if (this->port_.busyFor > 0)
    {
      --this->port_.busyFor;
      return EvdevTaken::Later;
    }
    const bool fails = this->port_.uploadsThatFail > 0 && this->port_.uploadsThatFail-- > 0;
    this->error_ = !this->port_.present ? ENODEV : fails ? EIO : this->port_.driver.upload(effect);
    return this->error_ == 0 ? EvdevTaken::Yes : EvdevTaken::No;
  }

  bool erase(int effect) noexcept override
  {
    this->error_ = this->port_.present ? this->port_.driver.erase(effect) : ENODEV;
    return this->error_ == 0;
  }

  bool tell(std::uint16_t code, std::int32_t value) noexcept override
  {
    this->error_ = this->port_.present ? 0 : ENODEV;
    if (this->port_.present)
    {
      this->port_.driver.told(code, value);
    }
    return this->port_.present;
  }

  std::optional<int> setting(const std::string& name) noexcept override
  {
    const auto it = this->port_.settings.find(name);
    return it == this->port_.settings.end() ? std::nullopt : std::optional(it->second);
  }

  std::string error() const override { return std::strerror(this->error_); }

private:
  FakeEvdevPort& port_;
  int error_ = 0;
};

template<std::size_t N>
void setAll(std::bitset<N>& bits, std::initializer_list<int> numbers)
{
  for (const int number : numbers)
  {
    bits.set(static_cast<std::size_t>(number));
  }
}

} // namespace

EvdevTraits traitsWith(
  std::initializer_list<int> axes, std::initializer_list<int> keys, std::initializer_list<int> forces)
{
  EvdevTraits traits;
  setAll(traits.axes, axes);
  setAll(traits.keys, keys);
  setAll(traits.forces, forces);
  return traits;
}

EvdevTraits stickTraits()
{
  return traitsWith({ ABS_X, ABS_Y, ABS_THROTTLE }, { BTN_TRIGGER, BTN_THUMB, BTN_TOP },
    { FF_CONSTANT, FF_PERIODIC, FF_SINE, FF_SPRING, FF_DAMPER, FF_GAIN, FF_AUTOCENTER });
}

EvdevTraits wheelTraits()
{
  return traitsWith(
    { ABS_X, ABS_Y, ABS_Z, ABS_RZ }, { BTN_TRIGGER, BTN_THUMB }, { FF_CONSTANT, FF_GAIN, FF_AUTOCENTER });
}

void FakeEvdevPort::say(std::uint16_t type, std::uint16_t code, std::int32_t value)
{
  input_event event{};
  event.type = type;
  event.code = code;
  event.value = value;
  this->events.push_back(event);
  if (type == EV_ABS)
  {
    this->axes[code].value = value;
  }
  else if (type == EV_KEY)
  {
    this->keys.set(code, value != 0);
  }
}

void FakeEvdevPort::move(std::uint16_t axis, double share)
{
  const input_absinfo& range = this->axes[axis];
  const double half = 0.5 * (static_cast<double>(range.maximum) - range.minimum);
  this->say(EV_ABS, axis, static_cast<std::int32_t>(std::lround(range.minimum + half * (1.0 + share))));
  this->end();
}

FakeEvdevPort& FakeEvdevBus::plug(
  const EvdevTraits& traits, const std::string& serial, std::uint16_t vendor, std::uint16_t product)
{
  const std::string path = "/dev/input/event" + std::to_string(this->ports_.size());
  this->ports_.push_back(
    std::make_unique<FakeEvdevPort>(HidEntry{ path, vendor, product, serial, "virtual device", 0 }, traits));
  for (std::size_t axis = 0; axis < traits.axes.size(); ++axis)
  {
    if (traits.axes[axis])
    {
      this->ports_.back()->axes[static_cast<int>(axis)] = input_absinfo{ 0, -32768, 32767, 0, 0, 0 };
    }
  }
  return *this->ports_.back();
}

FakeEvdevPort* FakeEvdevBus::at(const std::string& path)
{
  const auto it = std::find_if(this->ports_.begin(), this->ports_.end(),
    [&](const auto& port) { return port->present && port->entry.path == path; });
  return it == this->ports_.end() ? nullptr : it->get();
}

std::vector<HidEntry> FakeEvdevBus::devices()
{
  std::vector<HidEntry> all;
  for (const auto& port : this->ports_)
  {
    if (port->present)
    {
      all.push_back(port->entry);
    }
  }
  return all;
}

EvdevBus::Descriptor FakeEvdevBus::descriptor(const HidEntry& entry)
{
  const std::vector<std::vector<std::uint8_t>> all = this->behindPlug(entry);
  return { all.empty() ? std::vector<std::uint8_t>{} : all.front(), {} };
}

EvdevTraits FakeEvdevBus::traits(const HidEntry& entry)
{
  const FakeEvdevPort* const port = this->at(entry.path);
  return port != nullptr ? port->traits : EvdevTraits{};
}

std::vector<std::vector<std::uint8_t>> FakeEvdevBus::behindPlug(const HidEntry& entry)
{
  const FakeEvdevPort* const port = this->at(entry.path);
  return port != nullptr ? port->behindPlug : std::vector<std::vector<std::uint8_t>>{};
}

EvdevBus::Opened FakeEvdevBus::open(const HidEntry& entry)
{
  FakeEvdevPort* const port = this->at(entry.path);
  if (port == nullptr || !port->openProblem.empty())
  {
    return { nullptr, port == nullptr ? "gone" : port->openProblem };
  }
  return { std::make_unique<FakeEventFile>(*port), "" };
}

void FakeEvdevBus::advance(int duration_ms)
{
  this->time.now_ms += duration_ms;
  for (const auto& port : this->ports_)
  {
    port->driver.advance(duration_ms);
  }
}

} // namespace palpate::test
