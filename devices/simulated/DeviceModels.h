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

/// Where the numbers of a model come from.
enum class Provenance : std::uint8_t
{
  Definition, ///< it stands for no hardware, so none of them is a guess
  Listed,     ///< limits from a list of devices; how it moves is typical of its kind
  Assumed,    ///< all of them
};

/// What turns: the handle of a device, or a hand that holds it, the same about every axis. Nothing turns without
/// inertia.
struct TurningModel
{
  double inertia_kg_m2 = 0.0;
  double damping_Nms = 0.0;
  double friction_Nm = 0.0; ///< Coulomb; of a device
  double step_rad = 0.0;    ///< of its encoder; 0: exact
  double maxTorque_Nm = std::numeric_limits<double>::infinity();
  double stiffness_Nm_per_rad = 0.0; ///< of a hand, to how it is led
};

/// A device's moving part: the same along every axis, or an arm, which differs from axis to axis and pose to pose. A
/// fixture for tests and for people without hardware.
struct DeviceModel
{
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  std::string id;   ///< D0 .. D11
  std::string name; ///< the name the factory knows
  std::string what; ///< one line for a person
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
  double loop_s = 0.0; ///< period of the device's own loop, in which it closes walls; 0: it has none
  bool bareSprings =
    false; ///< it closes walls with springs that pull as well as push, and have no limit (BareSprings.h)
  double link_B_per_s = unlimited; ///< what its link carries (SerialLink.h)
  TurningModel turning = {};       ///< without inertia: it neither turns nor tells how it is turned
  /// What moves, where it is more than a mass; then mass, damping, friction and step above are those of its worst
  /// direction, and the work space is about the origin of D.
  std::shared_ptr<const ArmPlan> arm = {};

  [[nodiscard]] bool turns() const noexcept { return this->turning.inertia_kg_m2 > 0.0; }
};

/// D0 ideal, D1 generic, D2 touch, D3 premium, D4 falcon, D5 omega, D6 joystick. Largest force, stiffness and damping
/// are what open toolkits list for such devices; masses, dampings, friction and steps are typical of the literature,
/// those of the joystick assumed. D7 is D3 with a handle that turns and is turned, its turning part assumed. D8 is the
/// joystick as it was in the nineties: bare springs behind a serial link.
[[nodiscard]] const std::vector<DeviceModel>& deviceModels();

/// D9 a Falcon, D10 a WoodenHaptics, D11 a pantograph, from the files of these arms.
[[nodiscard]] const std::vector<DeviceModel>& armModels();

/// A model of such an arm. Mass, damping and friction are those of the direction and the place in the work space where
/// the stiffest wall that holds at 1 kHz is softest; the force is one that the motors give everywhere in every
/// direction. Not an arm that refuseSimulation refuses.
[[nodiscard]] DeviceModel armModel(
  const std::string& id, const std::string& name, const std::string& what, const ArmPlan& plan);

/// What the device says about itself. Limits count as known where they are listed; how the hardware moves, its encoder
/// and the workspace, a ball in place of its true shape, as assumed.
[[nodiscard]] DeviceInfo infoOf(const DeviceModel& model);

/// A hand that holds it: a spring, a damper and a mass to where the hand is led.
struct HandModel
{
  std::string name;
  double stiffness_N_per_m = 0.0;
  double damping_Ns_per_m = 0.0;
  double mass_kg = 0.0;
  TurningModel turning = {}; ///< how it turns; the times of its spring are those of its way
};

/// H0 none, H1 light, H2 stylus, H3 firm (the range of a fingertip's spring and damper: Hajian & Howe 1997).
[[nodiscard]] const std::vector<HandModel>& handModels();

/// By name, or null.
[[nodiscard]] const DeviceModel* deviceModel(const std::string& name);
[[nodiscard]] const HandModel* handModel(const std::string& name);

} // namespace palpate
