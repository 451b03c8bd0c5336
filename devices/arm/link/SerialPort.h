// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/arm/link/ByteLink.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

/// A serial line, raw, for this process alone. A write is taken whole or not at all as long as it is shorter than a
/// buffer of the kernel's driver, so that a device never gets half a message of a program that dies.
class SerialPort final : public ByteLink
{
public:
  [[nodiscard]] static Outcome<std::unique_ptr<SerialPort>> open(const std::string& path);
  ~SerialPort() override;
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  [[nodiscard]] bool send(std::span<const std::uint8_t> bytes) noexcept override;
  [[nodiscard]] int receive(std::span<std::uint8_t> bytes, int timeout_ms) noexcept override;
  [[nodiscard]] std::string error() const override;
  [[nodiscard]] bool keepsBorders() const noexcept override { return false; }
  /// The open file, for a guard.
  [[nodiscard]] int handle() const noexcept { return this->file_; }

private:
  explicit SerialPort(int file) noexcept : file_(file) {}

  int file_;
  int failed_ = 0;
};

} // namespace palpate
