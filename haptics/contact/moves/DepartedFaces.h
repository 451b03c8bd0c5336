// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "haptics/contact/view/GodObjectState.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// Faces that a point has left in this tick and still lies beside. Such a face comes back only when it obstructs, or
/// when the point hits the face again without having moved.
class DepartedFaces
{
public:
  struct Entry
  {
    ActiveFeature face;
    Vec3 leftAt_W;
  };

  void add(const ActiveFeature& face, const Vec3& x_W) noexcept
  {
    if (this->count_ < capacity)
    {
      this->entries_[this->count_++] = { face, x_W };
    }
  }
  void remove(int i) noexcept
  {
    std::copy(this->entries_.begin() + i + 1, this->entries_.begin() + this->count_, this->entries_.begin() + i);
    --this->count_;
  }
  void clear() noexcept { this->count_ = 0; }
  [[nodiscard]] int count() const noexcept { return this->count_; }
  [[nodiscard]] const Entry& operator[](int i) const noexcept { return this->entries_[i]; }

private:
  static constexpr int capacity = 16; ///< a face that finds no room is hit once more, like any other
  std::array<Entry, capacity> entries_;
  int count_ = 0;
};

} // namespace palpate
