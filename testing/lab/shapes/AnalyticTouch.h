// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/lab/Table.h"
#include "testing/lab/methods/ContactMethod.h"
#include "testing/support/Random.h"

namespace palpate::lab
{

/// A moment of a touch recorded on a smooth body: the ball's centre and its force.
struct TouchMoment
{
  Vec3 centre_W = Vec3::Zero(); ///< [m]
  Vec3 force_N = Vec3::Zero();  ///< on the hand, in the normal cone of the body there, or in its friction cone
  double pressed_N = 0.0;       ///< sum of the reactions of the surfaces that are touched
};

/// A touch of a body known by a formula, frictionless unless stroked, and the body as a mesh. In metres, 20 to 150
/// mm/s, 0.6 to 1.4 N.
struct AnalyticTouch
{
  std::string name;
  TriangleMesh mesh;
  double tilt_rad = 0.0; ///< by how much a facet's normal differs from the body's, at most
  std::function<TouchMoment(double t_s, double radius_m)> at;
};

[[nodiscard]] AnalyticTouch touchPlane(test::Random& random);
/// Radius 50 mm, 20 * 4^levels triangles.
[[nodiscard]] AnalyticTouch touchSphere(int levels);
/// The inside of a wedge of 60 degrees, over and over: along the crease with the force turning from wall to wall, a
/// loop over that wall back to where the crease began, along it again with the force turning back, a loop over the
/// first wall. The path has no corner and no reversal: there the friction of a spring needs a displacement of its own
/// to turn round.
[[nodiscard]] AnalyticTouch touchWedge();
/// Radii 40 and 15 mm, `around` times `across` cells of two triangles.
[[nodiscard]] AnalyticTouch touchTorus(std::uint32_t around, std::uint32_t across);

/// The same path on a rough body: with Coulomb friction mu times the reactions, against the motion.
[[nodiscard]] AnalyticTouch rubbed(const AnalyticTouch& smooth, double mu);

/// A touch as a method renders it.
struct RenderedTouch
{
  std::vector<Vec3> truth_N, force_N; ///< tick by tick, 1 ms apart
  Cost cost;
};

/// The protocol of Ruffaldi, Morris, Edmunds, Barbagli & Pai 2006: the recorded path, pushed in by force / stiffness,
/// is where a device would have been; rendered, it must give the recorded force back.
[[nodiscard]] RenderedTouch render(const AnalyticTouch& touch, const MethodKind& method, int ticks);

} // namespace palpate::lab
