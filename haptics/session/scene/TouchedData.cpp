// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/TouchedData.h"

#include "haptics/contact/view/PlanFor.h"
#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/session/PlanText.h"

namespace palpate
{
namespace
{

LineSurface refused(std::string problem)
{
  LineSurface surface;
  surface.problem = std::move(problem);
  return surface;
}

} // namespace

LineSurface tubesOf(const TouchedLines& lines, double tubeRadius_u)
{
  if (std::string many = refuseSegments(lines.segments->triangles.size()); !many.empty())
  {
    return refused(std::move(many));
  }
  return { SurfaceInput{ lines.name + " (lines)", lines.segments, Material(), lines.fields, {}, tubeRadius_u } };
}

LineSurface wallsAcross(const TouchedLines& lines, double ballRadius_u, const std::optional<Pose>& plane_WP)
{
  if (std::string many = refuseSegments(lines.segments->triangles.size()); !many.empty())
  {
    return refused(std::move(many));
  }
  const std::optional<Pose> plane = plane_WP ? plane_WP : planeOf(*lines.segments);
  if (!plane)
  {
    return refused("its lines lie in no plane; give a line radius above 0 to touch them as tubes");
  }
  const PlaneCurves found = curvesInPlane(*lines.segments, *plane);
  if (!found.refusal.empty())
  {
    return refused(found.refusal);
  }
  LineSurface walls{ SurfaceInput{}, plane };
  walls.input->name = lines.name + " (walls)";
  walls.input->mesh =
    std::make_shared<const TriangleMesh>(raiseWalls(found.curves, wallHalfHeight(found.curves, ballRadius_u), *plane));
  return walls;
}

WholeScene wholeScene(const std::vector<SurfaceInput>& inputs, unsigned workers)
{
  SceneBuildResult built = SceneBuilder(workers).build(inputs);
  WholeScene whole;
  whole.scene = std::move(built.scene);
  whole.reports = std::move(built.reports);
  for (const SurfaceReport& report : whole.reports)
  {
    if (!report.refusal.empty())
    {
      whole.scene.reset();
      whole.refused = report.name;
      whole.refusal = report.refusal;
      break;
    }
  }
  return whole;
}

ChosenBall chooseBall(const Scene& scene, const ContactPlan& asked, bool keepLimit)
{
  ChosenBall ball{ asked, radiusLimit(scene, planFor(scene, asked)) };
  ball.plan.radius_u = chosenRadius_u(asked.radius_u, ball.limit.largest_u, keepLimit);
  return ball;
}

} // namespace palpate
