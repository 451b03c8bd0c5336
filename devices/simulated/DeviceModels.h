// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "haptics/core/DeviceInfo.h"

namespace palpate
{

struct ArmPlan;

/// Source of the numbers of a model.
enum class Provenance : std::uint8_t
{
  Definition, ///< the model stands for no hardware, so that no number is a guess
  Listed,     ///< limits from a list of devices; its dynamics are typical of its kind
  Assumed,    ///< all of them
};

/// A rotating part: the handle of a device, or a hand that holds the handle, the same about every axis. Without inertia
/// there is no rotation.
struct TurningModel
{
  double inertia_kg_m2 = 0.0;
  double damping_Nms = 0.0;
  double friction_Nm = 0.0; ///< Coulomb; of a device
  double step_rad = 0.0;    ///< of its encoder; 0: exact
  double maxTorque_Nm = std::numeric_limits<double>::infinity();
  double stiffness_Nm_per_rad = 0.0; ///< of a hand, towards the rotation to which it is led
};

/// A device's moving part: the same along every axis, or an arm, which differs from axis to axis and pose to pose. A
/// fixture for tests and for users without hardware.
struct DeviceModel
{
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  std::string id;   ///< D0 .. D11
  std::string name; ///< name for the factory
  std::string what; ///< one line for the user
  double mass_kg = 0.1;
  double damping_Ns_per_m = 0.0;
  double friction_N = 0.0;    ///< Coulomb
  double encoderStep_m = 0.0; ///< 0: exact positions
  double maxForce_N = unlimited;
  double maxStiffness_N_per_m = unlimited;
  double maxDamping_Ns_per_m = unlimited;
  double workspaceRadius_m = 0.1;
  double travel_m = unlimited; ///< stops at +- this along each axis
  bool planar = false;         ///< moves in x and y only
  Provenance provenance = Provenance::Listed;
  double loop_s = 0.0; ///< period of the device's own loop, in which it renders walls; 0: no such loop
  bool bareSprings =
    false; ///< it renders walls with springs that pull as well as push, and have no limit (BareSprings.h)
  double link_B_per_s = unlimited; ///< capacity of its link (SerialLink.h)
  TurningModel turning = {};       ///< without inertia: the device neither rotates nor reports its rotation
  /// The arm, where the moving part is more than a mass; then mass, damping, friction and step above are those of its
  /// worst direction, and the work space is about the origin of D.
  std::shared_ptr<const ArmPlan> arm = {};

  [[nodiscard]] bool turns() const noexcept { return this->turning.inertia_kg_m2 > 0.0; }
};

/// D0 ideal, D1 generic, D2 touch, D3 premium, D4 falcon, D5 omega, D6 joystick. Largest force, stiffness and damping
/// are those that open toolkits list for such devices; masses, dampings, friction and steps are typical of the
/// literature, those of the joystick assumed. D7 is D3 with a handle that senses rotation and renders torque, both
/// assumed. D8 is the joystick as it was in the nineties: bare springs behind a serial link.
[[nodiscard]] const std::vector<DeviceModel>& deviceModels();

/// D9 a Falcon, D10 a WoodenHaptics, D11 a pantograph, from the files of these arms.
[[nodiscard]] const std::vector<DeviceModel>& armModels();

/// A model of such an arm. Mass, damping and friction are those of the direction and the position in the work space
/// where the stiffest wall that is stable at 1 kHz is softest; the force is one that the motors give everywhere in
/// every direction. The plan must be one that refuseSimulation() accepts.
[[nodiscard]] DeviceModel armModel(
  const std::string& id, const std::string& name, const std::string& what, const ArmPlan& plan);

/// The device's description of itself. Limits count as known where they are listed; the dynamics of the hardware, its
/// encoder and the workspace, a ball in place of its true shape, as assumed.
[[nodiscard]] DeviceInfo infoOf(const DeviceModel& model);

/// A hand on the device: a mass with a spring and a damper to the position to which the hand is led.
struct HandModel
{
  std::string name;
  double stiffness_N_per_m = 0.0;
  double damping_Ns_per_m = 0.0;
  double mass_kg = 0.0;
  TurningModel turning = {}; ///< its rotation, with the time constants of its translation
};

/// H0 none, H1 light, H2 stylus, H3 firm (the range of a fingertip's spring and damper: Hajian & Howe 1997).
[[nodiscard]] const std::vector<HandModel>& handModels();

/// By name, or null.
[[nodiscard]] const DeviceModel* deviceModel(const std::string& name);
[[nodiscard]] const HandModel* handModel(const std::string& name);

} // namespace palpate
