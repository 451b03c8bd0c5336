// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/HidArmBus.h"

#include "devices/arm/WireLine.h"
#include "devices/arm/link/HidByteLink.h"

namespace palpate
{

std::vector<HidEntry> HidArmBus::devices()
{
  std::vector<HidEntry> arms = this->hid_->devices();
  std::erase_if(arms, [this](const HidEntry& entry) { return this->which_(entry) == 0; });
  return arms;
}

ArmBus::Opened HidArmBus::open(const HidEntry& entry)
{
  Outcome<FileLock> lock = FileLock::take(entry.path);
  if (!lock.ok())
  {
    return { nullptr, std::move(lock.problem) };
  }
  HidBus::Opened opened = this->hid_->open(entry);
  if (opened.value == nullptr)
  {
    return { nullptr, std::move(opened.problem) };
  }
  auto line = std::make_unique<WireLine>(
    std::make_unique<HidByteLink>(std::move(opened.value), this->which_(entry), std::move(lock.value)),
    this->protocol_);
  std::string problem = line->begin();
  return { problem.empty() ? std::move(line) : nullptr, problem };
}

} // namespace palpate
