// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/simulation/DeviceTable.h"

namespace palpate::lab
{
std::vector<TableDevice> tableDevices()
{
  const auto mk = [](double m, double b, double c, double D, double F, double K) { FreeDevice f; f.mass_kg = m; f.damping_Ns_per_m = b; f.friction_N = c; f.encoderStep_m = D; if (F > 0) f.maxForce_N = F; if (K > 0) f.maxStiffness_N_per_m = K; return f; };
  return { { "D1", mk(.1, 1, 0, 0, 0, 0) }, { "D3", mk(.072, .005, .04, 30e-6, 8.5, 800) }, { "D0", mk(.1, 0, 0, 0, 0, 0) }, { "D2", mk(.045, .1, .26, 55e-6, 3.3, 400) }, { "D4", mk(.25, 3, .3, 60e-6, 8, 3000) }, { "D5", mk(.25, 2.5, .1, 10e-6, 12, 5000) }, { "D6", mk(.05, .5, .3, 0.1 / 1024, 5, 200) } };
}
}
