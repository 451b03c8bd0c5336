// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "testing/oracles/statics/NeedleLever.h"
#include "testing/support/MechanismRig.h"

namespace palpate::test
{

/// Makes the lever a mechanism of the product.
inline void addLever(MechanismRig& rig, const NeedleLever& lever)
{
  rig.grip = { lever.coupling_N_per_m, lever.turning_Nm_per_rad };
  for (int i = 0; i < 2; ++i)
  {
    const Vec3 hole_W(0.0, 0.0, lever.place_m[i]);
    const std::string name = i == 0 ? "wall" : "organ";
    rig.addSoft(name, springWall(name, hole_W, -Vec3::UnitZ(), 0.02, 1.0 / lever.stiffness_N_per_m[i]));
    rig.join(ConstraintKind::Insertion, name, Vec3::Zero(), hole_W);
  }
}

/// The lever alone.
class LeverRig
{
public:
  explicit LeverRig(const NeedleLever& lever) { addLever(this->rig_, lever); }

  /// One tick: forces of wall and organ [N].
  NeedleLever::Two force_N(double hand_m)
  {
    const MechanismResult& r = this->rig_.step(Vec3(0.0, hand_m, 0.0));
    return { r.laws[0].force_W.y(), r.laws[1].force_W.y() };
  }

private:
  MechanismRig rig_;
};

} // namespace palpate::test
