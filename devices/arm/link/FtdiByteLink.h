// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <utility>

#include "devices/arm/link/ByteLink.h"
#include "devices/arm/link/FtdiPort.h"

namespace palpate
{

/// The bytes behind an FTDI chip, without the two that the chip puts before each transfer. A chip that has nothing to
/// say still answers after its latency, a millisecond: so long a look takes.
class FtdiByteLink final : public ByteLink
{
public:
  explicit FtdiByteLink(std::shared_ptr<FtdiPort> port) : port_(std::move(port)) {}

  [[nodiscard]] bool send(std::span<const std::uint8_t> bytes) noexcept override { return this->port_->write(bytes); }
  [[nodiscard]] int receive(std::span<std::uint8_t> bytes, int timeout_ms) noexcept override;
  [[nodiscard]] std::string error() const override { return this->port_->error(); }
  [[nodiscard]] bool keepsBorders() const noexcept override { return false; }
  [[nodiscard]] bool looksForFree() const noexcept override { return false; }

private:
  std::shared_ptr<FtdiPort> port_;
};

} // namespace palpate
