// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace palpate
{

/// Called now and then with the completed share of some work, 0..1; returns whether to continue.
using Goes = std::function<bool(double share)>;

inline bool always(double /*share*/)
{
  return true;
}

/// A part of some work, from one share of it to another: its own shares are 0..1. Keeps a reference to goes.
[[nodiscard]] inline Goes partOf(const Goes& goes, double from, double to)
{
  return [&goes, from, to](double share) { return goes(from + (to - from) * share); };
}

/// Asks after every so many steps of such work only, so that steps may be small.
class Steps
{
public:
  explicit Steps(const Goes& goes, std::size_t every = 1 << 13) : goes_(goes), every_(every) {}

  /// Once no, always no.
  [[nodiscard]] bool go(std::size_t done, std::size_t of)
  {
    if (this->going_ && ++this->steps_ % this->every_ == 0)
    {
      this->going_ = this->goes_(static_cast<double>(done) / static_cast<double>(of));
    }
    return this->going_;
  }

private:
  const Goes& goes_;
  std::size_t every_;
  std::size_t steps_ = 0;
  bool going_ = true;
};

} // namespace palpate
