// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// The path of a hand in bounded memory: every point that was added lies within 2 apart_u() of one that is kept.
class WayTrace
{
public:
  static constexpr std::size_t most = 4096; ///< points

  /// Points less than `apart_u` > 0 from the one kept before are left out.
  explicit WayTrace(double apart_u = 1.0) : apart_u_(apart_u) {}

  /// Once there are `most` they are kept twice as far apart, until half of them are gone.
  void add(const Vec3& p_W);

  [[nodiscard]] const std::vector<Vec3>& points_W() const noexcept { return this->points_W_; }
  [[nodiscard]] double apart_u() const noexcept { return this->apart_u_; }

private:
  void keep(const Vec3& p_W);

  double apart_u_;
  std::vector<Vec3> points_W_;
};

} // namespace palpate
