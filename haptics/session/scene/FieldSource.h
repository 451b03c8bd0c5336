// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "haptics/field/FieldBlock.h"
#include "haptics/field/LevelBounds.h"

namespace palpate
{

/// Which block is asked for.
struct FieldBlockWish
{
  Vec3 centre_W = Vec3::Zero();  ///< around this place [u]
  double reach_u = 0.0;          ///< as far as that, or as far as the memory of a block allows
  std::uint64_t revision = 0;    ///< its number
  std::optional<double> level{}; ///< isovalue in use: reference for its noise
  bool smoothLevels = false;     ///< smooth levels are felt: how steep the scalar is in all of the data is asked too
};

/// Effect of the noise of a scalar.
struct FieldSmoothness
{
  int passes = 0;                ///< of smoothing that it had
  double noise = 0.0;            ///< that it would have without, as far as it was measured [spacings of the grid]
  std::optional<double> level{}; ///< that it was measured beside; none: not asked for
  double until = std::numeric_limits<double>::infinity(); ///< from there on it is to be measured anew [values]
};

/// A block as a source made it.
struct MadeFieldBlock
{
  std::shared_ptr<const FieldBlock> brick; ///< null: there is nothing to feel there
  Vec3 centre_W = Vec3::Zero();            ///< that it was made around [u]
  double reach_u =
    0.0; ///< how far the hand may go from there along each axis before the block ends; infinite: it holds all
  std::string problem; ///< why there is none
  FieldSmoothness smoothness{};
  double error = 0.0; ///< largest difference to the data's own cells that was found, of the range of the values; 0: the
                      ///< points are the data's
  double finerReach_u =
    std::numeric_limits<double>::infinity(); ///< allowed motion of the hand before the finer block around it has to be
                                             ///< looked at anew; infinite: never
  std::string
    whyNoCells{}; ///< why surfaces are not felt in the data's own cells; "": they are, or the points tell the same
  LevelBounds levels = unknownLevels; ///< of the scalar in all of the data, where they were asked for
};

/// Data that is felt as a field, wherever the hand goes. Asked by one thread at a time.
class FieldSource
{
public:
  FieldSource() = default;
  FieldSource(const FieldSource&) = delete;
  FieldSource& operator=(const FieldSource&) = delete;
  virtual ~FieldSource() = default;

  [[nodiscard]] virtual MadeFieldBlock brickAround(const FieldBlockWish& wish) const = 0;
  /// Whether any thread may ask, so that a worker does. Else the thread that follows the field asks, and waits.
  [[nodiscard]] virtual bool answersAnyThread() const { return true; }
};

} // namespace palpate
