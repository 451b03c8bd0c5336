// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/ContactProblem.h"
#include "haptics/core/PoseMath.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// n contacts of random places, normals and depths on a body of random compliance that the device's is added to [u/N].
inline void makeRandomContacts(Random& random, int n, ContactProblem& problem)
{
  Eigen::MatrixXd spread(3 * n, 6 * n);
  Eigen::MatrixXd turns(3 * n, 3);
  for (int c = 0; c < n; ++c)
  {
    for (int k = 0; k < 6 * n; ++k)
    {
      spread.block<3, 1>(3 * c, k) = random.inCube(1.0);
    }
    const Quat q = shortestTurn(Vec3(Vec3::UnitX()), (Vec3::UnitZ() + random.direction() * 0.8).normalized());
    turns.block<3, 3>(3 * c, 0) = q.toRotationMatrix().transpose();
  }
  problem.resize(n);
  problem.friction = 0.5;
  problem.compliance = spread * spread.transpose() / (6.0 * n) + turns * turns.transpose();
  problem.compliance = (0.5 * (problem.compliance + problem.compliance.transpose())).eval();
  for (int c = 0; c < n; ++c)
  {
    problem.free.segment<3>(3 * c) = Vec3(random.uniform(-1.0, 0.4), random.uniform(-1, 1), random.uniform(-1, 1));
  }
}

} // namespace palpate::test
