// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <LinearMath/btVector3.h>

#include "haptics/core/Types.h"

namespace palpate::lab
{

[[nodiscard]] inline btVector3 toBullet(const Vec3& v)
{
  return { static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z()) };
}

} // namespace palpate::lab
