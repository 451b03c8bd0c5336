// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "devices/arm/link/ByteLink.h"
#include "devices/arm/link/FileLock.h"
#include "devices/hid/HidConnection.h"

namespace palpate
{

/// The reports of a HID device without numbers, all of one length. The system lets any program open such a device: a
/// lock on its file keeps programs out that ask for one.
class HidByteLink final : public ByteLink
{
public:
  HidByteLink(std::unique_ptr<HidConnection> connection, std::size_t reportBytes, FileLock lock)
    : lock_(std::move(lock)), connection_(std::move(connection)), report_(1 + reportBytes)
  {
  }

  [[nodiscard]] bool send(std::span<const std::uint8_t> bytes) noexcept override;
  [[nodiscard]] int receive(std::span<std::uint8_t> bytes, int timeout_ms) noexcept override
  {
    return this->connection_->read(bytes, timeout_ms);
  }
  [[nodiscard]] std::string error() const override { return this->connection_->error(); }
  [[nodiscard]] bool keepsBorders() const noexcept override { return true; }

private:
  FileLock lock_; ///< ends after the connection
  std::unique_ptr<HidConnection> connection_;
  std::vector<std::uint8_t> report_; ///< behind a number that is 0
};

} // namespace palpate
