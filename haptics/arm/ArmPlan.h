// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "haptics/arm/ArmTypes.h"

namespace palpate
{

/// Hinges in a chain, as in URDF: each is placed in the frame of the previous link and turns the next link.
struct SerialGeometry
{
  struct Hinge
  {
    Pose origin;               ///< in the frame of the previous link [m]
    Vec3 axis = Vec3::UnitZ(); ///< in the hinge's own frame, of length 1
  };
  int count = 0; ///< of hinges
  std::array<Hinge, mostJoints> hinges;
  Pose tip; ///< in the frame of the last link [m]
};

/// The arm of WoodenHaptics and Polhem (Forsslund Systems): a column turns by A about z; an upper link leans from
/// upright by B, a forearm from hanging by C, each by a motor on the column, so that B and C do not add.
struct WoodenGeometry
{
  double column_m = 0.0, upper_m = 0.0, fore_m = 0.0;
};

/// Three legs that keep the orientation of a platform (Clavel 1991), or with hinges apart as in Stamper (A three degree
/// of freedom parallel manipulator with only translational degrees of freedom, 1997), as the Novint Falcon has them.
struct DeltaGeometry
{
  /// The azimuth of a leg about z, by its direction: every posture needs that and not the angle.
  struct Azimuth
  {
    double cosine = 1.0, sine = 0.0;
    [[nodiscard]] static Azimuth of(double angle_rad) noexcept { return { std::cos(angle_rad), std::sin(angle_rad) }; }
  };
  std::array<Azimuth, 3> legs;
  double base_m = 0.0;     ///< from the axis to the joints of the base
  double platform_m = 0.0; ///< from the axis to the joints of the platform
  double arm_m = 0.0, forearm_m = 0.0;
  double hinge_m = 0.0;  ///< length of each forearm's hinges in its arm's plane, beside the parallelogram
  double offset_m = 0.0; ///< offset of each leg across its azimuth
  double side = 1.0;     ///< side of the base on which the platform is, along z: 1 or -1; arms turn to that side
};

/// Two arms from the points -base/2 and base/2 of the x axis, joined at the tip; elbows outwards, the tip on the side
/// of y. Angles from x, towards y.
struct FiveBarGeometry
{
  double base_m = 0.0, arm_m = 0.0, forearm_m = 0.0;
};

using ArmGeometry = std::variant<SerialGeometry, WoodenGeometry, DeltaGeometry, FiveBarGeometry>;

inline constexpr int mostWristHinges = 3;

/// A joint, with its encoder and its motor.
struct ArmJoint
{
  double low_rad = -std::numeric_limits<double>::infinity();
  double high_rad = std::numeric_limits<double>::infinity();
  double zero_rad = 0.0;       ///< at count 0
  double countsPerTurn = 0.0;  ///< of the encoder; 0: the encoder reports angles
  double gear = 1.0;           ///< turns of encoder and motor per turn of the joint; below 0: in the opposite sense
  int follows = -1;            ///< index of a joint whose encoder moves this joint too; -1: none
  double followShare = 0.0;    ///< turns of this joint per turn of that joint by its own encoder
  std::int32_t calibrated = 0; ///< count in the pose of calibration
  bool hasMotor = true;
  double maxTorque_Nm = std::numeric_limits<double>::infinity(); ///< of the motor
  double torqueStep_Nm = 0.0;                                    ///< of the motor's command; 0: any torque
  double torqueConstant_Nm_per_A = 0.0;                          ///< of the motor; 0: unknown
  double rotor_kg_m2 = 0.0;                                      ///< of the motor
  double damping_Nms = 0.0, friction_Nm = 0.0;                   ///< at the joint
};

/// A mass on a link: a point, or a thin uniform rod from one point of the link to another. On the links of a delta, of
/// a five-bar and of WoodenHaptics x is the distance along the link, from the joint nearer to the base; a forearm with
/// hinges apart has the length of both together. The links of a wrist come after those of its kind; on them, as on
/// those of a chain, a point is in the frame of the link.
struct ArmMass
{
  double mass_kg = 0.0;
  int link = 0; ///< from 1; the header of each kind lists its links
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

/// The part of its reach in which an arm is used: a ball, or a disc for a planar arm.
struct ArmWorkSpace
{
  Vec3 centre_D = Vec3::Zero();
  double radius_m = 0.0; ///< 0: not known
};

/// An arm as a file describes it. `base_D` places the geometry in the device frame D.
struct ArmPlan
{
  std::string name;
  std::string source; ///< origin of the numbers
  ArmGeometry geometry;
  /// Hinges on the tip of any kind but a chain, in the frame that Wrist.h has; count 0: none.
  SerialGeometry wrist;
  Pose base_D;
  std::array<ArmJoint, mostJoints> joints; ///< those with motors first, those of the wrist last
  std::vector<ArmMass> masses;
  Vec3 gravity_D{ 0.0, 0.0, -9.81 }; ///< [m/s2]
  ArmWorkSpace workSpace;
  double maxForce_N = std::numeric_limits<double>::infinity();
  double maxStiffness_N_per_m = std::numeric_limits<double>::infinity();
  double maxDamping_Ns_per_m = std::numeric_limits<double>::infinity();
  double maxCondition = 20.0; ///< condition number of the Jacobian beyond which there is no force
};

/// serial, woodenhaptics, delta, five-bar.
[[nodiscard]] const char* nameOf(const ArmGeometry& geometry) noexcept;
/// Without a wrist.
[[nodiscard]] int jointCountOf(const ArmGeometry& geometry) noexcept;
[[nodiscard]] int linkCountOf(const ArmGeometry& geometry) noexcept;
/// serial: one chain of links carries the tip, as in woodenhaptics, whose motors on the column turn links of one chain;
/// parallel: several chains carry it; hybrid: they carry a wrist (Antonov, Parallel-serial robotic manipulators, 2024).
[[nodiscard]] const char* classOf(const ArmPlan& plan) noexcept;
/// True if the arm moves only in the plane z = 0 of its frame.
[[nodiscard]] bool isPlanar(const ArmGeometry& geometry) noexcept;

/// Empty, or one sentence with the reason why the plan is impossible.
[[nodiscard]] std::string refuse(const ArmPlan& plan);

} // namespace palpate
