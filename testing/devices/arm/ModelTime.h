// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "haptics/core/Clock.h"

namespace palpate::test
{

/// A clock that goes on only when it is told to.
class ModelTime final : public Clock
{
public:
  [[nodiscard]] std::int64_t now_ns() const noexcept override { return this->now_ns_; }
  void pass(std::int64_t duration_ns) noexcept { this->now_ns_ += duration_ns; }

private:
  std::atomic<std::int64_t> now_ns_ = 1000000000;
};

} // namespace palpate::test
