// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "devices/arm/link/ByteLink.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

struct LoopbackSocket
{
  std::unique_ptr<ByteLink> link;
  std::string problem;        ///< a phrase, if there is no link
  bool nobodyListens = false; ///< no program has that port
};
/// A WebSocket to a service of this computer: 127.0.0.1 and nothing else. A message longer than 1 MiB closes it.
[[nodiscard]] LoopbackSocket openLoopbackSocket(std::uint16_t port, int timeout_ms);

/// The body of the answer to an HTTP question to this computer, at most 64 KiB; the problem is a phrase.
[[nodiscard]] Outcome<std::string> askLoopback(std::uint16_t port, const std::string& target, int timeout_ms);

} // namespace palpate
