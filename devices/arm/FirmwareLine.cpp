// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/FirmwareLine.h"

#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "devices/arm/link/FtdiByteLink.h"
#include "devices/arm/protocol/FalconStart.h"
#include "devices/arm/protocol/FalconWire.h"
#include "devices/common/AttributeFile.h"

namespace palpate
{
namespace
{

constexpr std::uintmax_t longestFirmware = 1U << 20U;
constexpr int probes = 5, probe_ms = 20;

} // namespace

std::string FirmwareLine::begin()
{
  if (!setForPackets(*this->port_))
  {
    return "the chip of the device does not take its settings: " + this->port_->error();
  }
  return this->runs() ? this->guarded() : std::string();
}

/// The order for no force is the question, so no guard is needed for it.
bool FirmwareLine::runs()
{
  WireLine line(std::make_unique<FtdiByteLink>(this->port_), std::make_shared<FalconWire>());
  for (int i = 0; i < probes; ++i)
  {
    if (line.exchange({}, probe_ms).said == Said::Reading)
    {
      return true;
    }
  }
  return false;
}

/// Its chip answers within a millisecond, whatever is behind it.
bool FirmwareLine::isThere() noexcept
{
  constexpr int longest_ms = 3;
  std::array<std::uint8_t, 64> transfer;
  return this->port_->read(transfer, longest_ms) >= 0;
}

std::string FirmwareLine::guarded()
{
  const auto wire = std::make_shared<FalconWire>();
  Outcome<Guard> guard = Guard::start(this->port_->handle(), FtdiPort::out, wire->farewell());
  if (!guard.ok())
  {
    return guard.problem;
  }
  this->line_ = std::make_unique<WireLine>(std::make_unique<FtdiByteLink>(this->port_), wire, std::move(guard.value));
  this->running_ = true;
  return {};
}

std::string FirmwareLine::load(const std::string& file)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size == 0 || size > longestFirmware)
  {
    return error ? "it cannot be read: " + error.message() : "its size is not that of a firmware";
  }
  const std::string bytes = contentOf(file);
  std::string problem = loadFalconFirmware(
    *this->port_, { reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size() }, this->clock_);
  if (problem.empty() && !(setForPackets(*this->port_) && this->runs()))
  {
    problem = "the device took it, but does not answer: the file is not its firmware";
  }
  return problem;
}

void FirmwareLine::proceed()
{
  std::optional<std::string> file;
  {
    const std::lock_guard lock(this->mutex_);
    file = std::exchange(this->chosen_, std::nullopt);
  }
  if (!file || this->running_)
  {
    this->gone_ = !this->running_ && !this->isThere();
    return;
  }
  const std::string problem = this->load(*file);
  const std::string unguarded = problem.empty() ? this->guarded() : "";
  this->gone_ = !problem.empty() && !this->isThere();
  const std::lock_guard lock(this->mutex_);
  this->failed_ = problem.empty() ? "" : "The firmware " + *file + " was not loaded: " + problem + ". ";
  this->unguarded_ = unguarded;
}

std::optional<DeviceStep> FirmwareLine::step() const
{
  if (this->running_ || this->gone_)
  {
    return std::nullopt;
  }
  const std::lock_guard lock(this->mutex_);
  if (!this->unguarded_.empty())
  {
    return DeviceStep{ "There is no force: " + this->unguarded_ + ".", "", false };
  }
  return DeviceStep{ this->failed_ + "The device has no firmware: choose the maker's file that you have for it.",
    "Choose Firmware...", true };
}

void FirmwareLine::stepDone(const std::string& file)
{
  const std::lock_guard lock(this->mutex_);
  this->chosen_ = file;
}

ArmLine::Answer FirmwareLine::exchange(const WireOrder& order, int timeout_ms)
{
  return this->line_ != nullptr ? this->line_->exchange(order, timeout_ms) : Answer{};
}

void FirmwareLine::letGo() noexcept
{
  if (this->line_ != nullptr)
  {
    this->line_->letGo();
  }
}

std::string FirmwareLine::error() const
{
  return this->line_ != nullptr ? this->line_->error()
         : this->gone_          ? "the cable was unplugged"
                                : "the device has no firmware";
}

} // namespace palpate
