// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tick/ProxyStep.h"

namespace palpate
{

/// What pushes a tool that is felt as a ball: the planes that hold it. Real-time safe.
void tellPresses(const ProxyTick& tick, const ContactResult& result, double radius_u, ToolState& tool) noexcept;

} // namespace palpate
