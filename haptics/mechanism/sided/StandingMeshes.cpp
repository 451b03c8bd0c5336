// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/sided/StandingMeshes.h"

namespace palpate
{

std::shared_ptr<const StandingMeshes> makeStandingMeshes(std::shared_ptr<const Scene> surfaces)
{
  std::vector<std::shared_ptr<const SidedSurface>> standing;
  for (std::size_t s = 1; s < surfaces->surfaces().size(); ++s)
  {
    standing.push_back(makeSided(surfaces->surfaces()[s].tree));
  }
  return std::make_shared<const StandingMeshes>(std::move(surfaces), std::move(standing));
}

} // namespace palpate
