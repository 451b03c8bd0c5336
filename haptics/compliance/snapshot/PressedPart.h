// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace palpate
{

/// A part of the surface of a soft body that a contact presses with an even pressure, in place of the patch of a
/// vertex.
struct PressedPart
{
  std::uint32_t at = 0; ///< forces on this vertex act on the part, whose mean displacement is the vertex's
  std::vector<std::uint32_t> vertices; ///< of the part
  std::vector<double> shares;          ///< of the force on each, above 0, which add up to 1
};

} // namespace palpate
