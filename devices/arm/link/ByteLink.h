// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "devices/common/LinkNotes.h"

namespace palpate
{

/// An open link that carries bytes. Calls may block; one thread.
class ByteLink
{
public:
  virtual ~ByteLink() = default;

  /// False: the link is gone or has not taken all of it in time.
  [[nodiscard]] virtual bool send(std::span<const std::uint8_t> bytes) noexcept = 0;
  /// Waits that long at most for bytes, and returns how many came, 0 when none came, below 0 when the link is gone.
  [[nodiscard]] virtual int receive(std::span<std::uint8_t> bytes, int timeout_ms) noexcept = 0;
  /// The system's message for the last failure, for a person.
  [[nodiscard]] virtual std::string error() const = 0;
  /// Phrases for a person: why receive() says that the link is gone, and why send() has just failed.
  [[nodiscard]] virtual std::string gone() const { return "the cable was unplugged"; }
  [[nodiscard]] virtual std::string unsent() const { return describeFailedWrite(this->error()); }
  /// The bytes of one receive() are one message; else they are a part of a stream.
  [[nodiscard]] virtual bool keepsBorders() const noexcept = 0;
  /// To look whether something has come takes no time; else it is looked only after an answer that was none.
  [[nodiscard]] virtual bool looksForFree() const noexcept { return true; }
};

} // namespace palpate
