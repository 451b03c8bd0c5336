// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "devices/arm/WireLine.h"

namespace palpate
{

/// A wire beside which a channel tells of events that end the force.
class ServiceLine final : public ArmLine
{
public:
  /// The event that a message of the channel stops the device for; empty: none.
  using Stops = std::function<std::string(std::string_view message)>;

  /// `events` may be null: a service without that channel.
  ServiceLine(std::unique_ptr<WireLine> line, std::unique_ptr<ByteLink> events, Stops stops)
    : line_(std::move(line)), events_(std::move(events)), stops_(std::move(stops)), message_(longest)
  {
  }

  [[nodiscard]] Answer exchange(const WireOrder& order, int timeout_ms) override;
  void letGo() noexcept override { this->line_->letGo(); }
  [[nodiscard]] std::string error() const override
  {
    return this->error_.empty() ? this->line_->error() : this->error_;
  }

private:
  static constexpr std::size_t longest = 65536;

  std::unique_ptr<WireLine> line_;
  std::unique_ptr<ByteLink> events_;
  Stops stops_;
  WireBytes message_;
  std::string error_;
};

} // namespace palpate
