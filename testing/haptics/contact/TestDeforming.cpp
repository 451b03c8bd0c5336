// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces whose vertices move: the proxy stays on its side of every new mesh and where the moved surface holds it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/contact/GodObject.h"
#include "haptics/contact/carry/HandOver.h"
#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/tree/SurfaceTree.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

constexpr double twoPi = 2 * std::numbers::pi;
constexpr int ticksPerMesh = 16;
constexpr double T = 1e-3;

/// A surface whose vertices are a function of where they began and of time; every mesh is refitted from the last.
class RefittedSurface
{
public:
  using Path = std::function<Vec3(const Vec3& start_W, double time_s)>;

  RefittedSurface(const TriangleMesh& mesh, Path path, double radius, const Vec3& start_W)
    : path_(std::move(path)), start_(std::make_shared<const SurfaceTree>(cleanMesh(mesh).mesh)), tree_(start_)
  {
    this->plan_.radius_u = radius;
    this->scene_ = this->next(0.0);
    static_cast<void>(moveGodObject(*this->scene_, this->plan_, start_W, this->state));
  }

  ContactResult tick(const Vec3& p_W)
  {
    if (++this->ticks_ % ticksPerMesh == 0)
    {
      const std::shared_ptr<const Scene> old = this->scene_;
      this->scene_ = this->next(this->time_s());
      static_cast<void>(handOver(*old, *this->scene_, this->plan_, p_W, this->state));
    }
    return moveGodObject(*this->scene_, this->plan_, p_W, this->state);
  }

  [[nodiscard]] double time_s() const { return this->ticks_ * T; }
  /// Of the mesh that is felt.
  [[nodiscard]] double meshTime_s() const { return this->ticks_ / ticksPerMesh * ticksPerMesh * T; }
  [[nodiscard]] const TriangleMesh& mesh() const { return this->tree_->mesh(); }

  GodObjectState state;

private:
  std::shared_ptr<const Scene> next(double time_s)
  {
    std::vector<Vec3> vertices;
    for (const Vec3& v : this->start_->mesh().vertices_W)
    {
      vertices.push_back(this->path_(v, time_s));
    }
    RefitResult moved = this->tree_->refitted(std::move(vertices));
    EXPECT_TRUE(moved.tree) << moved.refusal;
    this->tree_ = std::move(moved.tree);
    return std::make_shared<const Scene>(++this->revision_, std::vector<Surface>{ { "it", this->tree_, {} } });
  }

  Path path_;
  std::shared_ptr<const SurfaceTree> start_, tree_;
  std::shared_ptr<const Scene> scene_;
  ContactPlan plan_;
  std::uint64_t revision_ = 0;
  int ticks_ = 0;
};

/// How often a segment crosses the surface, by exact orientations: odd between the two sides of a closed one. The far
/// end is in general position.
int crossings(const TriangleMesh& mesh, const Vec3& x_W, const Vec3& far_W)
{
  int count = 0;
  for (const auto& t : mesh.triangles)
  {
    const Vec3 &a = mesh.vertices_W[t[0]], &b = mesh.vertices_W[t[1]], &c = mesh.vertices_W[t[2]];
    if (orientation(a, b, c, x_W) != orientation(a, b, c, far_W))
    {
      const int ab = orientation(x_W, far_W, a, b), bc = orientation(x_W, far_W, b, c),
                ca = orientation(x_W, far_W, c, a);
      count += ab == bc && bc == ca ? 1 : 0;
    }
  }
  return count;
}

const Vec3 farAway(3.1234, 2.7183, 4.4721);

class Deforming : public testing::TestWithParam<double>
{
};

TEST_P(Deforming, ASphereThatBreathesUnderAHandKeepsItOutAndGivesItsDepth)
{
  const double radius = GetParam();
  for (const double rate_Hz : { 1.0, 2.0 })
  {
    const auto size = [=](double t) { return 0.05 - 0.005 * std::cos(twoPi * rate_Hz * t); };
    const auto breathe = [=](const Vec3& v, double t) { return Vec3(size(t) * v); };
    const TriangleMesh unit = makeIcosphere(4, 1.0);
    double inner = 1.0; // the nearest facet to the centre
    for (const auto& t : unit.triangles)
    {
      const Vec3 &a = unit.vertices_W[t[0]], &b = unit.vertices_W[t[1]], &c = unit.vertices_W[t[2]];
      inner = std::min(inner, std::abs((b - a).cross(c - a).normalized().dot(a)));
    }
    RefittedSurface sphere(unit, breathe, radius, Vec3(0, 0, 0.1));
    for (int i = 0; i < static_cast<int>(2.0 / rate_Hz / T); ++i)
    {
      const double turn = twoPi * sphere.time_s() / 2;
      const Vec3 p = 0.048 * Vec3(std::sin(turn), 0.3 * std::sin(2 * turn), std::cos(turn)).normalized();
      const Vec3 x = (sphere.tick(p), sphere.state.x_W);
      const double R = size(sphere.meshTime_s()) + radius;
      // A ball over a facet stands at most the facet's sagitta below the sphere; one that is out of it at the device.
      ASSERT_GE(x.norm(), std::max(0.048, R - (1.0 - inner) * (R - radius)) - 1e-9) << rate_Hz << " Hz, tick " << i;
      ASSERT_LE(x.norm(), std::max(0.048, R) + 1e-9) << rate_Hz << " Hz, tick " << i;
      if (radius == 0.0)
      {
        ASSERT_EQ(crossings(sphere.mesh(), x, farAway) % 2, 0) << rate_Hz << " Hz, tick " << i;
      }
    }
  }
}

