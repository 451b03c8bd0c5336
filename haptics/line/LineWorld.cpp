// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/line/LineWorld.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

constexpr double longest_m = 1e6; // multiples of a detent must fit into an integer

bool isUsable(const LinePlace& place)
{
  return std::fabs(place.s_m) <= longest_m && std::isfinite(place.potential_J) && std::isfinite(place.friction_N) &&
         place.friction_N >= 0.0;
}

/// The number of the place that ends the piece in which s lies, 1 and up.
std::size_t pieceAt(const LineWorld& world, double s_m) noexcept
{
  const auto after = std::upper_bound(
    world.places.begin(), world.places.end(), s_m, [](double s, const LinePlace& place) { return s < place.s_m; });
  const auto at = static_cast<std::size_t>(after - world.places.begin());
  return std::clamp<std::size_t>(at, 1, world.places.size() - 1);
}

double detentStiffness(const LineWorld& world) noexcept
{
  return world.detentEvery_m > 0.0 ? 2.0 * world.detent_N / world.detentEvery_m : 0.0;
}

double nearestDetent(double every_m, double s_m) noexcept
{
  const double half = s_m < 0.0 ? -0.5 : 0.5;
  return every_m * static_cast<double>(static_cast<long long>(s_m / every_m + half));
}

std::string number(double value)
{
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

} // namespace

double LineWorld::stiffest_N_per_m() const noexcept
{
  return std::max(this->stop_N_per_m, detentStiffness(*this));
}

std::string LineWorld::refusal(double largest_N_per_m) const
{
  if (this->places.size() < 2)
  {
    return "a line needs at least two positions";
  }
  for (std::size_t i = 0; i < this->places.size(); ++i)
  {
    if (!isUsable(this->places[i]))
    {
      return "place " + std::to_string(i + 1) +
             " has an invalid number: values must be finite, friction must not be negative";
    }
    if (i > 0 && !(this->places[i].s_m > this->places[i - 1].s_m))
    {
      return "place " + std::to_string(i + 1) + " does not lie beyond the previous one";
    }
  }
  const double length_m = this->places.back().s_m - this->places.front().s_m;
  const bool detents = this->detentEvery_m >= 0.0 && this->detentEvery_m <= length_m && this->detent_N >= 0.0 &&
                       (this->detentEvery_m == 0.0 || this->detentEvery_m > 1e-9 * longest_m);
  if (!detents || !std::isfinite(this->detent_N) || !(this->stop_N_per_m > 0.0))
  {
    return "detents must lie on the line with forces of 0 or more, and stops must have a stiffness above 0";
  }
  if (this->stiffest_N_per_m() > largest_N_per_m)
  {
    return "the stiffest spring has " + number(this->stiffest_N_per_m()) + " N/m, and " + number(largest_N_per_m) +
           " can be rendered stably: make detents weaker or wider, or stops softer";
  }
  return {};
}

double lineForce(const LineWorld& world, double s_m) noexcept
{
  const LinePlace &first = world.places.front(), &last = world.places.back();
  if (s_m < first.s_m || s_m > last.s_m)
  {
    return world.stop_N_per_m * ((s_m < first.s_m ? first.s_m : last.s_m) - s_m);
  }
  const std::size_t piece = pieceAt(world, s_m);
  const LinePlace &a = world.places[piece - 1], &b = world.places[piece];
  const double downhill_N = (a.potential_J - b.potential_J) / (b.s_m - a.s_m);
  const double detents_N_per_m = detentStiffness(world);
  return detents_N_per_m > 0.0 ? downhill_N - detents_N_per_m * (s_m - nearestDetent(world.detentEvery_m, s_m))
                               : downhill_N;
}

double lineFriction(const LineWorld& world, double s_m, double& anchor_m) noexcept
{
  const std::size_t piece = pieceAt(world, s_m);
  const LinePlace &a = world.places[piece - 1], &b = world.places[piece];
  const double share = std::clamp((s_m - a.s_m) / (b.s_m - a.s_m), 0.0, 1.0);
  const double most_N = a.friction_N + share * (b.friction_N - a.friction_N);
  const double force_N = std::clamp(world.stop_N_per_m * (anchor_m - s_m), -most_N, most_N);
  anchor_m = s_m + force_N / world.stop_N_per_m;
  return force_N;
}

} // namespace palpate
