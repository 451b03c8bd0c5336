// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace palpate
{

/// Memory of an explorer of an unknown maze by Tremaux's rules (Lucas, Recreations mathematiques,
/// 1882): a passage is marked each time it is walked, one marked twice is never walked again, and a place known from
/// before is left by the passage of arrival. Places lie on a square grid, so that its position identifies a place.
class PlaceMemory
{
public:
  using Place = std::pair<int, int>;

  /// 0 east, 1 north, 2 west, 3 south.
  static constexpr int ways = 4;
  [[nodiscard]] static constexpr int opposite(int way) noexcept { return (way + 2) % ways; }
  [[nodiscard]] static Place beside(const Place& place, int way) noexcept;

  explicit PlaceMemory(const Place& start = {}) : here_(start) { this->marks_[start] = {}; }

  [[nodiscard]] const Place& here() const noexcept { return this->here_; }
  [[nodiscard]] bool knows(const Place& place) const { return this->marks_.contains(place); }
  [[nodiscard]] std::size_t places() const noexcept { return this->marks_.size(); }

  /// The direction to try next from here: a new one, straight on first, then left, right, back; else one marked once.
  /// Nothing when every direction is done: all places that could be reached have been seen.
  [[nodiscard]] std::optional<int> next() const;
  /// The passage in that direction was walked to its end.
  void walked(int way);
  /// The passage in that direction is closed by a wall.
  void closed(int way) { this->marks_[this->here_][static_cast<std::size_t>(way)] = wall; }

private:
  static constexpr std::int8_t wall = 3;
  using Marks = std::array<std::int8_t, ways>;

  Place here_;
  int heading_ = 0;
  std::map<Place, Marks> marks_;
};

} // namespace palpate
