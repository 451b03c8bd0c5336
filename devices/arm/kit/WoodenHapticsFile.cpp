// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/kit/WoodenHapticsFile.h"

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "devices/arm/protocol/WoodenHapticsWire.h"

namespace palpate
{
namespace
{

constexpr std::size_t longestText = 65536;
constexpr std::array<char, 3> bodies{ 'a', 'b', 'c' };

/// Numbers of the file by their names; keeps the first that is missing or is none.
class Numbers
{
public:
  explicit Numbers(const nlohmann::json& json) : json_(json) {}

  double of(const std::string& name)
  {
    const auto found = this->json_.find(name);
    const bool isThere = found != this->json_.end() && found->is_number() && std::isfinite(found->get<double>());
    if (!isThere && this->problem_.empty())
    {
      this->problem_ = "\"" + name + "\" is missing or no number";
    }
    return isThere ? found->get<double>() : 1.0;
  }
  double of(const std::string& name, char axis) { return this->of(name + '_' + axis); }
  /// Some writers have 0 and 1 for it.
  bool isSet(const std::string& name, char axis)
  {
    const auto found = this->json_.find(name + '_' + axis);
    return found != this->json_.end() && (found->is_boolean() ? found->get<bool>() : this->of(name, axis) != 0.0);
  }
  [[nodiscard]] const std::string& problem() const noexcept { return this->problem_; }

private:
  const nlohmann::json& json_;
  std::string problem_;
};

/// Motor and body turn the same way where they are "aligned", which the firmware counts against.
ArmJoint jointOf(Numbers& numbers, char axis)
{
  ArmJoint joint;
  const double sign = numbers.isSet("motor_and_body_aligned", axis) ? -1.0 : 1.0;
  joint.gear = sign * numbers.of("diameter_body", axis) / numbers.of("diameter_capstan", axis);
  joint.countsPerTurn = numbers.of("cpr_encoder", axis);
  joint.calibrated = static_cast<std::int32_t>(std::lround(std::fmod(numbers.of("calibrate_enc", axis), 32768.0)));
  joint.torqueConstant_Nm_per_A = numbers.of("torque_constant_motor", axis);
  joint.maxTorque_Nm = 1e-3 * WoodenHapticsWire::largest_mA * joint.torqueConstant_Nm_per_A;
  return joint;
}

/// Weights are those of its bodies, each at its centre of mass.
void addMasses(Numbers& numbers, ArmPlan& plan)
{
  int link = 1;
  for (const char body : { 'b', 'c' })
  {
    const Vec3 at(numbers.of("length_cm_body", body), 0.0, 0.0);
    plan.masses.push_back({ numbers.of("mass_body", body), link++, at, at });
  }
}

ArmPlan planOf(Numbers& numbers)
{
  ArmPlan plan;
  plan.name = "WoodenHaptics";
  plan.source = "the owner's woodenhaptics.json";
  plan.geometry =
    WoodenGeometry{ numbers.of("length_body", 'a'), numbers.of("length_body", 'b'), numbers.of("length_body", 'c') };
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    plan.joints[i] = jointOf(numbers, bodies[i]);
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

} // namespace

Outcome<WoodenHapticsArm> readWoodenHapticsFile(const std::string& text)
{
  const nlohmann::json json = text.size() <= longestText ? nlohmann::json::parse(text, nullptr, false)
                                                         : nlohmann::json(nlohmann::json::value_t::discarded);
  if (!json.is_object())
  {
    return { {}, "it is not one JSON object of at most 64 KiB" };
  }
  Numbers numbers(json);
  const double variant = numbers.of("variant");
  if (numbers.problem().empty() && !(variant >= 0.0 && variant <= 2.0))
  {
    return { {},
      "the kinematics of variant " + std::to_string(std::lround(variant)) + " are not known: 0, 1 and 2 are" };
  }
  WoodenHapticsArm arm;
  arm.setup.what = "WoodenHaptics or Polhem arm";
  arm.setup.plan = planOf(numbers);
  const std::string refused = numbers.problem().empty() ? refuse(*arm.setup.plan) : numbers.problem();
  if (!refused.empty())
  {
    return { {}, refused };
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    arm.constants_Nm_per_A[i] = arm.setup.plan->joints[i].torqueConstant_Nm_per_A;
    arm.setup.counters[i] = static_cast<std::int16_t>(arm.setup.plan->joints[i].calibrated);
    if (!(arm.constants_Nm_per_A[i] > 0.0))
    {
      return { {}, "a torque constant must be above 0" };
    }
  }
  arm.setup.counterBits = 16;
  arm.setup.grips = true;
  arm.setup.pose = "Hold the arm in its calibration pose, then press the button: its counters are set there.";
  return { std::move(arm), {} };
}

} // namespace palpate
