// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate
{

/// What a surface is made of. The defaults are a bare frictionless wall as stiff as the coupling.
struct Material
{
  double stiffnessFactor = 1.0; ///< of the coupling's stiffness, 0..1
};

} // namespace palpate
