// SPDX-License-Identifier: GPL-3.0-or-later
// Records a hand that slides over the square of palpate_cli.py, then over a second one that replaces it, in virtual
// time: make-recording FILE. Or one that draws a rod off its attachment with 0.5 N: make-recording FILE mechanism.
#include <iostream>
#include <memory>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/session/SessionWorkers.h"

using namespace palpate;

namespace
{
std::shared_ptr<const Scene> square(double height_u)
{
  TriangleMesh mesh;
  mesh.vertices_W = { { -8, -8, height_u }, { 8, -8, height_u }, { 8, 8, height_u }, { -8, 8, height_u } };
  mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  return SceneBuilder().build({ { "square", std::make_shared<const TriangleMesh>(mesh), Material() } }).scene;
}

/// A rod that is glued to the world where the hand is at first.
MechanismChoice glued(const Vec3& at_W)
{
  auto inputs = std::make_shared<MechanismInputs>();
  inputs->unit_m = 0.001;
  MechanismBody rod, world;
  rod.name = "rod";
  rod.kind = MechanismBodyKind::Held;
  rod.length_u = 20.0;
  rod.diameter_u = 1.0;
  world.name = "world";
  MechanismConstraint glue;
  glue.name = "glue";
  glue.kind = ConstraintKind::Break;
  glue.a = rod.name;
  glue.b = world.name;
  glue.point_B = at_W;
  glue.strength_N = 0.5;
  inputs->mechanism = { { rod, world }, { glue } };
  return { inputs, "glued" };
}

/// Empty, or the fault.
std::string record(const std::string& file, bool mechanism)
{
  HandPath path;
  path.points_D = { { 0.0, 0.0, 0.01 }, { 0.0, 0.0, -0.005 }, { 0.05, 0.02, -0.005 } };
  HapticSession session;
  session.setScene(square(0.0));
  if (mechanism)
  {
    session.choose<MechanismTask>(glued(session.parameters().map.scale_u_per_m * path.points_D.front()));
  }
  SessionOptions options;
  options.virtualTime = true;
  options.recordFile = file;
  std::string problem = session.start(
    std::make_unique<SimulatedDevice>(*deviceModel("simulated-generic"), *handModel("stylus"), path), options);
  if (!problem.empty())
  {
    return problem;
  }
  session.step(1000);
  session.mark();
  session.setScene(square(-0.25));
  session.step(1000);
  return session.stop();
}
} // namespace

int main(int argc, char** argv)
{
  const bool mechanism = argc == 3 && std::string(argv[2]) == "mechanism";
  const std::string problem =
    argc == 2 || mechanism ? record(argv[1], mechanism) : "one argument is needed: the file to write";
  std::cerr << problem;
  return problem.empty() ? 0 : 1;
}
