// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/methods/ContactMethod.h"

#include <algorithm>
#include <stdexcept>

#include "testing/lab/backends/Peers.h"
#include "testing/lab/methods/GodObjectMethod.h"
#include "testing/lab/methods/Textbook.h"
#include "testing/support/Meshes.h"

namespace palpate::lab
{
namespace
{

MethodKind godObject(const std::string& name, double radius_m)
{
  return { name, radius_m,
    [radius_m](const World& world) { return std::make_unique<GodObjectMethod>(world, radius_m); } };
}

MethodKind onEmbree()
{
  return { "textbook-loop on Embree", 0.0, embreeRays() != nullptr ? makeTextbookLoopOnEmbree : nullptr };
}

MethodKind onBullet(double radius_m)
{
  const MakeBall make = bulletBall();
  MethodKind kind{ "Bullet's sweeps r=1mm", radius_m, {} };
  if (make != nullptr)
  {
    kind.make = [make, radius_m](const World& world) { return make(world, radius_m); };
  }
  return kind;
}

} // namespace

World::World(const TriangleMesh& mesh_, double metre_u_)
  : mesh(std::make_shared<const TriangleMesh>(mesh_)), faces(std::make_shared<const FaceTree>(mesh_)),
    scene(test::sceneOf(mesh_)), metre_u(metre_u_)
{
}

const std::vector<MethodKind>& methods()
{
  static const std::vector<MethodKind> all = {
    godObject("god-object r=0", 0.0),
    godObject("god-object r=1mm", 1e-3),
    { "penalty", 0.0, makePenalty },
    { "half-spaces", 0.0, makeHalfSpaces },
    { "one-constraint", 0.0, makeOneConstraint },
    { "alternating", 0.0, makeAlternating },
    { "point-no-side", 0.0, makePointWithoutSide },
    { "textbook-loop", 0.0, makeTextbookLoop },
    { "held-60Hz", 0.0, makeHeld },
    onEmbree(),
    onBullet(1e-3),
  };
  return all;
}

const MethodKind& method(const std::string& name)
{
  const auto& all = methods();
  const auto found =
    std::find_if(all.begin(), all.end(), [&name](const MethodKind& kind) { return kind.name == name; });
  if (found == all.end())
  {
    throw std::out_of_range("no method is called " + name);
  }
  return *found;
}

} // namespace palpate::lab
