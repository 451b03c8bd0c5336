// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/snapshot/SoftSurface.h"
#include "testing/haptics/compliance/Blocks.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// The pad of Blocks.h in metres, four cells along it.
inline SoftBodyInput softBlock(ElasticModel model)
{
  SoftBodyInput input = pad(4);
  input.model = model;
  return input;
}

/// The same, eight cells along it, with vertices up to 1 mm above and below its top at random.
inline SoftBodyInput bumpyBlock(ElasticModel model)
{
  SoftBodyInput input = pad(8);
  input.model = model;
  Random random(testSeed(281));
  for (Vec3& p : input.mesh.vertices_W)
  {
    p.z() += p.z() == 0.05 ? random.uniform(-0.001, 0.001) : 0.0;
  }
  return input;
}

/// How far a force may be from the spring's between two places: proxy and device are rounded, one part in 2^53 each.
inline double roundingOfSpring_N(double stiffness_N_per_m, double place_u, double force_N)
{
  return 1e-12 * force_N + 4e-16 * stiffness_N_per_m * place_u;
}

inline Vec3 topOfBlock()
{
  return { 0.05, 0.05, 0.05 };
}

/// Compliance of the vertex in the middle of the top along z [m/N], by a solve with the whole stiffness of the block at
/// rest.
inline double yieldOfTop()
{
  SoftBodyResult made = makeSoftBody(softBlock(ElasticModel::Linear));
  const SoftSurface surface = makeSoftSurface(*made.body, made.checked.mesh);
  std::size_t top = 0;
  for (std::size_t v = 0; v < surface.rest_W.size(); ++v)
  {
    top = (surface.rest_W[v] - topOfBlock()).norm() < (surface.rest_W[top] - topOfBlock()).norm() ? v : top;
  }
  Eigen::VectorXd load = Eigen::VectorXd::Zero(made.body->displacement().size());
  surface.map.addForce(top, Vec3::UnitZ(), load);
  return surface.map.displacementOf(top, made.body->linearAnswer(load)).z();
}

} // namespace palpate::test