TEST_P(Deforming, AHandInsideABreathingSphereStaysInside)
{
  const double radius = GetParam();
  const auto breathe = [](const Vec3& v, double t) { return Vec3((0.05 + 0.005 * std::cos(twoPi * t)) * v); };
  RefittedSurface sphere(makeIcosphere(4, 1.0), breathe, radius, Vec3(0, 0, 0));
  for (int i = 0; i < 1000; ++i)
  {
    const double turn = twoPi * sphere.time_s();
    static_cast<void>(sphere.tick(0.06 * Vec3(std::sin(turn), std::cos(turn), 0.2).normalized()));
    ASSERT_EQ(crossings(sphere.mesh(), sphere.state.x_W, farAway) % 2, 1) << "tick " << i;
  }
}

TEST_P(Deforming, AWaveRunningOverAPlaneLiftsAPressedHandAndIsNeverPassed)
{
  const double radius = GetParam(), amplitude = 5e-3, length = 0.08;
  const double slope = twoPi / length * amplitude, cell = 0.2 / 80 * 1.6; // the longest edge along a diagonal, jittered
  const double bend = twoPi / length * slope;
  const auto height = [=](double x, double t) { return amplitude * std::sin(twoPi * (x / length - 2.0 * t)); };
  const auto wave = [=](const Vec3& v, double t) { return Vec3(v.x(), v.y(), height(v.x(), t)); };
  Random random(testSeed(411));
  for (const double side : { 1.0, -1.0 })
  {
    RefittedSurface plane(makeSheet({ 0.2, 0.2, 80, 80, 0.2 }, random), wave, radius, { 0.003, 0.002, 0.05 * side });
    for (int i = 0; i < 1000; ++i)
    {
      const double along = 0.03 * std::sin(twoPi * plane.time_s());
      const Vec3 p(along, 0.002, -8e-3 * side);
      static_cast<void>(plane.tick(p));
      const Vec3 x = plane.state.x_W;
      const double above = side * (x.z() - height(x.x(), plane.meshTime_s()));
      // Between the chords of the wave and the wave: bend cell^2 / 8; a ball's centre stands r to r / cos(slope) above.
      const double facet = bend * cell * cell / 8;
      ASSERT_GE(above, radius - facet - 0.5 * bend * radius * radius - 1e-9) << "side " << side << ", tick " << i;
      ASSERT_LE(above, radius * std::sqrt(1 + slope * slope) + 0.5 * bend * radius * radius + facet + 1e-9)
        << "side " << side << ", tick " << i;
      if (radius == 0.0)
      {
        ASSERT_EQ(crossings(plane.mesh(), x, Vec3(x.x() + 1e-5, x.y() + 2e-5, side)) % 2, 0) << "tick " << i;
      }
    }
  }
}

TEST_P(Deforming, VerticesThatJumpAtRandomByAThirdOfAnEdgeNeverPassTheHand)
{
  const double radius = GetParam(), R = 0.05;
  const TriangleMesh sphere = makeIcosphere(3, R);
  double edge = R;
  for (const auto& t : sphere.triangles)
  {
    edge = std::min(edge, (sphere.vertices_W[t[0]] - sphere.vertices_W[t[1]]).norm());
  }
  for (const bool inside : { false, true })
  {
    Random random(testSeed(412)), hand(testSeed(413));
    const auto shake = [&](const Vec3& v, double)
    { return Vec3(v + 0.3 * edge * random.uniform() * random.direction()); };
    const Vec3 start = inside ? Vec3::Zero() : Vec3(0, 0, 0.1);
    RefittedSurface rough(sphere, shake, radius, start);
    Vec3 p = start;
    for (std::size_t i = 0; i < testCount(4000); ++i)
    {
      p = (inside ? 1.1 : 0.9) * R * (p.normalized() + 0.02 * hand.direction()).normalized();
      static_cast<void>(rough.tick(i == 0 ? start + Vec3(0, 0, 1e-3) : p));
      ASSERT_TRUE(rough.state.x_W.allFinite());
      ASSERT_EQ(crossings(rough.mesh(), rough.state.x_W, farAway) % 2, inside ? 1 : 0) << "tick " << i;
    }
  }
}

TEST_P(Deforming, VerticesThatDoNotMoveChangeNothing)
{
  const double radius = GetParam();
  // The far half bends, the near one is touched.
  const auto bend = [](const Vec3& v, double t) { return v.z() < -0.01 ? Vec3(v * (1 + 0.1 * t)) : v; };
  const TriangleMesh mesh = makeIcosphere(3, 0.05);
  RefittedSurface bending(mesh, bend, radius, Vec3(0, 0, 0.1));
  RefittedSurface still(
    mesh, [](const Vec3& v, double) { return v; }, radius, Vec3(0, 0, 0.1));
  for (int i = 0; i < 500; ++i)
  {
    const Vec3 p = 0.047 * Vec3(0.3 * std::sin(0.01 * i), 0.3 * std::cos(0.013 * i), 1).normalized();
    static_cast<void>(bending.tick(p));
    static_cast<void>(still.tick(p));
    ASSERT_LE((bending.state.x_W - still.state.x_W).norm(), 1e-9) << "tick " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(PointAndBall, Deforming, testing::Values(0.0, 1e-3));

} // namespace
} // namespace palpate::test
