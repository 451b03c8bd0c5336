// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/kit/WiredArm.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "devices/arm/protocol/WoodenHapticsWire.h"
#include "haptics/arm/Arm.h"

namespace palpate
{
namespace
{

/// Numbers of motors and encoders in a message.
struct Carried
{
  int motors = 0, encoders = 0;
};

Carried carriedBy(const ArmWire& wire)
{
  return std::holds_alternative<TwoDiyBoard>(wire.board) ? Carried{ 2, 2 }
                                                         : Carried{ WireOrder::motors, WireReading::encoders };
}

/// Of each joint in the pose in which the counters are set [degrees].
JointVector poseOf(const ArmPlan& plan)
{
  JointCounts counts{};
  std::transform(
    plan.joints.begin(), plan.joints.end(), counts.begin(), [](const ArmJoint& joint) { return joint.calibrated; });
  return Arm(plan).jointsOf(counts) * 180.0 / std::numbers::pi;
}

/// True if a planar arm moves in the plane z = 0 of the device, where its force is computed.
bool movesInPlane(const ArmPlan& plan)
{
  const auto isNormal = [](const Vec3& axis_D) { return std::fabs(axis_D.z()) > 1.0 - 1e-6; };
  Quat turn_D = plan.base_D.q;
  bool inPlane = isNormal(turn_D * Vec3::UnitZ());
  const auto* const chain = std::get_if<SerialGeometry>(&plan.geometry);
  for (int k = 0; chain != nullptr && k < chain->count; ++k)
  {
    const SerialGeometry::Hinge& hinge = chain->hinges[static_cast<std::size_t>(k)];
    turn_D = turn_D * hinge.origin.q;
    inPlane = inPlane && isNormal(turn_D * hinge.axis);
  }
  return inPlane;
}

std::string refuseMotors(const Arm& arm, const Carried& most)
{
  const auto says = [](const char* what, int number, const std::string& which, int has)
  {
    return std::string(what) + " " + std::to_string(number) + " " + which + ", and this arm has " + std::to_string(has);
  };
  return arm.joints() > most.encoders ? says("the protocol carries at most", most.encoders, "joints", arm.joints())
         : arm.motors() > most.motors ? says("the protocol carries at most", most.motors, "motors", arm.motors())
         : arm.motors() < arm.directions()
           ? says("a device needs", arm.directions(), "motors to push in every direction of its hand", arm.motors())
           : "";
}

/// The board counts in 32 bits.
std::string refuseJointOf2Diy(const ArmJoint& joint, double pose_deg)
{
  constexpr double most_deg = 360.0, mostCounts = 1e9;
  const double counts = joint.countsPerTurn * std::fabs(joint.gear);
  return joint.follows >= 0                         ? "it follows another one, which the protocol 2diy does not have"
         : !(counts >= 1.0 && counts <= mostCounts) ? "its counts a turn, times its gear, must be from 1 to 1e9"
         : !(std::fabs(pose_deg) <= most_deg)
           ? "its angle in the pose in which the counters are set is beyond 360 degrees"
           : "";
}

std::string refuseJointOfWoodenHaptics(const ArmJoint& joint)
{
  using Counter = std::numeric_limits<std::int16_t>;
  return joint.calibrated < Counter::min() || joint.calibrated > Counter::max()
           ? "its calibrated count must be from -32768 to 32767"
         : joint.hasMotor && !(joint.torqueConstant_Nm_per_A > 0.0) ? "its torque constant must be above 0"
                                                                    : "";
}

std::string refuseJoints(const ArmPlan& plan, const ArmWire& wire)
{
  const JointVector pose_deg = poseOf(plan);
  for (int k = 0; k < pose_deg.size(); ++k)
  {
    const ArmJoint& joint = plan.joints[static_cast<std::size_t>(k)];
    const std::string problem = !(joint.countsPerTurn > 0.0) ? "its counts a turn must be above 0"
                                : std::holds_alternative<TwoDiyBoard>(wire.board)
                                  ? refuseJointOf2Diy(joint, pose_deg[k])
                                  : refuseJointOfWoodenHaptics(joint);
    if (!problem.empty())
    {
      return "joint " + std::to_string(k + 1) + ": " + problem;
    }
  }
  return {};
}

} // namespace

const char* protocolOf(const ArmWire& wire) noexcept
{
  return std::visit([](const auto& board) { return board.protocol; }, wire.board);
}

std::string refuse(const ArmPlan& plan, const ArmWire& wire)
{
  const Arm arm(plan);
  std::string problem = refuseMotors(arm, carriedBy(wire));
  problem = problem.empty() ? refuseJoints(plan, wire) : problem;
  return !problem.empty()                   ? problem
         : !(plan.workSpace.radius_m > 0.0) ? "a device needs a work space with a radius above 0"
         : isPlanar(plan.geometry) && !movesInPlane(plan)
           ? "the joints of an arm with two of them must turn about z, so that the hand moves in the plane z = 0"
         : !arm.inverse(plan.workSpace.centre_D) ? "the arm does not reach the centre of its work space"
                                                 : "";
}

void limitToWire(ArmPlan& plan, const ArmWire& wire)
{
  for (ArmJoint& joint : plan.joints)
  {
    const double wire_Nm = std::holds_alternative<TwoDiyBoard>(wire.board)
                             ? TwoDiyWire::largest_Nm
                             : 1e-3 * WoodenHapticsWire::largest_mA * joint.torqueConstant_Nm_per_A;
    joint.maxTorque_Nm = std::min(joint.maxTorque_Nm, wire_Nm);
  }
}

ArmSetup setupOf(const WiredArm& arm)
{
  ArmSetup setup;
  setup.what = arm.plan.name;
  setup.plan = arm.plan;
  setup.pose = arm.wire->pose;
  setup.poseTolerance = arm.wire->poseTolerance;
  if (const auto* const board = std::get_if<WoodenHapticsBoard>(&arm.wire->board))
  {
    setup.grips = board->grips;
    setup.counterBits = 16;
    std::transform(arm.plan.joints.begin(), arm.plan.joints.end(), setup.counters.begin(),
      [](const ArmJoint& joint) { return static_cast<std::int16_t>(joint.calibrated); });
    return setup;
  }
  setup.tellsAngles = true;
  const JointVector pose_deg = poseOf(arm.plan);
  std::transform(pose_deg.begin(), pose_deg.end(), setup.counters.begin(),
    [](double angle_deg) { return static_cast<std::int16_t>(std::lround(angle_deg)); });
  return setup;
}

/// A gear below 0 turns the encoder's sense; the torque is turned by the division.
TwoDiyWire::Setup boardOf(const WiredArm& arm)
{
  const TwoDiyBoard& board = std::get<TwoDiyBoard>(arm.wire->board);
  const JointVector pose_deg = poseOf(arm.plan);
  TwoDiyWire::Setup setup;
  setup.device = board.device;
  for (std::size_t i = 0; i < setup.gear.size(); ++i)
  {
    const ArmJoint& joint = arm.plan.joints[i];
    setup.gear[i] = joint.gear;
    setup.offset_deg[i] = pose_deg[static_cast<int>(i)];
    setup.countsPerTurn[i] = joint.countsPerTurn * std::fabs(joint.gear);
    setup.motorTurned[i] = board.motorTurned[i] ? 1 : 0;
    setup.encoderTurned[i] = board.encoderTurned[i] != (joint.gear < 0.0) ? 1 : 0;
  }
  return setup;
}

std::array<double, WireOrder::motors> constantsOf(const ArmPlan& plan)
{
  std::array<double, WireOrder::motors> constants_Nm_per_A{};
  for (std::size_t i = 0; i < constants_Nm_per_A.size(); ++i)
  {
    const bool isMotor = static_cast<int>(i) < jointCountOf(plan.geometry) && plan.joints[i].hasMotor;
    constants_Nm_per_A[i] = isMotor ? plan.joints[i].torqueConstant_Nm_per_A : 1.0;
  }
  return constants_Nm_per_A;
}

} // namespace palpate
