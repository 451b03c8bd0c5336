// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/found/MeshRoundness.h"

#include <algorithm>
#include <cmath>

#include "haptics/core/PoseMath.h"

namespace palpate
{

Roundness roundness(const std::vector<NearPlace>& near, const Pose& mesh_W, double within_u)
{
  const NearPlace& first = *std::ranges::min_element(near, {}, &NearPlace::free_u);
  const FoundContact& nearest = first.contact;
  const auto heightOf = [&](const NearPlace& place)
  { return nearest.normal_B.dot(mesh_W * place.contact.point_A - place.without_W); };
  const double least_u = heightOf(first);
  double rise = 0.0, square = 0.0;
  Roundness round;
  for (const NearPlace& place : near)
  {
    const Vec3 way_W = mesh_W.q * (place.contact.point_A - nearest.point_A);
    const double away_u = (way_W - nearest.normal_B.dot(way_W) * nearest.normal_B).norm();
    if (away_u <= within_u && place.contact.normal_B.dot(nearest.normal_B) > FoundContact::alike)
    {
      const double above_u = heightOf(place) - least_u;
      const double chord2_u2 = away_u * away_u + above_u * above_u;
      rise += chord2_u2 * above_u;
      square += chord2_u2 * chord2_u2;
      round.seen_u = std::max(round.seen_u, away_u);
    }
  }
  round.radius_u = rise > 0.0 ? 0.5 * square / rise : round.radius_u;
  return round;
}

std::optional<double> ballContact(const Roundness& round, const BallHistory& history, double stiffness_N_per_u2)
{
  if (!std::isfinite(round.radius_u))
  {
    return std::nullopt;
  }
  const double now_u = std::sqrt(round.radius_u * std::max(history.deep_u, 0.0));
  const double ahead_u = std::sqrt(round.radius_u * std::max(history.ahead_u, 0.0));
  const double byForce_u = std::cbrt(0.75 * history.force_N * round.radius_u / stiffness_N_per_u2);
  const double share = history.force_N > 0.0 && now_u > 0.0 ? std::min(byForce_u / now_u, std::sqrt(2.0)) : 1.0;
  const double contact_u = share * ahead_u;
  return std::max(contact_u, byForce_u) <= round.seen_u ? std::optional(contact_u) : std::nullopt;
}

} // namespace palpate
