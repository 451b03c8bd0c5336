// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/simulation/PlaneGame.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include "testing/support/Meshes.h"

namespace palpate::lab
{

PlaneGame::PlaneGame(const PlaneGameSetup& setup)
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = setup.stiffness_N_per_m;
  parameters.limitStiffness = false;
  parameters.safety = SafetyLimits::none();
  parameters.walls.hold = setup.closed == Closed::ByDevice;
  SimulationOptions simulation;
  simulation.period_s = 1.0 / setup.rate_Hz;
  simulation.push_D = setup.push_D;
  simulation.velocity_D = setup.velocity_D;
  HandPath path;
  path.points_D = { Vec3::Zero() };
  auto device = std::make_unique<SimulatedDevice>(setup.model, *handModel("none"), path, simulation);
  this->device_ = device.get();
  SessionOptions options;
  options.period_s = simulation.period_s;
  options.virtualTime = true;
  this->session_.setScene(test::sceneOf(raiseWalls(setup.curves, 0.01)));
  const std::string problem = this->session_.setParameters(parameters);
  if (!problem.empty() || !this->session_.start(std::move(device), options).empty())
  {
    throw std::runtime_error("the simulated joystick cannot be played");
  }
}

} // namespace palpate::lab
