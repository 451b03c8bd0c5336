// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>

#include "devices/simulated/ArmPlant.h"
#include "devices/simulated/DeviceModels.h"
#include "haptics/arm/ArmMeasures.h"
#include "haptics/arm/file/ArmFile.h"
#include "haptics/force/StabilityLimits.h"

namespace palpate
{
namespace
{

/// The middle, the ends of the axes, of the diagonals of faces and of the cube in the ball of the work space.
std::vector<Vec3> spreadOver(const ArmWorkSpace& space, bool isPlanar)
{
  std::vector<Vec3> places;
  for (int i = 0; i < (isPlanar ? 9 : 27); ++i)
  {
    const Vec3 way(i % 3 - 1, i / 3 % 3 - 1, isPlanar ? 0 : i / 9 - 1);
    places.push_back(space.centre_D + space.radius_m * way / std::max(1.0, way.norm()));
  }
  return places;
}

/// A mass with damping and friction along one direction at one position.
struct Part
{
  double mass_kg, damping_Ns_per_m, friction_N;
};

std::vector<Part> partsOf(const Arm& arm)
{
  std::vector<Part> parts;
  for (const Vec3& p_D : spreadOver(arm.plan().workSpace, arm.directions() == 2))
  {
    const std::optional<JointVector> q = arm.inverse(p_D);
    const std::optional<PrincipalPart> part = q ? principalPartOf(arm, *q, arm.posture(*q)) : std::nullopt;
    for (int i = 0; part && i < part->count; ++i)
    {
      parts.push_back({ part->mass_kg[i], part->damping_Ns_per_m[i], part->friction_N[i] });
    }
  }
  return parts;
}

/// The part whose wall becomes unstable first. A part is never the first where another one is lighter and less damped,
/// so that only the remaining parts are tried.
Part worstOf(const std::vector<Part>& parts)
{
  double softest = std::numeric_limits<double>::infinity();
  Part worst = parts.front();
  for (const Part& part : parts)
  {
    const bool isUndercut = std::any_of(parts.begin(), parts.end(),
      [&part](const Part& other)
      { return other.mass_kg < part.mass_kg && other.damping_Ns_per_m < part.damping_Ns_per_m; });
    if (isUndercut)
    {
      continue;
    }
    DeviceInfo info;
    info.mass_kg.value = part.mass_kg;
    info.damping_Ns_per_m.value = part.damping_Ns_per_m;
    const double stable = stabilityLimits(info, {}).stable_N_per_m;
    if (stable < softest)
    {
      softest = stable;
      worst = part;
    }
  }
  return worst;
}

/// The force that the motors give in every direction everywhere in the work space.
double forceOf(const Arm& arm)
{
  double force = arm.plan().maxForce_N;
  for (const Vec3& p_D : spreadOver(arm.plan().workSpace, arm.directions() == 2))
  {
    const std::optional<JointVector> q = arm.inverse(p_D);
    force = q ? std::min(force, measure(arm, *q).leastForce_N) : force;
  }
  return force;
}

DeviceModel builtIn(const char* id, const char* name, const char* what, const char* file)
{
  const Outcome<ArmPlan> plan = knownArm(file);
  if (!plan.ok())
  {
    throw std::logic_error(plan.problem); // a fault of the build: the tests read every file
  }
  return armModel(id, name, what, plan.value);
}

} // namespace

DeviceModel armModel(const std::string& id, const std::string& name, const std::string& what, const ArmPlan& given)
{
  ArmPlan plan = given;
  plan.base_D.p -= plan.workSpace.centre_D;
  plan.workSpace.centre_D.setZero();
  const Arm arm(plan);
  const Part worst = worstOf(partsOf(arm));
  DeviceModel model;
  model.id = id;
  model.name = name;
  model.what = what;
  model.mass_kg = worst.mass_kg;
  model.damping_Ns_per_m = worst.damping_Ns_per_m;
  model.friction_N = worst.friction_N;
  model.encoderStep_m = countStepOf(arm, *arm.inverse(Vec3::Zero()));
  model.maxForce_N = forceOf(arm);
  model.maxStiffness_N_per_m = plan.maxStiffness_N_per_m;
  model.maxDamping_Ns_per_m = plan.maxDamping_Ns_per_m;
  model.workspaceRadius_m = plan.workSpace.radius_m;
  model.planar = arm.directions() == 2;
  model.arm = std::make_shared<const ArmPlan>(plan);
  return model;
}

const std::vector<DeviceModel>& armModels()
{
  static const std::vector<DeviceModel> models = {
    builtIn("D9", "simulated-falcon-arm", "the delta of a Novint Falcon", "falcon"),
    builtIn("D10", "simulated-woodenhaptics", "the serial arm of a WoodenHaptics", "woodenhaptics-2015"),
    builtIn("D11", "simulated-pantograph", "the five-bar of a Haply 2DIY", "pantograph"),
  };
  return models;
}

} // namespace palpate
