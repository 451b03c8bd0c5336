// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/servo/HeldFaces.h"

#include <algorithm>
#include <iterator>

#include "haptics/contact/GodObject.h"

namespace palpate
{

std::shared_ptr<const TriangleMesh> heldFaces(const TriangleMesh& surface, const std::vector<bool>& held)
{
  TriangleMesh faces{ surface.vertices_W, {} };
  std::ranges::copy_if(surface.triangles, std::back_inserter(faces.triangles),
    [&held](const auto& t) { return std::ranges::all_of(t, [&held](std::uint32_t v) { return held[v]; }); });
  CleanResult clean = cleanMesh(faces); // leaves out vertices without such a triangle
  return clean.mesh.triangles.empty() ? nullptr : std::make_shared<const TriangleMesh>(std::move(clean.mesh));
}

std::shared_ptr<const Scene> sceneOfHeld(const TriangleMesh& faces)
{
  CleanResult clean = cleanMesh(faces);
  if (clean.mesh.triangles.empty())
  {
    return nullptr;
  }
  Surface found;
  found.name = "held";
  found.tree = std::make_shared<const SurfaceTree>(std::move(clean.mesh));
  return std::make_shared<const Scene>(1, std::vector<Surface>{ std::move(found) });
}

void stopAtHeldFaces(
  const Scene& held, const ContactPlan& plan, const Vec3& core_W, const Vec3& p_W, SoftResult& moved) noexcept
{
  constexpr double rounding = 1e-9; // of the path
  ContactPlan rest = plan;
  rest.friction = FrictionPlan{};
  rest.shading = false;
  rest.workBudget -= std::min(plan.workBudget, moved.work);
  GodObjectState ball;
  ball.x_W = ball.device_W = core_W;
  ball.placed = true;
  const ContactResult stopped = moveGodObject(held, rest, moved.proxy_W, ball);
  moved.work += stopped.work;
  moved.capped = moved.capped || stopped.capped;
  moved.overBudget = moved.overBudget || stopped.overBudget;
  if ((ball.x_W - moved.proxy_W).norm() > rounding * (moved.proxy_W - core_W).norm())
  {
    moved.proxy_W = ball.x_W;
    moved.force_N = plan.coupling_N_per_m * (ball.x_W - p_W);
  }
}

} // namespace palpate
