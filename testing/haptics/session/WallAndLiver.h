// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/session/mechanism/MechanismBodies.h"
#include "testing/haptics/compliance/Blocks.h"

namespace palpate::test
{

inline constexpr double needle_m = 0.15;
inline constexpr double skin_N = 1.5, capsule_N = 0.8, inSkin_N = 0.4, inCapsule_N = 0.2;

/// A box of that size behind `z`, of so many cells.
inline std::shared_ptr<const SoftBodyInput> boxOfTissue(const std::array<int, 3>& cells, const Vec3& size, double z,
  double young_Pa, const std::function<bool(const Vec3&)>& isFixed)
{
  SoftBodyInput input;
  input.mesh = blockOf(cells, size);
  input.fixed = fixedWhere(input.mesh, isFixed);
  for (Vec3& p : input.mesh.vertices_W)
  {
    p += Vec3(-0.5 * size.x(), -0.5 * size.y(), z);
  }
  input.young_Pa = { young_Pa };
  input.element = ElementKind::Linear;
  input.model = ElasticModel::Linear;
  return std::make_shared<const SoftBodyInput>(std::move(input));
}

inline MechanismBody bodyCalled(const char* name, MechanismBodyKind kind)
{
  MechanismBody body;
  body.name = name;
  body.kind = kind;
  body.length_u = needle_m;
  body.diameter_u = 1.2e-3;
  return body;
}

inline MechanismConstraint puncture(const char* name, const char* of, double strength_N, double rubs_N)
{
  MechanismConstraint law;
  law.name = name;
  law.kind = ConstraintKind::Puncture;
  law.a = "needle";
  law.b = of;
  law.strength_N = strength_N;
  law.dryFriction_N = rubs_N;
  law.friction = 1.0;
  return law;
}

/// The scene of data/mechanisms/needle.json in metres, the wall's outer side at z = 0. Of 2 cells a side as fine as
/// there, of 1 half as fine.
inline MechanismInputs wallAndLiver(int cells)
{
  MechanismInputs inputs;
  inputs.mechanism.bodies = { bodyCalled("needle", MechanismBodyKind::Held),
    bodyCalled("wall", MechanismBodyKind::Soft), bodyCalled("liver", MechanismBodyKind::Soft) };
  inputs.mechanism.laws = { puncture("skin", "wall", skin_N, inSkin_N),
    puncture("capsule", "liver", capsule_N, inCapsule_N) };
  const Vec3 wall(0.08, 0.08, 0.016), liver(0.08, 0.08, 0.04);
  const auto rim = [wall](const Vec3& p)
  { return p.x() == 0.0 || p.y() == 0.0 || p.x() == wall.x() || p.y() == wall.y(); };
  const auto floor = [liver](const Vec3& p) { return p.z() == liver.z(); };
  inputs.soft = { { "wall", boxOfTissue({ 5 * cells, 5 * cells, cells }, wall, 0.0, 100e3, rim) },
    { "liver", boxOfTissue({ 4 * cells, 4 * cells, 2 * cells }, liver, 0.026, 20e3, floor) } };
  return inputs;
}

} // namespace palpate::test
