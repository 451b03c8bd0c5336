// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "devices/arm/ArmLine.h"

namespace palpate
{

/// Arms among the HID devices of a bus.
class HidArmBus final : public ArmBus
{
public:
  /// Bytes of a report of such a device; 0: it is no arm of that kind.
  using Which = std::function<std::size_t(const HidEntry&)>;

  HidArmBus(std::shared_ptr<HidBus> hid, std::shared_ptr<const WireProtocol> protocol, Which which)
    : hid_(std::move(hid)), protocol_(std::move(protocol)), which_(std::move(which))
  {
  }

  [[nodiscard]] std::vector<HidEntry> devices() override;
  [[nodiscard]] Descriptor descriptor(const HidEntry& entry) override { return this->hid_->descriptor(entry); }
  [[nodiscard]] Opened open(const HidEntry& entry) override;
  [[nodiscard]] std::string refusal(const HidEntry& entry) override { return this->hid_->open(entry).problem; }

private:
  std::shared_ptr<HidBus> hid_;
  std::shared_ptr<const WireProtocol> protocol_;
  Which which_;
};

} // namespace palpate
