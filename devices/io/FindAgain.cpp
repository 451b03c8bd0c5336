// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/FindAgain.h"

#include <algorithm>
#include <utility>

#include "devices/hid/NamedDevices.h"

namespace palpate
{
namespace
{

std::optional<HidEntry> at(const std::string& path, const std::vector<HidEntry>& entries)
{
  const auto found =
    std::find_if(entries.begin(), entries.end(), [&](const HidEntry& entry) { return entry.path == path; });
  return found == entries.end() ? std::nullopt : std::optional(*found);
}

} // namespace

FoundDevice DeviceSearch::first(DeviceListing& bus)
{
  const std::vector<HidEntry> alike = this->alike(bus);
  const std::optional<HidEntry> inPlace = at(this->wanted_.path, alike);
  return inPlace ? FoundDevice{ inPlace, {} } : this->only(alike);
}

/// After a loose contact, or when the system wakes up, the device may be back at another path before the first search.
/// A serial number without a twin identifies the device; without a number it is a stranger until it is unplugged again.
void DeviceSearch::lost(DeviceListing& bus)
{
  if (std::exchange(this->looking_, true))
  {
    return;
  }
  const std::vector<HidEntry> alike = this->alike(bus);
  this->mayBeOwn_ = !this->hadTwin_ && alike.size() == 1 && alike.front().path != this->wanted_.path;
  this->others_.clear();
  if (this->mayBeOwn_ && !this->wanted_.serial.empty())
  {
    return;
  }
  for (const HidEntry& entry : alike)
  {
    if (entry.path != this->wanted_.path)
    {
      this->others_.push_back(entry.path);
    }
  }
}

FoundDevice DeviceSearch::again(DeviceListing& bus)
{
  const std::vector<HidEntry> alike = this->alike(bus);
  if (this->mayBeOwn_)
  {
    std::erase_if(this->others_, [&](const std::string& path) { return !at(path, alike); });
  }
  return this->newcomer(alike);
}

void DeviceSearch::found(DeviceListing& bus, const HidEntry& entry)
{
  this->wanted_ = entry;
  this->descriptor_ = bus.descriptor(entry).value;
  this->hadTwin_ = this->hadTwin_ || this->alike(bus).size() > 1;
  this->looking_ = false;
}

/// One plug may have several interfaces, each with its own descriptor.
std::vector<HidEntry> DeviceSearch::alike(DeviceListing& bus) const
{
  std::vector<HidEntry> alike = bus.devices();
  std::erase_if(alike,
    [&](const HidEntry& entry)
    {
      return !sameKind(entry, this->wanted_) ||
             (!this->descriptor_.empty() && bus.descriptor(entry).value != this->descriptor_);
    });
  return alike;
}

FoundDevice DeviceSearch::only(const std::vector<HidEntry>& alike) const
{
  if (alike.empty())
  {
    return { std::nullopt, this->name() + " is not attached: plug the device in" };
  }
  if (alike.size() == 1)
  {
    return { alike.front(), {} };
  }
  return { std::nullopt, "there are " + std::to_string(alike.size()) + " of " + this->name() +
                           " attached, and they cannot be distinguished: plug in only one" };
}

FoundDevice DeviceSearch::newcomer(const std::vector<HidEntry>& alike) const
{
  std::vector<HidEntry> come = alike;
  std::erase_if(come, [&](const HidEntry& entry)
    { return std::find(this->others_.begin(), this->others_.end(), entry.path) != this->others_.end(); });
  if (!come.empty() && alike.size() - come.size() < this->others_.size())
  {
    return { std::nullopt, "another one of " + this->name() +
                             " disconnected meanwhile, and they cannot be distinguished: plug in only the right one, "
                             "then choose the device again" };
  }
  return this->only(come);
}

std::string DeviceSearch::name() const
{
  return "\"" + this->wanted_.name + "\"" + (this->wanted_.serial.empty() ? "" : " " + this->wanted_.serial);
}

} // namespace palpate
