// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/common/Condition.h"
#include "haptics/core/DeviceCommand.h"

namespace palpate
{

/// A spring that has a centre and a coefficient and nothing else, as the joysticks of the nineties have them: without
/// dead band, second coefficient or saturation it pulls as well as it pushes.
[[nodiscard]] Condition bareSpring(double centre, double coefficient) noexcept;

/// Makes a command one for a device that holds its walls with bare springs: a wall that the handle at p_D [m] is not
/// behind is left out. A wall that stays pushes with its `largest_N` there at most, for nothing else limits that wall.
/// To be called with each update of the host, T apart, about a handle at speed v. On the way in the force begins with a
/// step of K v T at most, which spares the hand that much work; on the way out the spring pulls back for as long, which
/// takes it again: K (v T)^2 / 6 either way in the mean, K (v T)^2 / 2 at most. Real-time safe.
void switchSprings(const Vec3& p_D, DeviceCommand& command) noexcept;

} // namespace palpate
