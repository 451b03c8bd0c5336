// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/simulated/DeviceModels.h"

namespace palpate::test
{

/// The simulated joystick without friction and with exact positions, so that truths are formulas; it holds walls as
/// stiff as one likes.
[[nodiscard]] inline DeviceModel plainJoystick(double damping_Ns_per_m)
{
  DeviceModel model = *deviceModel("simulated-joystick");
  model.damping_Ns_per_m = damping_Ns_per_m;
  model.friction_N = 0.0;
  model.encoderStep_m = 0.0;
  model.maxStiffness_N_per_m = DeviceModel::unlimited;
  return model;
}

} // namespace palpate::test
