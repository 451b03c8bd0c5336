// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/Experiments.h"

namespace palpate::lab
{

std::vector<Experiment> experiments()
{
  return {
    { "wall-stability", "the stiffness at which a sampled wall begins to shake is that of exact eigenvalues, at nine rates",
      { 1, 2 }, runWallStability },
    { "stability-atlas", "how stiff a wall may be against rate, delay, damping, encoder step and friction", { 1, 2, 6 },
      runStabilityAtlas },
    { "energy-leak", "a held spring gives K v T (p - v T / 2) to a hand that presses and lets go", { 3 }, runEnergyLeak },
    { "bounce", "a mass thrown at a held wall comes back faster, at one under control it does not", { 4, 5 }, runBounce },
    { "limit-cycles", "where damping and friction keep a quantised wall still, and where it cycles", { 6 }, runLimitCycles },
    { "velocity-estimators", "what an encoder lets one know of a velocity, how late, and the damping that allows", { 7 },
      runVelocityEstimators },
    { "transparency", "what each stabiliser costs a hand in drag and impedance, and the stiffness it brings", { 58 },
      runTransparency },
    { "thin-plate", "a push far beyond a thin plate is held by the side it came from", { 8 }, runThinPlate },
    { "corners", "concave corners, almost flat valleys and narrow wedges are exact in one tick", { 11, 12, 13 },
      runCorners },
  };
}

} // namespace palpate::lab
