// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::lab
{

/// A body as each method asks for it.
struct ToolBody
{
  TriangleMesh mesh;
  std::function<double(const Vec3&)> distance_mm; ///< to its surface, negative inside; outside a lower bound
};

/// Where the distance grows fastest, by differences.
[[nodiscard]] Vec3 outwards(const ToolBody& body, const Vec3& p);

/// A hand that leads a tool to a place whose nearest free pose is known by a formula. In mm.
struct ToolScene
{
  std::string name;
  ToolBody tool_B, scene_W;
  double lever_mm = 1.0; ///< of the metric
  Pose start_W;
  std::vector<Pose> hand_W;    ///< one an update of 1 ms
  Pose truth_W;                ///< where the tool is in the end
  double near_mm = 0.0;        ///< no point of it may be further from there
  Vec3 along_W = Vec3::Zero(); ///< if not zero, only the displacement of its centre in this direction is known
};

/// A cube tipped on a plane, a peg into a slot that is 0.1 mm wider, a bar that is swung at a post, a nut that is
/// turned on its screw and one that is pulled.
[[nodiscard]] std::vector<ToolScene> toolScenes();

} // namespace palpate::lab
