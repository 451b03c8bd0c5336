// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "devices/arm/ArmLine.h"

namespace palpate
{

/// Arms that something lists and opens, without descriptors.
class ListedArmBus final : public ArmBus
{
public:
  struct Ways
  {
    std::function<std::vector<HidEntry>()> list;
    std::function<Opened(const HidEntry&)> open;
    std::function<std::string(const HidEntry&)> refusal;   ///< tells the device nothing
    std::function<std::string(const HidEntry&)> note = {}; ///< likewise; null: there is none
  };
  explicit ListedArmBus(Ways ways) : ways_(std::move(ways)) {}

  [[nodiscard]] std::vector<HidEntry> devices() override { return this->ways_.list(); }
  [[nodiscard]] Descriptor descriptor(const HidEntry& /*entry*/) override { return {}; }
  [[nodiscard]] Opened open(const HidEntry& entry) override { return this->ways_.open(entry); }
  [[nodiscard]] std::string refusal(const HidEntry& entry) override { return this->ways_.refusal(entry); }
  [[nodiscard]] std::string note(const HidEntry& entry) override
  {
    return this->ways_.note ? this->ways_.note(entry) : std::string();
  }

private:
  Ways ways_;
};

} // namespace palpate
