// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/compliance/wire/WireCompliance.h"
#include "haptics/compliance/wire/WireShape.h"
#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// A wire in a sheath, as described by a person.
struct WireDescription
{
  WireShape shape;
  double diameter_u = 0.0;
  double young_N_per_u2 = 0.0;
  double tipYoung_N_per_u2 = 0.0; ///< of the shape's tip length; 0: as the shaft
  double poisson = 0.3;
  double friction = 0.0;            ///< Coulomb's, along the wire and around it
  Vec3 mouth_W = Vec3::Zero();      ///< of the sheath
  Vec3 direction_W = Vec3::UnitX(); ///< out of the sheath; of any length
  [[nodiscard]] double beam_u() const noexcept { return this->shape.length_u / this->shape.beams; }

  friend bool operator==(const WireDescription&, const WireDescription&) = default;
};

/// The wire as the tick knows it. Immutable. M is the frame of the sheath's mouth: its origin there, its x axis out of
/// the sheath.
struct WirePlan
{
  std::uint64_t revision = 0; ///< another one for each plan; above 0
  Wire wire;
  double radius_u = 0.0;
  double friction = 0.0;
  Pose mouth_W;                              ///< of M
  std::shared_ptr<const SurfaceTree> vessel; ///< in M, at rest
  double mouthAway_u = 0.0;                  ///< of the wall from the mouth

  [[nodiscard]] double length_u() const noexcept;
};

/// The answer of a check of a wire.
struct WireCheck
{
  std::vector<std::string> faults;  ///< sentences: the wire cannot be felt
  std::vector<std::string> remarks; ///< sentences
  int beams = 0;
  int contacts = 0;         ///< the most that a tick solves
  double clearance_u = 0.0; ///< between the wire's skin and the wall at the mouth
  double tightest_u = 0.0;  ///< the tightest bend that the beams follow: three beams
  std::uint32_t work = 0;   ///< of a Newton step without its contacts, in the unit of ContactPlan::workBudget
};

/// A plan, or none with the faults of the check.
struct PlannedWire
{
  std::shared_ptr<const WirePlan> plan;
  WireCheck check;
  std::shared_ptr<const TriangleMesh> vessel_W; ///< as it was given, for a person to see; null: planWire() keeps none
};
/// Not real-time safe.
[[nodiscard]] PlannedWire planWire(
  const WireDescription& description, const TriangleMesh& vessel_W, std::uint64_t revision);

/// The wire all in its sheath, straight, its tip at the mouth.
[[nodiscard]] WirePlaces placesInSheath(const WirePlan& plan) noexcept;

/// Multiply-adds to the unit of ContactPlan::workBudget.
[[nodiscard]] constexpr std::uint32_t wireWork(int multiplyAdds) noexcept
{
  constexpr int multiplyAddsPerWork = 27;
  return 1 + static_cast<std::uint32_t>(multiplyAdds / multiplyAddsPerWork);
}

/// Of linearising a wire with so many factors: blocks of 6 x 6.
[[nodiscard]] constexpr std::uint32_t newtonWork(int nodes, int factors) noexcept
{
  constexpr int block = 216;
  constexpr int factor = 4 * block, inverse = 3 * block, beam = 6 * block;
  return wireWork(nodes * (factors * factor + inverse + beam));
}

/// Of the compliance between so many contacts and the motion under their forces, without the forces' own solution.
[[nodiscard]] constexpr std::uint32_t touchWork(int contacts) noexcept
{
  constexpr int between = 3 * 216;
  return wireWork(contacts * (contacts + 1) / 2 * between);
}

/// Of distances of so many triangles from a beam or a node, and of so many questions to the tree, which bound some four
/// hundred triangles each.
[[nodiscard]] constexpr std::uint32_t searchWork(int looked, int queries) noexcept
{
  constexpr int look = 54, query = 400 * 20;
  return wireWork(look * looked + query * queries);
}

} // namespace palpate
