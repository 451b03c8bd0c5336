// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tick/ProxyStep.h"

namespace palpate
{

/// What pushes a tool that is felt as a ball: the planes that hold it, where they are felt. Surfaces that give way are
/// where they have gone to. `state`: after the move that found `result`. Real-time safe.
void tellPresses(
  const ProxyTick& tick, const ContactResult& result, const RendererState& state, ToolState& tool) noexcept;

} // namespace palpate
