// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/kit/WoodenHapticsFile.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "haptics/arm/file/ArmFile.h"
#include "haptics/core/JsonNode.h"

namespace palpate
{
namespace
{

constexpr std::size_t longestText = 65536;
constexpr std::array<char, 3> bodies{ 'a', 'b', 'c' };

using Json = nlohmann::json;

/// Numbers of the file by their names.
class Numbers
{
public:
  explicit Numbers(const Json& json) : json_(json), node_(json, "") {}

  [[nodiscard]] double of(const std::string& name) const { return this->node_.needsNumber(name.c_str()); }
  [[nodiscard]] double of(const std::string& name, char axis) const { return this->of(name + '_' + axis); }
  /// A count that the board's counters can be set to.
  [[nodiscard]] std::int32_t count(const std::string& name, char axis) const
  {
    constexpr double most = 32767.0;
    const double number = this->of(name, axis);
    const bool isCount = std::fabs(number) <= most && number == std::round(number);
    this->node_.accept((name + '_' + axis).c_str(), isCount ? "" : "must be a whole number from -32767 to 32767");
    return static_cast<std::int32_t>(number);
  }
  /// Some writers have 0 and 1 for it.
  [[nodiscard]] bool isSet(const std::string& name, char axis) const
  {
    const std::string key = name + '_' + axis;
    const bool isNumber = this->node_.has(key.c_str()) && this->json_[key].is_number();
    return isNumber ? this->of(key) != 0.0 : this->node_.flag(key.c_str(), false);
  }
  [[nodiscard]] const JsonNode<Json>& node() const noexcept { return this->node_; }

private:
  const Json& json_;
  JsonNode<Json> node_;
};

/// Motor and body turn the same way where they are "aligned", which the firmware counts against.
ArmJoint jointOf(const Numbers& numbers, char axis)
{
  ArmJoint joint;
  const double sign = numbers.isSet("motor_and_body_aligned", axis) ? -1.0 : 1.0;
  joint.gear = sign * numbers.of("diameter_body", axis) / numbers.of("diameter_capstan", axis);
  joint.countsPerTurn = numbers.of("cpr_encoder", axis);
  joint.calibrated = numbers.count("calibrate_enc", axis);
  joint.torqueConstant_Nm_per_A = numbers.of("torque_constant_motor", axis);
  return joint;
}

/// Weights are those of its bodies, each at its centre of mass.
void addMasses(const Numbers& numbers, ArmPlan& plan)
{
  int link = 1;
  for (const char body : { 'b', 'c' })
  {
    const Vec3 at(numbers.of("length_cm_body", body), 0.0, 0.0);
    plan.masses.push_back({ numbers.of("mass_body", body), link++, at, at });
  }
}

ArmPlan planOf(const Numbers& numbers)
{
  ArmPlan plan;
  plan.name = "WoodenHaptics or Polhem arm";
  plan.source = "the owner's woodenhaptics.json";
  plan.geometry =
    WoodenGeometry{ numbers.of("length_body", 'a'), numbers.of("length_body", 'b'), numbers.of("length_body", 'c') };
  const ArmPlan known = knownArm("woodenhaptics-2015").value; // for the ends of joints, which an owner's file has not
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    plan.joints[i] = jointOf(numbers, bodies[i]);
    plan.joints[i].low_rad = known.joints[i].low_rad;
    plan.joints[i].high_rad = known.joints[i].high_rad;
  }
  for (int k = 0; k < 3; ++k)
  {
    plan.base_D.p[k] = -numbers.of(std::string("workspace_origin_") + "xyz"[k]);
  }
  plan.workSpace.radius_m = numbers.of("workspace_radius");
  plan.maxForce_N = numbers.of("max_linear_force");
  plan.maxStiffness_N_per_m = numbers.of("max_linear_stiffness");
  plan.maxDamping_Ns_per_m = numbers.of("max_linear_damping");
  addMasses(numbers, plan);
  return plan;
}

WiredArm armOf(const Numbers& numbers)
{
  const double variant = numbers.of("variant");
  numbers.node().accept("variant", variant == 0.0 || variant == 1.0 || variant == 2.0
                                     ? ""
                                     : "the kinematics of this variant are not known: those of 0, 1 and 2 are");
  WiredArm arm{ planOf(numbers), woodenHapticsWire() };
  numbers.node().accept("", refuse(arm.plan));
  limitToWire(arm.plan, *arm.wire);
  numbers.node().accept("", refuse(arm.plan, *arm.wire));
  return arm;
}

} // namespace

/// An mbed, and a Teensy.
ArmWire woodenHapticsWire()
{
  ArmWire wire;
  wire.devices.ids = { { 0x1234, 0x0006 }, { 0x16C0, 0x0486 } };
  wire.pose = "Hold the arm in its calibration pose, then press the button: its counters are set there.";
  wire.poseTolerance = 300.0;
  wire.board = WoodenHapticsBoard{ 0, true };
  return wire;
}

Outcome<WiredArm> readWoodenHapticsFile(const std::string& text)
{
  if (text.size() > longestText)
  {
    return { {}, "it has more than 64 KiB" };
  }
  Outcome<WiredArm> arm;
  arm.problem = jsonProblemOf<Json>(
    [&]
    {
      const Json json = Json::parse(text);
      arm.value = armOf(Numbers(json));
    });
  return arm;
}

} // namespace palpate
