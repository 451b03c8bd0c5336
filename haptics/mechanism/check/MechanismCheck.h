// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/mechanism/MechanismPlan.h"
#include "haptics/mechanism/wire/WirePlan.h"

namespace palpate
{

/// A soft body that a mechanism may name, as its worker had it at rest.
struct MechanismSoft
{
  std::string name;
  const PressedBody* body = nullptr;
};

/// Properties of a mechanism, and its faults.
struct MechanismCheck
{
  std::vector<std::string> faults;    ///< a sentence each, with the name of constraint or body; none: it can be felt
  std::vector<std::string> remarks;   ///< redundant constraints, free rotations, bad conditioning
  std::vector<std::string> redundant; ///< names of constraints of which a row follows from others
  std::vector<std::string> free;      ///< names of bodies that can move where no constraint holds them
  std::vector<std::pair<std::string, std::string>> overlaps;     ///< bodies that overlap as they stand, by name
  std::vector<std::pair<std::string, std::string>> heldOverlaps; ///< likewise of the held body, at the origin
  int rows = 0;                                                  ///< that may hold at once
  int rank = 0;                                                  ///< of those, how many are independent
  int freeTurns = 0;      ///< degrees of freedom of rigid bodies, and of a held one that the device does not turn, that
                          ///< only the balance of forces and moments decides
  double condition = 1.0; ///< of the compliance of the independent rows
  std::optional<WireCheck> wire; ///< of a mechanism that is a wire, whose contacts are its only rows
};

/// Reads a mechanism: faults in words, or the plan of a mechanism without faults. `soft`: the soft bodies there are, at
/// rest; `grip`: of the device. Not real-time safe.
[[nodiscard]] MechanismCheck checkMechanism(
  const Mechanism& mechanism, std::span<const MechanismSoft> soft, const MechanismGrip& grip);

/// So far a loose body goes from where it began, then it sleeps for good: ten times the diagonal of the rigid bodies
/// and meshes [u]; infinite without a loose body.
[[nodiscard]] double farthestLoose_u(const Mechanism& mechanism);

/// The plan of a mechanism in which checkMechanism() finds no fault, and the same `soft`: the tick is given the bodies
/// in this order. `revision`: above 0. Not real-time safe.
[[nodiscard]] MechanismPlan planMechanism(
  const Mechanism& mechanism, std::span<const MechanismSoft> soft, std::uint64_t revision);

} // namespace palpate
