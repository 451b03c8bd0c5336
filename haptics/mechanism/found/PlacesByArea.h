// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/mechanism/found/ContactFinder.h"

namespace palpate
{

/// Radius of the paraboloid of pressure on a half space whose mean depth is that of a square with an even pressure, of
/// the square's side (Love 1929: .946 F / (E* s); Hertz: .6587 F / (E* a)).
inline constexpr double tipOfSquare = 0.6587 / 0.946;
/// The same of places that are so far apart.
inline constexpr double tipOfPlace = sideOfPlace * tipOfSquare;

struct PlacesByArea
{
  ChosenPlaces chosen;
  std::vector<std::vector<const NearPlace*>> parts; ///< of the first places: the places of the part of each
};

/// Of places that touch at most so many, each in the middle of an equal part of the area that touches (Lloyd 1982), and
/// of others those that are nearest, as choosePlaces(). Contacts with an even pressure over their parts have the
/// compliance of an even pressure over the whole; the deepest places alone leave gaps and lie at the rim. Parts begin
/// around the places that were chosen before, and are no narrower than `least_u`. `ChosenPlaces::apart_u`: least
/// distance between places that leave each a square as large as a part.
[[nodiscard]] PlacesByArea choosePlacesByArea(
  const std::vector<NearPlace>& near, PlaceRoom room, double least_u, double touches_u, const FoundContacts& before);

} // namespace palpate
