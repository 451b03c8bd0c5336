// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>

namespace palpate
{

/// How far the making of a scene is, and whether it is wanted still: threads that make it tell and ask, another thread
/// asks and tells. Work is counted in triangles of steps, which take about as long as they have triangles.
class BuildWatch
{
public:
  /// Adds work to the expected amount.
  void expect(std::size_t triangles) noexcept { this->expected_ += triangles; }
  /// So much of it is done.
  void advance(std::size_t triangles) noexcept { this->done_ += triangles; }
  /// Completed share of the expected work, 0 to 1; 1 without work.
  [[nodiscard]] double share() const noexcept
  {
    const std::size_t done = this->done_; // first: completed work was expected before
    const std::size_t expected = this->expected_;
    return expected == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(expected);
  }

  /// Ends the work before its next step, without a result.
  void cancel() noexcept { this->cancelled_ = true; }
  [[nodiscard]] bool cancelled() const noexcept { return this->cancelled_; }

private:
  std::atomic<std::size_t> expected_ = 0, done_ = 0;
  std::atomic<bool> cancelled_ = false;
};

} // namespace palpate
