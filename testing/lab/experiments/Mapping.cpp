// SPDX-License-Identifier: GPL-3.0-or-later
// Row 77: maps between models of one body: forces go back by the transpose, or a hand gets torque and energy for
// nothing.
#include <algorithm>
#include <cmath>

#include "haptics/compliance/map/FrameMap.h"
#include "haptics/compliance/map/SurfaceMap.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Random.h"

namespace palpate::lab
{
namespace mapping_experiment
{

/// Errors of a point's force on four corners, against the point itself: the worst of many points and motions.
struct Lost
{
  double force_N = 0.0;
  double torque_Nm = 0.0;
  double power = 0.0; ///< over force times speed
};

using Weights = std::array<double, 4>;

Weights nearest(const TetraMesh& tetra, const Vec3& p_W)
{
  Weights w{};
  const auto closer = [&p_W](const Vec3& a, const Vec3& b) { return (a - p_W).norm() < (b - p_W).norm(); };
  w[static_cast<std::size_t>(
    std::min_element(tetra.vertices_W.begin(), tetra.vertices_W.end(), closer) - tetra.vertices_W.begin())] = 1.0;
  return w;
}

Weights byDistance(const TetraMesh& tetra, const Vec3& p_W)
{
  Weights w{};
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    sum += w[i] = 1.0 / (tetra.vertices_W[i] - p_W).norm();
  }
  std::for_each(w.begin(), w.end(), [sum](double& one) { one /= sum; });
  return w;
}

/// Motion by the barycentric map, force back by `back`, or by the map's transpose where it is null.
Lost lost(const TetraMesh& tetra, Weights (*back)(const TetraMesh&, const Vec3&), std::uint64_t seed)
{
  test::Random random(seed);
  Lost most;
  for (int trial = 0; trial < 1000; ++trial)
  {
    Vec3 p_W = Vec3::Zero();
    double sum = 0.0;
    for (const Vec3& corner : tetra.vertices_W)
    {
      const double w = random.uniform(0.1, 1.0);
      p_W += w * corner;
      sum += w;
    }
    p_W /= sum;
    const Embedding at = embed(tetra, { p_W });
    const Vec3 force_N = random.direction();
    Eigen::VectorXd speed(12);
    Eigen::VectorXd onCorners = Eigen::VectorXd::Zero(12);
    for (int i = 0; i < 4; ++i)
    {
      speed.segment<3>(3 * i) = random.direction();
      onCorners.segment<3>(3 * i) =
        back ? Vec3(back(tetra, p_W)[static_cast<std::size_t>(i)] * force_N) : Vec3(Vec3::Zero());
    }
    if (!back)
    {
      at.map.addForce(0, force_N, onCorners);
    }
    Vec3 left_N = force_N;
    Vec3 turn_Nm = p_W.cross(force_N);
    for (int i = 0; i < 4; ++i)
    {
      left_N -= onCorners.segment<3>(3 * i);
      turn_Nm -= tetra.vertices_W[static_cast<std::size_t>(i)].cross(onCorners.segment<3>(3 * i));
    }
    most.force_N = std::max(most.force_N, left_N.norm());
    most.torque_Nm = std::max(most.torque_Nm, turn_Nm.norm());
    most.power = std::max(most.power, std::abs(force_N.dot(at.map.displacementOf(0, speed)) - onCorners.dot(speed)));
  }
  return most;
}

/// Points that several frames carry: errors of their forces and moments against the points', and of the power.
Lost lostOnFrames(int frames, std::uint64_t seed)
{
  test::Random random(seed);
  std::vector<Vec3> origins_W;
  std::vector<FrameWeight> weights;
  for (int i = 0; i < frames; ++i)
  {
    origins_W.push_back(random.inCube(0.1));
    weights.push_back({ static_cast<std::uint32_t>(i), 1.0 / frames });
  }
  Lost most;
  for (int trial = 0; trial < 1000; ++trial)
  {
    const Vec3 p_W = random.inCube(0.1);
    const Vec3 force_N = random.direction();
    const SurfaceMap map = followFrames(origins_W, { p_W }, { weights });
    Eigen::VectorXd onFrames = Eigen::VectorXd::Zero(6 * frames);
    Eigen::VectorXd speed(6 * frames);
    map.addForce(0, force_N, onFrames);
    Vec3 left_N = force_N;
    Vec3 turn_Nm = p_W.cross(force_N);
    for (int i = 0; i < frames; ++i)
    {
      speed.segment<3>(6 * i) = random.direction();
      speed.segment<3>(6 * i + 3) = random.direction();
      const Vec3 f = onFrames.segment<3>(6 * i);
      left_N -= f;
      turn_Nm -= onFrames.segment<3>(6 * i + 3) + origins_W[static_cast<std::size_t>(i)].cross(f);
    }
    most.force_N = std::max(most.force_N, left_N.norm());
    most.torque_Nm = std::max(most.torque_Nm, turn_Nm.norm());
    most.power = std::max(most.power, std::abs(force_N.dot(map.displacementOf(0, speed)) - onFrames.dot(speed)));
  }
  return most;
}

void judge(const std::string& method, const Lost& lost, Table& table)
{
  table.atMost({ "map", method, "force lost", "N" }, lost.force_N, 1e-12);
  table.atMost({ "map", method, "torque lost", "N m" }, lost.torque_Nm, 1e-12);
  table.atMost({ "map", method, "power that is not the point's", "W" }, lost.power, 1e-12);
}

} // namespace mapping_experiment

void runMapping(const Conditions& conditions, Table& table)
{
  using namespace mapping_experiment;
  const TetraMesh tetra{ { { 0, 0, 0 }, { 0.04, 0, 0 }, { 0, 0.04, 0 }, { 0, 0, 0.04 } }, { { 0, 1, 2, 3 } } };
  judge("barycentric", lost(tetra, nullptr, conditions.seed), table);
  judge("rigid", lostOnFrames(1, conditions.seed), table);
  judge("skinning", lostOnFrames(3, conditions.seed), table);
  const Lost corner = lost(tetra, &nearest, conditions.seed);
  table.atLeast({ "map", "nearest vertex", "torque lost", "N m" }, corner.torque_Nm, 1e-3);
  table.atLeast({ "map", "nearest vertex", "power that is not the point's", "W" }, corner.power, 0.05);
  const Lost uneven = lost(tetra, &byDistance, conditions.seed);
  table.atLeast({ "map", "force by distance", "torque lost", "N m" }, uneven.torque_Nm, 1e-3);
  table.atLeast({ "map", "force by distance", "power that is not the point's", "W" }, uneven.power, 0.05);
}

} // namespace palpate::lab
