// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/inputs/Scenes.h"

#include <cmath>
#include <optional>
#include <utility>

namespace palpate::input
{
namespace
{

std::shared_ptr<const MaterialFields> readFields(ByteReader& in)
{
  auto fields = std::make_shared<MaterialFields>();
  for (std::vector<double>* const field :
    { &fields->stiffness_N_per_m, &fields->frictionStatic, &fields->frictionKinetic, &fields->height_u })
  {
    in.get(*field);
  }
  return fields->empty() ? nullptr : fields;
}

std::shared_ptr<const VertexStart> readStart(ByteReader& in)
{
  std::uint64_t continues = 0;
  in.get(continues);
  std::vector<Vec3> vertices_W;
  in.get(vertices_W);
  return vertices_W.empty() ? nullptr : std::make_shared<const VertexStart>(std::move(vertices_W), continues);
}

} // namespace

void Scenes::read(ByteReader& in, Recorded& recorded)
{
  RecordedScene& scene = recorded.scenes.emplace_back();
  in.get(scene.geometryHash);
  const std::uint64_t surfaces = in.count(1);
  for (std::uint64_t s = 0; s < surfaces && in.ok(); ++s)
  {
    SurfaceInput input;
    auto mesh = std::make_shared<TriangleMesh>();
    in.get(input.name);
    layMaterial(Get{ in }, input.material);
    input.fields = readFields(in);
    double lineRadius_u = 0.0; // 0: triangles
    in.get(lineRadius_u);
    input.lineRadius_u = lineRadius_u != 0.0 ? std::optional(lineRadius_u) : std::nullopt;
    in.get(mesh->vertices_W);
    in.get(mesh->triangles);
    input.mesh = std::move(mesh);
    input.ordered = true;
    scene.surfaces.push_back(std::move(input));
  }
  const bool standIns = in.ok() && in.left() != 0;
  for (std::size_t s = 0; standIns && s < scene.surfaces.size(); ++s)
  {
    StandIn& standsFor = scene.surfaces[s].standsFor;
    in.get(standsFor.full);
    in.get(standsFor.bound_u);
    in.failUnless(std::isfinite(standsFor.bound_u) && standsFor.bound_u >= 0.0);
  }
}

void Scenes::readMotion(ByteReader& in, Recorded& recorded)
{
  RecordedMotion& motion = recorded.motions.emplace_back();
  in.get(motion.contentHash);
  in.get(motion.geometryHash);
  in.get(motion.motion_s);
  motion.motions.resize(in.count(2 * 7 * sizeof(double) + 2 * sizeof(std::uint64_t)));
  for (RigidMotion& m : motion.motions)
  {
    in.get(m.begin_WS);
    in.get(m.end_WS);
    motion.starts.push_back(readStart(in));
  }
}

} // namespace palpate::input
