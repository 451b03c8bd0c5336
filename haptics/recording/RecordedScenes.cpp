// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordedScenes.h"

#include <cmath>
#include <optional>
#include <utility>

#include "haptics/recording/RecordingLayout.h"

namespace palpate
{
namespace
{

std::vector<double> readNumbers(ByteReader& in)
{
  std::vector<double> numbers(in.count(sizeof(double)));
  for (double& number : numbers)
  {
    in.get(number);
  }
  return numbers;
}

std::shared_ptr<const MaterialFields> readFields(ByteReader& in)
{
  auto fields = std::make_shared<MaterialFields>();
  for (std::vector<double>* const field :
    { &fields->stiffness_N_per_m, &fields->frictionStatic, &fields->frictionKinetic, &fields->height_u })
  {
    *field = readNumbers(in);
  }
  return fields->empty() ? nullptr : fields;
}

std::shared_ptr<const VertexStart> readStart(ByteReader& in)
{
  std::uint64_t continues = 0;
  in.get(continues);
  std::vector<Vec3> vertices_W(in.count(3 * sizeof(double)));
  for (Vec3& v : vertices_W)
  {
    in.get(v);
  }
  return vertices_W.empty() ? nullptr : std::make_shared<const VertexStart>(std::move(vertices_W), continues);
}

} // namespace

RecordedScene readScene(ByteReader& in)
{
  RecordedScene scene;
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
    mesh->vertices_W.resize(in.count(3 * sizeof(double)));
    for (Vec3& v : mesh->vertices_W)
    {
      in.get(v);
    }
    mesh->triangles.resize(in.count(3 * sizeof(std::uint32_t)));
    for (auto& t : mesh->triangles)
    {
      for (std::uint32_t& corner : t)
      {
        in.get(corner);
      }
    }
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
    if (!std::isfinite(standsFor.bound_u) || standsFor.bound_u < 0.0)
    {
      in.fail();
    }
  }
  return scene;
}

RecordedMotion readMotion(ByteReader& in)
{
  RecordedMotion motion;
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
  return motion;
}

} // namespace palpate
