// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/geometry/scene/SceneMotion.h"
#include "testing/haptics/recording/FixtureSessions.h"
#include "testing/haptics/recording/RecordedTicks.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

/// An icosphere of 50 mm, wider by `growth` along x.
SurfaceInput sphere(double growth)
{
  TriangleMesh mesh = makeIcosphere(2, 0.05);
  for (Vec3& v : mesh.vertices_W)
  {
    v.x() *= 1.0 + growth;
  }
  SurfaceInput input{ "sphere", std::make_shared<const TriangleMesh>(std::move(mesh)), {} };
  input.material.frictionStatic = 0.5;
  input.material.frictionKinetic = 0.3;
  return input;
}

/// The same with hills of 0.3 mm.
SurfaceInput rough()
{
  SurfaceInput input = sphere(0.0);
  MaterialFields fields;
  for (std::size_t i = 0; i < input.mesh->vertices_W.size(); ++i)
  {
    fields.height_u.push_back(1e-4 * static_cast<double>(i % 4));
  }
  input.fields = std::make_shared<const MaterialFields>(std::move(fields));
  return input;
}

/// Rolls by a degree while it sinks by 1 mm, within 30 ms.
std::shared_ptr<const Scene> rolling(const Scene& still)
{
  std::vector<Surface> surfaces = still.surfaces();
  surfaces.front().motion.end_WS = { Vec3(0.0, 0.0, -0.001), Quat(Eigen::AngleAxisd(0.0175, Vec3::UnitX())) };
  return std::make_shared<const Scene>(still.revision() + 1, std::move(surfaces), 0.03);
}

HapticParameters firstParameters()
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = 800.0;
  parameters.damping_Ns_per_m = 1.5;
  parameters.stiffnessLimit_N_per_m = 700.0;
  parameters.passivity = { true, 1.0, 0.5, 1.0 };
  parameters.velocity.resolution_m = 1e-5;
  parameters.contact.friction = { 0.4, 0.25 };
  parameters.safety.engageRamp_s = 0.02;
  parameters.map.q_WD = Quat(Eigen::AngleAxisd(0.2, Vec3(1.0, 2.0, 3.0).normalized()));
  return parameters;
}

HapticParameters withBall()
{
  HapticParameters parameters = firstParameters();
  parameters.contact.radius_u = 0.002;
  parameters.contact.shading = true;
  parameters.velocity.method = VelocityMethod::LowPass;
  return parameters;
}

/// Down on the sphere, then to and fro on it but for a rest of ten ticks, in W.
Vec3 handAt(int tick)
{
  const double s = 0.002 * (tick < 34 ? tick : std::max(34, tick - 10));
  return { 0.012 * std::sin(9.0 * s), 0.004 * std::sin(23.0 * s), std::max(0.0475, 0.056 - 0.0007 * tick) };
}

/// Faults of a tick: samples that are no numbers at 40, 42 and 43, a late loop, a device that waits, and one that is
/// gone.
void disturb(int tick, RecordedTicks& ticks)
{
  ticks.status = tick == 74 ? DeviceStatus::Waiting : tick >= 96 ? DeviceStatus::Lost : DeviceStatus::Ok;
  ticks.lateness.stiffnessFactor = tick >= 66 && tick < 70 ? 0.5 : 1.0;
  ticks.lateness.fault = tick == 84 ? Fault::LateServo : Fault::None;
  ticks.sample.pose_D.q.x() = tick == 40 || tick == 42 || tick == 43 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
}

void tell(int tick, RecordedTicks& ticks)
{
  if (tick == 2 || tick == 48 || tick == 88)
  {
    ticks.push(EventKind::Engage);
  }
  if (tick == 78)
  {
    ticks.push(EventKind::Mark);
    ticks.push(EventKind::Release);
    ticks.push(EventKind::Engage);
  }
}

} // namespace

std::string recordSolid(const std::string& path)
{
  constexpr int ticksInAll = 100;
  SceneBuilder builder;
  const auto first = builder.build({ rough() }).scene;
  const auto second = builder.build({ sphere(0.0) }, first.get()).scene;
  const auto wide = builder.build({ sphere(0.02) }, second.get()).scene;
  const HapticParameters parameters = firstParameters();
  RecordedTicks ticks(path, parameters);
  for (int tick = 1; tick <= ticksInAll; ++tick)
  {
    if (tick == 1 || tick == 30)
    {
      ticks.setScene(tick == 1 ? first : second);
    }
    if (tick == 22)
    {
      ticks.setParameters(withBall());
    }
    if (tick == 52)
    {
      ticks.setScene(movingFrom(*second, 1.0, wide, 0.02));
    }
    if (tick == 62)
    {
      ticks.setScene(rolling(*wide));
    }
    tell(tick, ticks);
    disturb(tick, ticks);
    ticks.tickAt(parameters.map.toDevice(handAt(tick)));
  }
  return ticks.close();
}

} // namespace palpate::test
