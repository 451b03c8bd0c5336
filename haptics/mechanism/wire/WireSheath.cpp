// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/wire/WireSheath.h"

#include <algorithm>

namespace palpate
{
namespace
{

/// Bits of WireLoads::held across x.
constexpr std::uint8_t acrossX = 0b110110;
/// From that share of a beam behind the mouth on a node is held for good.
constexpr double deep = 0.9999;

/// Of beams behind the mouth.
double behind(const Wire& wire, const WirePlaces& places_M, int node) noexcept
{
  return -places_M[node].p.x() / wire.beams[std::max(node - 1, 0)].length_u;
}

void bringOntoAxis(Pose& pose) noexcept
{
  pose.p.y() = pose.p.z() = 0.0;
  pose.q.y() = pose.q.z() = 0.0;
  pose.q.normalize();
}

/// The springs are those by which the beam behind it holds a node, times a share that falls from infinity to 0.
void holdFading(const WireBeam& beam, double share, const Pose& pose, NodeVector& force, NodeVector& falls) noexcept
{
  const double odds = share / (1.0 - share);
  const double turn_Nu_per_rad = odds * beam.section.bend_Nu2 / beam.length_u;
  const double place_N_per_u = 3.0 * turn_Nu_per_rad / (beam.length_u * beam.length_u);
  force << 0.0, -place_N_per_u * pose.p.y(), -place_N_per_u * pose.p.z(),
    turn_Nu_per_rad * (pose.q * Vec3::UnitX()).cross(Vec3::UnitX());
  falls << 0.0, place_N_per_u, place_N_per_u, 0.0, turn_Nu_per_rad, turn_Nu_per_rad;
}

} // namespace

void holdInSheath(const Wire& wire, WirePlaces& places_M, WireLoads& loads) noexcept
{
  bool sheathed = true;
  for (int i = 0; i < wire.nodes(); ++i)
  {
    loads.held[i] = 0;
    loads.falls[i].setZero();
    loads.force[i].setZero();
    const double share = behind(wire, places_M, i);
    sheathed = sheathed && share > 0.0; // a node that came back beside the sheath is not in it
    if (sheathed && (i == 0 || share >= deep))
    {
      loads.held[i] = acrossX;
      bringOntoAxis(places_M[i]);
    }
    else if (sheathed)
    {
      holdFading(wire.beams[i - 1], share, places_M[i], loads.force[i], loads.falls[i]);
    }
  }
}

} // namespace palpate
