// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/ArmPlan.h"

#include <cmath>

namespace palpate
{
namespace
{

/// The refusals of a geometry, by its kind.
struct Refusal
{
  static std::string lengths(std::initializer_list<std::pair<const char*, double>> all)
  {
    for (const auto& [name, length_m] : all)
    {
      if (!(length_m > 0.0 && std::isfinite(length_m)))
      {
        return std::string("the length \"") + name + "\" must be above 0 and finite";
      }
    }
    return {};
  }

  /// `before`: joints before the first hinge.
  static std::string hinges(const SerialGeometry& chain, int before)
  {
    for (int k = 0; k < chain.count; ++k)
    {
      const SerialGeometry::Hinge& hinge = chain.hinges[static_cast<std::size_t>(k)];
      if (!(std::fabs(hinge.axis.norm() - 1.0) < 1e-9))
      {
        return "the axis of joint " + std::to_string(before + k + 1) + " must have a direction";
      }
      if (!hinge.origin.p.allFinite() || !(std::fabs(hinge.origin.q.norm() - 1.0) < 1e-9))
      {
        return "the place of joint " + std::to_string(before + k + 1) + " is not a finite pose";
      }
    }
    return chain.tip.p.allFinite() ? "" : "the place of the tip is not finite";
  }

  std::string operator()(const SerialGeometry& chain) const
  {
    return chain.count < 1 || chain.count > mostJoints ? "a chain needs 1 to 6 joints" : hinges(chain, 0);
  }
  std::string operator()(const WoodenGeometry& arm) const
  {
    return lengths({ { "column", arm.column_m }, { "upper", arm.upper_m }, { "fore", arm.fore_m } });
  }
  std::string operator()(const DeltaGeometry& arm) const
  {
    std::string problem = lengths(
      { { "base", arm.base_m }, { "platform", arm.platform_m }, { "arm", arm.arm_m }, { "forearm", arm.forearm_m } });
    using Azimuth = DeltaGeometry::Azimuth;
    const auto& [a, b, c] = arm.legs;
    // The chord between two directions is twice the sine of half their angle.
    const auto apart = [](const Azimuth& one, const Azimuth& other)
    { return std::hypot(one.cosine - other.cosine, one.sine - other.sine) > 2e-3; };
    return !problem.empty() ? problem
           : !(arm.hinge_m >= 0.0 && std::isfinite(arm.hinge_m + arm.offset_m))
             ? "the length \"hinge\" must not be below 0"
           : !(apart(a, b) && apart(b, c) && apart(c, a)) ? "two legs have the same azimuth"
                                                          : "";
  }
  std::string operator()(const FiveBarGeometry& arm) const
  {
    return lengths({ { "base", arm.base_m }, { "arm", arm.arm_m }, { "forearm", arm.forearm_m } });
  }
};

std::string refuseWrist(const ArmPlan& plan)
{
  const int count = plan.wrist.count;
  return count == 0                                              ? ""
         : std::holds_alternative<SerialGeometry>(plan.geometry) ? "a chain has no wrist: its joints go on to the tip"
         : count < 0 || count > mostWristHinges                  ? "a wrist has 1 to 3 hinges"
                                                : Refusal::hinges(plan.wrist, jointCountOf(plan.geometry));
}

std::string refuseJoint(const ArmJoint& joint)
{
  const auto isSize = [](double value) { return value >= 0.0 && std::isfinite(value); };
  if (!(joint.low_rad < joint.high_rad))
  {
    return "its limits exclude each other: the lower one must be below the higher one";
  }
  if (joint.gear == 0.0 || !std::isfinite(joint.gear))
  {
    return "its gear must be a finite number other than 0";
  }
  if (!std::isfinite(joint.zero_rad) || !std::isfinite(joint.followShare))
  {
    return "its angle at count 0 is not finite";
  }
  if (!isSize(joint.countsPerTurn) || !isSize(joint.rotor_kg_m2) || !isSize(joint.damping_Nms) ||
      !isSize(joint.friction_Nm) || !isSize(joint.torqueStep_Nm) || !isSize(joint.torqueConstant_Nm_per_A) ||
      !(joint.maxTorque_Nm >= 0.0))
  {
    return "its counts a turn, torques, rotor, damping and friction must not be below 0";
  }
  return {};
}

std::string refuseJoints(const ArmPlan& plan)
{
  const int ofBase = jointCountOf(plan.geometry), count = ofBase + plan.wrist.count;
  for (int k = 0; k < count; ++k)
  {
    const ArmJoint& joint = plan.joints[static_cast<std::size_t>(k)];
    std::string problem = refuseJoint(joint);
    problem = !problem.empty() ? problem
              : k > 0 && joint.hasMotor && !plan.joints[static_cast<std::size_t>(k - 1)].hasMotor
                ? "joints with motors come before those without"
              : joint.follows >= k ? "a joint can only follow one before it"
                                   : "";
    if (!problem.empty())
    {
      return "joint " + std::to_string(k + 1) + ": " + problem;
    }
  }
  const bool isChain = std::holds_alternative<SerialGeometry>(plan.geometry);
  return !plan.joints[0].hasMotor ? "no joint has a motor"
         : !isChain && !plan.joints[static_cast<std::size_t>(ofBase - 1)].hasMotor
           ? "every joint of this kind needs a motor, but those of its wrist"
           : "";
}

std::string refuseMasses(const ArmPlan& plan)
{
  for (const ArmMass& mass : plan.masses)
  {
    if (!(mass.mass_kg >= 0.0 && std::isfinite(mass.mass_kg)) || !mass.from.allFinite() || !mass.to.allFinite())
    {
      return "a mass must not be below 0, and it must stand at a finite place";
    }
    const int links = linkCountOf(plan.geometry) + plan.wrist.count;
    if (mass.link < 1 || mass.link > links)
    {
      return "a mass is on link " + std::to_string(mass.link) + ", and this arm has links 1 to " +
             std::to_string(links);
    }
  }
  return {};
}

} // namespace

const char* nameOf(const ArmGeometry& geometry) noexcept
{
  constexpr std::array<const char*, 4> names{ "serial", "woodenhaptics", "delta", "five-bar" };
  return names[geometry.index()];
}

int jointCountOf(const ArmGeometry& geometry) noexcept
{
  const auto* const chain = std::get_if<SerialGeometry>(&geometry);
  return chain != nullptr ? chain->count : std::holds_alternative<FiveBarGeometry>(geometry) ? 2 : 3;
}

int linkCountOf(const ArmGeometry& geometry) noexcept
{
  const auto* const chain = std::get_if<SerialGeometry>(&geometry);
  constexpr std::array<int, 4> links{ 0, 2, 7, 4 };
  return chain != nullptr ? chain->count : links[geometry.index()];
}

const char* classOf(const ArmPlan& plan) noexcept
{
  const bool isParallel =
    std::holds_alternative<DeltaGeometry>(plan.geometry) || std::holds_alternative<FiveBarGeometry>(plan.geometry);
  return !isParallel ? "serial" : plan.wrist.count > 0 ? "hybrid" : "parallel";
}

bool isPlanar(const ArmGeometry& geometry) noexcept
{
  const auto* const chain = std::get_if<SerialGeometry>(&geometry);
  return chain != nullptr ? chain->count <= 2 : std::holds_alternative<FiveBarGeometry>(geometry);
}

std::string refuse(const ArmPlan& plan)
{
  const bool isSound = plan.maxForce_N > 0.0 && plan.maxStiffness_N_per_m > 0.0 && plan.maxDamping_Ns_per_m > 0.0;
  std::string problem = std::visit(Refusal{}, plan.geometry);
  problem = problem.empty() ? refuseWrist(plan) : problem;
  problem = problem.empty() ? refuseJoints(plan) : problem;
  problem = problem.empty() ? refuseMasses(plan) : problem;
  return !problem.empty() ? problem
         : !plan.base_D.p.allFinite() || !(std::fabs(plan.base_D.q.norm() - 1.0) < 1e-9)
           ? "the place of the base is not a finite pose"
         : !isSound                    ? "the largest force, stiffness and damping must be above 0"
         : !(plan.maxCondition > 1.0)  ? "the largest condition must be above 1"
         : !plan.gravity_D.allFinite() ? "gravity is not finite"
         : !(plan.workSpace.radius_m >= 0.0 && std::isfinite(plan.workSpace.radius_m) &&
             plan.workSpace.centre_D.allFinite())
           ? "the radius of the work space must not be below 0"
           : "";
}

} // namespace palpate
