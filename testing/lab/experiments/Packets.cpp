// SPDX-License-Identifier: GPL-3.0-or-later
// Row 40: a hand outruns the vertices that a snapshot has compliance of: the servo's compliance for those outside.
#include <algorithm>
#include <cmath>

#include "haptics/compliance/snapshot/SnapshotMaker.h"
#include "testing/haptics/compliance/Blocks.h"
#include "testing/lab/Experiments.h"

namespace palpate::lab
{
namespace packets_experiment
{

constexpr double coupling_N_per_m = 1000.0;
constexpr double period_s = 0.04;

struct Pad
{
  SoftBodyResult made;
  SoftSurface surface;

  explicit Pad(int n)
  {
    SoftBodyInput input = test::pad(n);
    input.element = ElementKind::Linear;
    input.model = ElasticModel::Linear;
    this->made = makeSoftBody(input);
    this->surface = makeSoftSurface(*this->made.body, this->made.checked.mesh, 2.0);
  }

  [[nodiscard]] std::uint32_t vertexAt(const Vec3& p_W) const
  {
    const auto closer = [&p_W](const Vec3& a, const Vec3& b) { return (a - p_W).norm() < (b - p_W).norm(); };
    const std::vector<Vec3>& places_W = this->surface.rest_W;
    return static_cast<std::uint32_t>(std::min_element(places_W.begin(), places_W.end(), closer) - places_W.begin());
  }

  [[nodiscard]] double complianceAt(std::uint32_t vertex) const
  {
    const std::vector<std::uint32_t> one{ vertex };
    return this->made.body->compliance(this->surface.map.columnsOf(one))(2, 2);
  }
};

/// Force of a given depth, over the depth.
double forceOf(double compliance_m_per_N)
{
  return 1.0 / (1.0 / coupling_N_per_m + compliance_m_per_N);
}

/// RMS error of the force over that of the whole body, while a snapshot is one to two periods old that was asked for
/// when the hand was at rest: it knows nothing of the speed.
struct Error
{
  double nearest = 0.0;
  double rigid = 0.0;
};

Error errorAt(const Pad& pad, double speed)
{
  const Vec3 start_W(0.02, 0.05, 0.05);
  SnapshotRequest request;
  request.ball_W = start_W;
  request.radius_u = 0.005;
  request.period_s = period_s;
  const auto snapshot = SnapshotMaker(*pad.made.body, pad.surface).make(request);
  double nearest2 = 0.0;
  double rigid2 = 0.0;
  double all2 = 0.0;
  constexpr int ticks = 40;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const std::uint32_t at = pad.vertexAt(start_W + Vec3(speed * period_s * (1.0 + (tick + 0.5) / ticks), 0.0, 0.0));
    const double truth = forceOf(pad.complianceAt(at));
    const bool has = std::find(snapshot->near.begin(), snapshot->near.end(), at) != snapshot->near.end();
    const double taken = forceOf(snapshot->between(at, at)(2, 2));
    nearest2 += std::pow(taken - truth, 2);
    rigid2 += std::pow((has ? taken : coupling_N_per_m) - truth, 2);
    all2 += truth * truth;
  }
  return { std::sqrt(nearest2 / all2), std::sqrt(rigid2 / all2) };
}

} // namespace packets_experiment

void runPackets(const Conditions& conditions, Table& table)
{
  using namespace packets_experiment;
  const Pad pad(conditions.pick(12, 12, 16));
  for (const double speed : { 0.3, 0.6, 0.9 })
  {
    const std::string name = caseName({ { "speed", speed }, { "period_ms", 1e3 * period_s } });
    const Error error = errorAt(pad, speed);
    // At .9 m/s it comes to the border of the pad, which nothing inside answers like.
    const Subject nearest{ name, "nearest vertex", "RMS error of the force" };
    speed < 0.8 ? table.atMost(nearest, error.nearest, 0.03) : table.info(nearest, error.nearest);
    const Subject rigid{ name, "rigid outside", "RMS error of the force" };
    speed > 0.5 ? table.atLeast(rigid, error.rigid, 0.3) : table.info(rigid, error.rigid);
  }
}

} // namespace palpate::lab
