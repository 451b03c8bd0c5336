// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/DeviceModels.h"

#include <algorithm>

#include "devices/simulated/SerialLink.h"

namespace palpate
{
namespace
{

constexpr double none = DeviceModel::unlimited;
constexpr double serial_B_per_s = 31250.0 / 10.0; // of 10 bits each, with start and stop

template<class Model>
const Model* byName(const std::vector<Model>& models, const std::string& name)
{
  const auto found =
    std::find_if(models.begin(), models.end(), [&name](const Model& model) { return model.name == name; });
  return found == models.end() ? nullptr : &*found;
}

} // namespace

const std::vector<DeviceModel>& deviceModels()
{
  static const std::vector<DeviceModel> models = {
    { "D0", "simulated-ideal", "0.1 kg, without damping or friction", 0.1, 0.0, 0.0, 0.0, none, none, none, 0.1, none,
      false, Provenance::Definition },
    { "D1", "simulated-generic", "0.1 kg with a damping of 1 N s/m", 0.1, 1.0, 0.0, 0.0, none, none, none, 0.1, none,
      false, Provenance::Definition },
    { "D2", "simulated-touch", "a desktop stylus arm: light, with friction, 3.3 N", 0.045, 0.1, 0.26, 55e-6, 3.3, 400.0,
      4.0, 0.075, none },
    { "D3", "simulated-premium", "a laboratory stylus arm: hardly any friction, 8.5 N", 0.072, 0.005, 0.04, 30e-6, 8.5,
      800.0, none, 0.1, none },
    { "D4", "simulated-falcon", "a parallel game device: heavy and damped, 8 N", 0.25, 3.0, 0.3, 60e-6, 8.0, 3000.0,
      20.0, 0.04, none },
    { "D5", "simulated-omega", "a parallel laboratory device: fine encoders, 12 N", 0.25, 2.5, 0.1, 10e-6, 12.0, 5000.0,
      30.0, 0.08, none },
    { "D6", "simulated-joystick", "a force-feedback joystick: a plane of 100 mm in 1024 steps, 5 N", 0.05, 0.5, 0.3,
      0.1 / 1024, 5.0, 200.0, none, 0.05, 0.05, true, Provenance::Assumed, 1e-3 },
    { "D7", "simulated-6d", "the laboratory stylus arm with a handle that turns in the hand, 0.5 N m", 0.072, 0.005,
      0.04, 30e-6, 8.5, 800.0, none, 0.1, none, false, Provenance::Listed, 0.0, false, none,
      { 1e-4, 1e-3, 5e-3, 1e-4, 0.5 } },
    { "D8", "simulated-serial-joystick", "the same joystick with bare springs behind a serial link of 31,250 baud",
      0.05, 0.5, 0.3, 0.1 / 1024, 5.0, 200.0, none, 0.05, 0.05, true, Provenance::Assumed, 1e-3, true, serial_B_per_s },
  };
  return models;
}

DeviceInfo infoOf(const DeviceModel& model)
{
  DeviceInfo info;
  info.name = model.name;
  info.simulated = true;
  info.deviceClass = model.planar    ? DeviceClass::Joystick2D
                     : model.turns() ? DeviceClass::Rigid6D
                                     : DeviceClass::Point3D;
  info.abilities.sensedAxes = model.planar ? 2 : model.turns() ? 6 : 3;
  info.rendersTorque = model.turns();
  info.abilities.holdsWalls = info.abilities.viscous = model.loop_s > 0.0;
  info.offersWalls = info.abilities.offersWalls();
  info.heldProof = HeldProof::Felt; // its walls are those of the formula
  const bool defined = model.provenance == Provenance::Definition, listed = model.provenance == Provenance::Listed;
  const auto limit = [=](double value) {
    return DeviceQuantity{ value, defined || (listed && value < DeviceModel::unlimited) };
  };
  const auto typical = [=](double value) { return DeviceQuantity{ value, defined }; };
  info.maxForce_N = limit(model.maxForce_N);
  info.maxStiffness_N_per_m = limit(model.maxStiffness_N_per_m);
  if (info.abilities.holdsWalls)
  {
    info.heldStiffness_N_per_m = limit(model.maxStiffness_N_per_m);
    info.heldForce_N = limit(model.maxForce_N);
  }
  info.maxDamping_Ns_per_m = limit(model.maxDamping_Ns_per_m);
  info.workspaceRadius_m = typical(model.workspaceRadius_m);
  info.resolution_m = typical(model.encoderStep_m);
  info.forceUpdate_s = typical(SerialLink::force_B / model.link_B_per_s);
  info.wallUpdate_s = typical(SerialLink::walls_B / model.link_B_per_s);
  info.mass_kg = typical(model.mass_kg);
  info.damping_Ns_per_m = typical(model.damping_Ns_per_m);
  info.friction_N = typical(model.friction_N);
  if (model.turns())
  {
    info.maxTorque_Nm = { model.turning.maxTorque_Nm, false };
    info.turnResolution_rad = { model.turning.step_rad, false };
    info.turnInertia_kg_m2 = { model.turning.inertia_kg_m2, false };
    info.turnDamping_Nms = { model.turning.damping_Nms, false };
    info.turnFriction_Nm = { model.turning.friction_Nm, false };
  }
  return info;
}

const std::vector<HandModel>& handModels()
{
  const auto turning = [](double stiffness, double damping, double inertia) {
    return TurningModel{ inertia, damping, 0.0, 0.0, none, stiffness };
  };
  static const std::vector<HandModel> models = {
    { "none", 0.0, 0.0, 0.0 },
    { "light", 200.0, 2.0, 0.02, turning(0.5, 0.005, 5e-5) },
    { "stylus", 500.0, 5.0, 0.1, turning(1.0, 0.01, 2e-4) },
    { "firm", 1000.0, 10.0, 0.2, turning(2.0, 0.02, 4e-4) },
  };
  return models;
}

const DeviceModel* deviceModel(const std::string& name)
{
  const DeviceModel* const ball = byName(deviceModels(), name);
  return ball != nullptr ? ball : byName(armModels(), name);
}

const HandModel* handModel(const std::string& name)
{
  return byName(handModels(), name);
}

} // namespace palpate
