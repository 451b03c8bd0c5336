// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/core/Types.h"

namespace palpate
{

/// A place that the ball comes from when a scene is taken: a surface that has come between that place and the ball
/// stops it there, so a ball outside stays outside.
struct BallLead
{
  std::uint64_t number = 0;   ///< each is followed once; 0: none
  std::uint64_t geometry = 0; ///< hash of the scene that it is for
  Vec3 from_W = Vec3::Zero(); ///< free in that scene [u]
};

} // namespace palpate
