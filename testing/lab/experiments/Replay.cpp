// SPDX-License-Identifier: GPL-3.0-or-later
// Row 55: a recording with scene swaps, computed again, gives the same bits whatever number of workers builds its
// scenes.
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "devices/FedDevice.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LoopReport.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::lab
{
namespace replay_experiment
{

void demand(const std::string& problem)
{
  if (!problem.empty())
  {
    throw std::runtime_error(problem);
  }
}

std::shared_ptr<const Scene> threeSpheres(SceneBuilder& builder, int levels)
{
  std::vector<SurfaceInput> inputs;
  for (int i = 0; i < 3; ++i)
  {
    const TriangleMesh sphere = test::shifted(test::makeIcosphere(levels, 0.05), Vec3(0.08 * i, 0, 0));
    inputs.push_back({ "sphere " + std::to_string(i), std::make_shared<TriangleMesh>(sphere), {} });
  }
  return builder.build(inputs).scene;
}

/// A hand that strokes the middle one of three overlapping spheres with a tremor of its own.
Vec3 handAt(int tick, test::Random& random)
{
  const double t_s = 1e-3 * tick;
  const Vec3 tremor = random.inCube(2e-5);
  return tick == 0 ? Vec3(0.08, 0, 0.07)
                   : Vec3(Vec3(0.08 + 0.012 * std::sin(0.7 * t_s), 0.01 * std::sin(5 * t_s), 0.047) + tremor);
}

/// In virtual time; every 200 ticks another scene, once other parameters. Returns how many ticks touched.
double record(const std::string& path, int ticks, double radius_m, std::uint64_t seed)
{
  SceneBuilder builder;
  const auto coarse = threeSpheres(builder, 3), fine = threeSpheres(builder, 4);
  test::Random random(seed);
  HapticSession session;
  HapticParameters parameters;
  parameters.contact.radius_u = radius_m;
  demand(session.setParameters(parameters));
  session.setScene(coarse);
  SessionOptions options;
  options.virtualTime = true;
  options.recordFile = path;
  demand(session.start(std::make_unique<FedDevice>(), options));
  for (int tick = 0; tick < ticks; ++tick)
  {
    DeviceSample sample;
    sample.pose_D.p = handAt(tick, random);
    static_cast<FedDevice*>(session.device())->feed(sample);
    if (tick % 200 == 199)
    {
      session.setScene(tick % 400 == 399 ? coarse : fine);
    }
    if (tick == ticks / 2)
    {
      parameters.stiffness_N_per_m = 700.0;
      demand(session.setParameters(parameters));
    }
    (void)session.step(1);
  }
  const auto touched = static_cast<double>(session.report().contactTicks);
  demand(session.stop());
  return touched;
}

Recording recorded(const std::string& path)
{
  auto read = readRecording(path);
  if (const auto* problem = std::get_if<std::string>(&read))
  {
    throw std::runtime_error(*problem);
  }
  return std::get<Recording>(std::move(read));
}

/// One bit of one force changed: a comparison must see it.
Recording tampered(Recording recording)
{
  for (auto entry = recording.entries.rbegin(); entry != recording.entries.rend(); ++entry)
  {
    if (auto* tick = std::get_if<TickRecord>(&*entry))
    {
      tick->wrench_D.force.z() = std::nextafter(tick->wrench_D.force.z(), 1e9);
      return recording;
    }
  }
  throw std::runtime_error("a recording without ticks");
}

} // namespace replay_experiment

void runReplay(const Conditions& conditions, Table& table)
{
  using namespace replay_experiment;
  const int ticks = conditions.pick(4000, 60000, 60000);
  for (const double radius_m : { 0.0, 1e-3 })
  {
    const test::TemporaryFolder folder;
    const std::string file = folder.file("recording.palpate");
    const std::string name = caseName({ { "r", 1e3 * radius_m }, { "seconds", 1e-3 * ticks } });
    const double touched = record(file, ticks, radius_m, conditions.seed);
    table.atLeast({ name, "god-object", "ticks in contact" }, touched, 0.5 * ticks);
    const Recording recording = recorded(file);
    for (const unsigned workers : { 1U, 2U, 4U })
    {
      const std::string method = "replay, workers=" + std::to_string(workers);
      const ReplayResult result = replay(recording, {}, workers);
      demand(result.problem);
      table.within({ name, method, "ticks computed again" }, static_cast<double>(result.ticks), ticks, 0.0);
      table.within({ name, method, "recordings differ" }, result.difference.empty() ? 0.0 : 1.0, 0.0, 0.0);
    }
    const ReplayResult other = replay(tampered(recording));
    table.atLeast(
      { name, "replay of one bit changed", "recordings differ" }, other.difference.empty() ? 0.0 : 1.0, 1.0);
    conditions.progress(radius_m == 0.0 ? 0.5 : 1.0);
  }
}

} // namespace palpate::lab
