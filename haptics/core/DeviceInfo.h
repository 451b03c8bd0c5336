// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace palpate
{

/// How many axes of force a device has; Vibration devices only signal.
enum class DeviceClass : std::uint8_t
{
  Vibration0D,
  Wheel1D,
  Joystick2D,
  Point3D,
  Rigid6D,
};

enum class Causality : std::uint8_t
{
  Impedance,  ///< position in, force out
  Admittance, ///< force in, position out
};

/// Who decides when the next tick is due.
enum class Pacing : std::uint8_t
{
  Timer,    ///< the servo's own absolute timer
  Device,   ///< the device: a wait for its next sample paces the loop
  Callback, ///< the vendor's thread: its call ends that wait
};

/// A number with its provenance: the panel says which limits are only assumed.
struct DeviceQuantity
{
  double value = 0.0;
  bool known = false;
};

/// Sensed and rendered abilities of a device, besides one force.
struct DeviceAbilities
{
  std::uint8_t sensedAxes = 3; ///< 1: x; 2: x and y; 3: a point; 6: a point and how it is turned
  bool holdsWalls = false;     ///< by itself, at its own rate
  bool viscous = false;        ///< brakes the hand by itself
  bool signals = false;        ///< a shake

  /// Walls are for a device that brakes the hand, too: without viscosity its corridors shake.
  [[nodiscard]] bool offersWalls() const noexcept { return this->holdsWalls && this->viscous; }
  friend bool operator==(const DeviceAbilities&, const DeviceAbilities&) = default;
};

/// Result of a check of the walls and the viscosity in the device's own loop. Nothing else tells whether a
/// firmware has the functions of its descriptor.
enum class HeldProof : std::uint8_t
{
  Unfelt,    ///< it was not checked
  Felt,      ///< each wall pushes back as hard as it should, and the hand is braked
  WrongWay,  ///< a wall pulls the hand through
  NoForce,   ///< a wall does nothing
  WrongSize, ///< a wall is much softer or stiffer than it was asked to be
  Drives,    ///< the damper pushes the hand on
  NoBrake,   ///< the damper does nothing
  Unclear,   ///< the hand did not stay the same from push to push
  Misplaced, ///< a corridor's walls do not stand where they were asked to
  NoLimit,   ///< a wall pushes harder than it may
};

/// Abilities of a device. Filled once at opening.
struct DeviceInfo
{
  std::string name;   ///< the name the factory knows
  std::string serial; ///< empty where the device has none
  DeviceClass deviceClass = DeviceClass::Point3D;
  Causality causality = Causality::Impedance;
  Pacing pacing = Pacing::Timer;
  bool rendersForce = true;   ///< false: forces go nowhere (poses fed by a program, a replay, a SpaceMouse)
  bool rendersTorque = false; ///< it turns the hand; otherwise torques of commands are ignored
  /// Without torque: the least stiffness with which the device holds the hand's rotation, as it has no wrist that
  /// turns; 0: the rotation is free.
  double heldTurning_N_m_per_rad = 0.0;
  bool knowsAxes = false; ///< its kinematics give its axes: a check confirms them and finds none
  bool simulated = false; ///< lateness is counted, never a fault
  DeviceAbilities abilities;
  bool offersWalls = false; ///< so it says; with viscosity
  HeldProof heldProof = HeldProof::Unfelt;
  double effectsEndAfter_s = 0.0; ///< the device stops pushing by itself when its effects are not renewed; 0: never
  DeviceQuantity workspaceRadius_m{ 0.1, false };
  DeviceQuantity resolution_m{ 0.0, false };
  DeviceQuantity turnResolution_rad{ 0.0, false }; ///< of how the hand is turned
  DeviceQuantity maxTorque_Nm{ std::numeric_limits<double>::infinity(), false };
  DeviceQuantity maxForce_N{ std::numeric_limits<double>::infinity(), false };
  DeviceQuantity maxStiffness_N_per_m{ std::numeric_limits<double>::infinity(), false };
  DeviceQuantity maxDamping_Ns_per_m{ std::numeric_limits<double>::infinity(), false };
  DeviceQuantity heldStiffness_N_per_m{ std::numeric_limits<double>::infinity(), false }; ///< of walls it closes itself
  DeviceQuantity heldForce_N{ std::numeric_limits<double>::infinity(), false };           ///< that they push with
  DeviceQuantity forceUpdate_s{ 0.0, false }; ///< that its link takes for one force
  DeviceQuantity wallUpdate_s{ 0.0, false };  ///< and for the places of four walls
  DeviceQuantity mass_kg{ 0.0, false };
  DeviceQuantity damping_Ns_per_m{ 0.0, false };
  DeviceQuantity friction_N{ 0.0, false };
  DeviceQuantity turnInertia_kg_m2{ 0.0, false }; ///< of its handle; 0: not known, or without torque
  DeviceQuantity turnDamping_Nms{ 0.0, false };
  DeviceQuantity turnFriction_Nm{ 0.0, false };

  /// Walls may be left to it.
  [[nodiscard]] bool closesWalls() const noexcept
  {
    return this->abilities.offersWalls() && this->heldProof == HeldProof::Felt;
  }
};

} // namespace palpate
