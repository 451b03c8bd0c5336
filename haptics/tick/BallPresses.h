// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tick/ProxyStep.h"

namespace palpate
{

/// Contacts of a tool that is rendered as a ball: its active planes, at their positions. Soft surfaces are as they are
/// bent. `state`: after the move that found `result`. Real-time safe.
void tellPresses(
  const ProxyTick& tick, const ContactResult& result, const RendererState& state, ToolState& tool) noexcept;

} // namespace palpate
