// SPDX-License-Identifier: GPL-3.0-or-later
// Records a hand that slides over the square of palpate_cli.py, then over a second one that replaces it, in virtual
// time: make-recording FILE.
#include <iostream>
#include <memory>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/session/HapticSession.h"

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

/// Empty, or what went wrong.
std::string record(const std::string& file)
{
  HandPath path;
  path.points_D = { { 0.0, 0.0, 0.01 }, { 0.0, 0.0, -0.005 }, { 0.05, 0.02, -0.005 } };
  HapticSession session;
  session.setScene(square(0.0));
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
  const std::string problem = argc == 2 ? record(argv[1]) : "one argument is needed: the file to write";
  std::cerr << problem;
  return problem.empty() ? 0 : 1;
}
