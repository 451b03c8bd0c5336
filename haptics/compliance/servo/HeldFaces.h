// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "haptics/compliance/servo/SoftSurfaceRef.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// The triangles of a surface with three fixed vertices: they do not move under any force. `held`: of
/// each vertex. Clean; null where there are none.
[[nodiscard]] std::shared_ptr<const TriangleMesh> heldFaces(const TriangleMesh& surface, const std::vector<bool>& held);

/// The fixed faces that stop a ball. Null without such faces.
[[nodiscard]] std::shared_ptr<const Scene> sceneOfHeld(const TriangleMesh& faces);

/// Stops the ball of a tick at the fixed faces of the body that it sinks into. The contacts end at the body's free
/// surface, so they do not include faces behind it. On the path from `core_W`, where the ball is among the free
/// surfaces, to its position in W, the ball slides along such faces without friction. The force is the coupling's, as
/// without them; the contacts' forces stay as they are. Keeps nothing from tick to tick, so that no ball is ever left
/// behind a face.
void stopAtHeldFaces(
  const Scene& held, const ContactPlan& plan, const Vec3& core_W, const Vec3& p_W, SoftResult& moved) noexcept;

} // namespace palpate
