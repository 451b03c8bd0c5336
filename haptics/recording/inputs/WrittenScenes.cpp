// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "haptics/recording/inputs/Scenes.h"

namespace palpate::input
{
namespace
{

void putFields(const MaterialFields* fields, ByteWriter& payload)
{
  const MaterialFields none;
  const MaterialFields& f = fields != nullptr ? *fields : none;
  for (const std::vector<double>* const field :
    { &f.stiffness_N_per_m, &f.frictionStatic, &f.frictionKinetic, &f.height_u })
  {
    payload.put(*field);
  }
}

void putStart(const VertexStart* start, ByteWriter& payload)
{
  payload.put(start != nullptr ? start->continues : std::uint64_t{ 0 });
  payload.put(start != nullptr ? start->vertices_W : std::vector<Vec3>());
}

/// At the end, and only where there are any.
void putStandIns(const std::vector<Surface>& surfaces, ByteWriter& payload)
{
  if (std::any_of(surfaces.begin(), surfaces.end(), [](const Surface& s) { return s.standsFor.full != 0; }))
  {
    for (const Surface& surface : surfaces)
    {
      payload.put(surface.standsFor.full);
      payload.put(surface.standsFor.bound_u);
    }
  }
}

} // namespace

void Scenes::write(ByteWriter& payload, const Scene& scene)
{
  payload.put(scene.geometryHash());
  payload.put(static_cast<std::uint64_t>(scene.surfaces().size()));
  for (const Surface& surface : scene.surfaces())
  {
    const TriangleMesh& mesh = surface.tree->mesh();
    payload.put(surface.name);
    layMaterial(Put{ payload }, surface.material);
    putFields(surface.fields.get(), payload);
    payload.put(surface.tree->coat_u());
    payload.put(mesh.vertices_W);
    payload.put(mesh.triangles);
  }
  putStandIns(scene.surfaces(), payload);
}

void Scenes::writeMotion(ByteWriter& payload, const Scene& scene)
{
  payload.put(scene.contentHash());
  payload.put(scene.geometryHash());
  payload.put(scene.motion_s());
  payload.put(static_cast<std::uint64_t>(scene.surfaces().size()));
  for (const Surface& surface : scene.surfaces())
  {
    payload.put(surface.motion.begin_WS);
    payload.put(surface.motion.end_WS);
    putStart(surface.from.get(), payload);
  }
}

} // namespace palpate::input
