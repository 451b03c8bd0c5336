// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "haptics/field/Brick.h"

namespace palpate
{

/// A brick as a source made it.
struct MadeBrick
{
  std::shared_ptr<const Brick> brick; ///< null: there is nothing to feel there
  Vec3 centre_W = Vec3::Zero();       ///< that it was made around [u]
  double reach_u =
    0.0; ///< how far the hand may go from there along each axis before the brick ends; infinite: it holds all
  std::string problem; ///< why there is none
};

/// Data that is felt as a field, wherever the hand goes. Asked by a worker thread, by one at a time.
class FieldSource
{
public:
  FieldSource() = default;
  FieldSource(const FieldSource&) = delete;
  FieldSource& operator=(const FieldSource&) = delete;
  virtual ~FieldSource() = default;

  /// The brick around a place that reaches as far as asked [u], or as far as the memory of a brick allows.
  [[nodiscard]] virtual MadeBrick brickAround(const Vec3& centre_W, double reach_u, std::uint64_t revision) const = 0;
};

} // namespace palpate
