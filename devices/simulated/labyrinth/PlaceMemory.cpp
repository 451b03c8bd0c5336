// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/labyrinth/PlaceMemory.h"

namespace palpate
{

PlaceMemory::Place PlaceMemory::beside(const Place& place, int way) noexcept
{
  constexpr std::array<int, ways> dx{ 1, 0, -1, 0 }, dy{ 0, 1, 0, -1 };
  const auto i = static_cast<std::size_t>(way);
  return { place.first + dx[i], place.second + dy[i] };
}

std::optional<int> PlaceMemory::next() const
{
  const Marks& marks = this->marks_.at(this->here_);
  for (const int turn : { 0, 1, 3, 2 })
  {
    const int way = (this->heading_ + turn) % ways;
    // An unmarked passage to a known place would be left again at once: memory saves the walk.
    if (marks[static_cast<std::size_t>(way)] == 0 && !this->knows(beside(this->here_, way)))
    {
      return way;
    }
  }
  for (int way = 0; way < ways; ++way)
  {
    if (marks[static_cast<std::size_t>(way)] == 1)
    {
      return way;
    }
  }
  return std::nullopt;
}

void PlaceMemory::walked(int way)
{
  ++this->marks_[this->here_][static_cast<std::size_t>(way)];
  this->here_ = beside(this->here_, way);
  ++this->marks_[this->here_][static_cast<std::size_t>(opposite(way))];
  this->heading_ = way;
}

} // namespace palpate
