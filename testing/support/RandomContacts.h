// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

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

/// By how much forces miss the laws of Signorini and Coulomb: judged from the laws alone [u].
[[nodiscard]] inline double missed(const ContactProblem& p, const ContactProblem::Numbers& f)
{
  double most = 0.0;
  const Eigen::VectorXd d = Eigen::VectorXd(p.free) + Eigen::MatrixXd(p.compliance) * Eigen::VectorXd(f);
  for (int c = 0; c < p.count; ++c)
  {
    const Vec3 force = f.segment<3>(3 * c);
    const Vec3 moved = d.segment<3>(3 * c);
    const double across = force.tail<2>().norm();
    const double slip = moved.tail<2>().norm();
    most = std::max({ most, -moved[0], -force[0], across - p.friction * force[0], std::abs(force[0] * moved[0]) });
    if (across < p.friction * force[0] * (1.0 - 1e-9))
    {
      most = std::max(most, slip); // it sticks
    }
    else if (force[0] > 0.0)
    {
      // It slips against its force.
      most = std::max(most, (force.tail<2>() * slip + moved.tail<2>() * across).norm() / across);
    }
  }
  return most;
}

} // namespace palpate::test
