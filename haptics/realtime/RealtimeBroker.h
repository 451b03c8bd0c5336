// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace palpate
{

/// One request that may be refused: whether it was granted, and a sentence for a person.
struct Granted
{
  bool ok = false;
  std::string message;
};

/// Somebody outside the program who may give a thread real-time priority where the user's own limits do not. Asked by
/// the thread itself, once, before it does anything that must be in time.
class RealtimeBroker
{
public:
  virtual ~RealtimeBroker() = default;

  /// As a person knows it.
  [[nodiscard]] virtual std::string name() const = 0;
  /// For the calling thread, with that priority at most. Returns within a second or so. Not real-time safe.
  [[nodiscard]] virtual Granted request(int wantedPriority) = 0;
};

} // namespace palpate
