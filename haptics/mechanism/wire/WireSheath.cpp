// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/wire/WireSheath.h"

#include <algorithm>

namespace palpate
{
namespace
{

/// Bits of WireLoads::held across x.
constexpr std::uint8_t acrossX = 0b110110, placeAcrossX = 0b000110;
/// From that share of a beam behind the mouth on a node is held for good.
constexpr double deep = 0.9999;
/// Of a beam's stiffness across itself: so stiff the mouth is.
constexpr double firmly = 1e4;

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

/// The first node that is not in the sheath: one that came back beside it is not either.
int firstOut(const Wire& wire, const WirePlaces& places_M) noexcept
{
  int node = 0;
  while (node < wire.nodes() && places_M[node].p.x() <= 0.0)
  {
    ++node;
  }
  return node;
}

/// The mouth holds the beam that leaves it.
WireRing ringAt(const WireBeam& beam, int index, const WirePlaces& places_M) noexcept
{
  const double a_u = places_M[index].p.x(), b_u = places_M[index + 1].p.x();
  const double across_N_per_u = 12.0 * beam.section.bend_Nu2 / (beam.length_u * beam.length_u * beam.length_u);
  return { index, -a_u / (b_u - a_u), firmly * across_N_per_u };
}

} // namespace

void holdInSheath(const Wire& wire, WirePlaces& places_M, WireLoads& loads) noexcept
{
  const int out = firstOut(wire, places_M);
  for (int i = 0; i < wire.nodes(); ++i)
  {
    loads.held[i] = 0;
    loads.falls[i].setZero();
    loads.force[i].setZero();
    const double share = i < out ? behind(wire, places_M, i) : 0.0;
    if (i < out && (i == 0 || i < out - 1 || share >= deep))
    {
      loads.held[i] = acrossX;
      bringOntoAxis(places_M[i]);
    }
    else if (i < out)
    {
      holdFading(wire.beams[i - 1], share, places_M[i], loads.force[i], loads.falls[i]);
    }
  }
  loads.ring = {};
  if (out < wire.nodes() && out > 0)
  {
    loads.ring = ringAt(wire.beams[out - 1], out - 1, places_M);
  }
  else if (out == wire.nodes() && loads.held[wire.count] == 0)
  {
    loads.held[wire.count] = placeAcrossX;
    places_M[wire.count].p.tail<2>().setZero();
  }
}

} // namespace palpate
