// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness, friction and texture from the data of a surface.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/contact/GodObject.h"
#include "haptics/geometry/SceneBuilder.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TriangleMesh sheet(int cells, std::uint64_t seed, double jitter = 0.3)
{
  test::Random random(test::testSeed(seed));
  return test::makeSheet({ 0.2, 0.2, cells, cells, jitter }, random);
}

/// One value a vertex of the mesh as it is given, before cleaning.
template <class Function>
std::vector<double> sampled(const TriangleMesh& mesh, Function value)
{
  std::vector<double> field;
  for (const Vec3& v : mesh.vertices_W)
  {
    field.push_back(value(v));
  }
  return field;
}

SceneBuildResult build(const TriangleMesh& mesh, const Material& material, const MaterialFields& fields)
{
  return SceneBuilder().build(
    { { "sheet", std::make_shared<TriangleMesh>(mesh), material, std::make_shared<MaterialFields>(fields) } });
}

/// A point pressed into the sheet from above; pull of the coupling [m] after each move.
class Finger
{
public:
  explicit Finger(std::shared_ptr<const Scene> scene, const ContactPlan& plan = {})
    : scene_(std::move(scene))
    , plan_(plan)
  {
    static_cast<void>(moveGodObject(*this->scene_, this->plan_, { 0, 0, 0.05 }, this->state_));
  }

  ContactResult to(const Vec3& p_W) { return moveGodObject(*this->scene_, this->plan_, p_W, this->state_); }
  /// The same place twice: a hand at rest feels all of a texture.
  Vec3 restingAt(const Vec3& p_W)
  {
    static_cast<void>(this->to(p_W));
    return this->to(p_W).pull_W;
  }

private:
  std::shared_ptr<const Scene> scene_;
  ContactPlan plan_;
  GodObjectState state_;
};

TEST(Materials, StiffnessIsInterpolatedBetweenVerticesWhateverCleaningDidToTheirOrder)
{
  test::Random random(test::testSeed(111));
  const TriangleMesh mesh = test::shuffled(sheet(10, 110), random);
  const auto factor = [](const Vec3& v) { return 0.5 + 2.0 * v.x() + 1.5 * v.y(); }; // linear: exact in every triangle
  MaterialFields fields;
  fields.stiffnessFactor = sampled(mesh, factor);
  Finger finger(build(mesh, {}, fields).scene);
  const double d = 2e-3;
  for (std::size_t i = 0; i < test::testCount(500); ++i)
  {
    const Vec3 p(random.uniform(-0.09, 0.09), random.uniform(-0.09, 0.09), -d);
    const Vec3 pull = finger.restingAt(p);
    EXPECT_NEAR(pull.z(), factor(p) * d, 1e-12);
    EXPECT_NEAR(pull.head<2>().norm(), 0.0, 1e-12);
  }
}

TEST(Materials, TwoWallsOfOneCornerPushWithTheirOwnStiffness)
{
  const double a = 3e-3, b = 2e-3;
  Material soft, hard;
  soft.stiffnessFactor = 0.25;
  const auto floor = std::make_shared<TriangleMesh>(test::makeBox({ 0, -0.5, -0.1 }, { 0.5, 0.5, 0.0 }));
  const auto wall = std::make_shared<TriangleMesh>(test::makeBox({ -0.1, -0.5, -0.1 }, { 0.0, 0.5, 0.5 }));
  const auto scene = SceneBuilder().build({ { "floor", floor, soft }, { "wall", wall, hard } }).scene;
  GodObjectState state;
  static_cast<void>(moveGodObject(*scene, {}, { 0.01, 0, 0.01 }, state));
  const Vec3 pull = moveGodObject(*scene, {}, { -b, 0, -a }, state).pull_W;
  EXPECT_NEAR((pull - Vec3(b, 0, 0.25 * a)).norm(), 0.0, 1e-12);
}

TEST(Materials, FrictionFromDataBreaksAwayAtTheConeOfThePlaceTouched)
{
  const TriangleMesh mesh = sheet(10, 112);
  const auto mu = [](const Vec3& v) { return 0.5 + 3.0 * v.x(); };
  MaterialFields fields;
  fields.frictionStatic = fields.frictionKinetic = sampled(mesh, mu);
  const auto scene = build(mesh, { 1.0, 0.5, 0.5 }, fields).scene;
  const double d = 2e-3;
  for (const double x : { -0.08, 0.0, 0.05 })
  {
    for (const double off : { -1e-6, 1e-6 })
    {
      Finger finger(scene);
      static_cast<void>(finger.to({ x, 0, 0.01 }));
      static_cast<void>(finger.to({ x, 0, -d }));
      const ContactResult result = finger.to({ x, mu({ x, 0, 0 }) * d + off, -d }); // along y the coefficient is constant
      EXPECT_EQ(result.friction, off > 0 ? FrictionMotion::Slips : FrictionMotion::Sticks) << x;
    }
  }
}

TEST(Materials, TextureOfASlopeIsFeltAsTheForceOfItsPotential)
{
  const TriangleMesh mesh = sheet(10, 113);
  const Vec3 slope(0.02, -0.015, 0); // at most 3.5 mm high: never above the finger
  MaterialFields fields;
  fields.height_u = sampled(mesh, [&slope](const Vec3& v) { return slope.dot(v); });
  Finger finger(build(mesh, {}, fields).scene);
  test::Random random(test::testSeed(114));
  const double d = 5e-3;
  for (std::size_t i = 0; i < test::testCount(300); ++i)
  {
    const Vec3 p(random.uniform(-0.09, 0.09), random.uniform(-0.09, 0.09), -d);
    const double deep = d + slope.dot(p); // V = K deep^2 / 2, F = -grad V
    EXPECT_NEAR((finger.restingAt(p) - deep * (Vec3::UnitZ() - slope)).norm(), 0.0, 1e-12);
  }
}

TEST(Materials, AClosedWayOverATextureTakesNoWork)
{
  const TriangleMesh mesh = sheet(40, 115, 0.0);
  MaterialFields fields;
  fields.height_u = sampled(mesh, [](const Vec3& v) { return 4e-4 * std::sin(200 * v.x()) * std::cos(170 * v.y()); });
  Finger finger(build(mesh, {}, fields).scene);
  const double K = 1000.0, d = 2e-3, radius = 0.03;
  const int steps = 40000;
  const auto at = [&](int i)
  {
    const double angle = 2 * std::numbers::pi * i / steps;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), -d * (1.2 + 0.5 * std::sin(3 * angle)));
  };
  static_cast<void>(finger.restingAt(at(0)));
  double work = 0.0;
  Vec3 before = finger.to(at(0)).pull_W;
  for (int i = 1; i <= steps; ++i)
  {
    const Vec3 pull = finger.to(at(i)).pull_W;
    work += 0.5 * K * (pull + before).dot(at(i) - at(i - 1));
    before = pull;
  }
  EXPECT_LT(std::abs(work), 1e-3 * 0.5 * K * d * d); // the trapezium's own error at this step
}

TEST(Materials, AHandThatIsTooFastForATextureFeelsLessOfIt)
{
  const TriangleMesh mesh = sheet(20, 116, 0.0); // cells of 10 mm: periods of 20 mm
  MaterialFields fields;
  fields.height_u = sampled(mesh, [](const Vec3& v) { return std::lround(v.x() / 0.01) % 2 == 0 ? 1e-3 : 0.0; });
  const double d = 2e-3;
  const auto liftAt = [&](double step)
  {
    Finger finger(build(mesh, {}, fields).scene);
    static_cast<void>(finger.to({ -step, 0.001, -d }));
    return finger.to({ 0.0, 0.001, -d }).pull_W.z() - d;
  };
  const double slow = liftAt(1e-4), fast = liftAt(1e-2);
  EXPECT_NEAR(slow, 1e-3, 1e-12); // on a ridge
  EXPECT_NEAR(fast / slow, 2.0 * 0.01 / (5.0 * 0.01), 1e-9); // share 2 grain / (5 step)
}

TEST(Materials, ValuesThatCannotBeUsedFallBackToTheSurfacesOwnAndAreCounted)
{
  const TriangleMesh mesh = sheet(4, 117);
  MaterialFields fields;
  fields.stiffnessFactor = sampled(mesh, [](const Vec3&) { return 0.5; });
  fields.stiffnessFactor[0] = nan;
  fields.stiffnessFactor[1] = 1.5;
  fields.height_u = sampled(mesh, [](const Vec3&) { return 0.0; });
  fields.height_u[2] = std::numeric_limits<double>::infinity();
  Material own;
  own.stiffnessFactor = 0.75;
  const SceneBuildResult built = build(mesh, own, fields);
  ASSERT_NE(built.scene, nullptr);
  EXPECT_EQ(built.reports[0].materialReplaced, 3u);
  for (const double value : built.scene->surfaces()[0].fields->stiffnessFactor)
  {
    EXPECT_TRUE(value == 0.5 || value == 0.75);
  }
}

TEST(Materials, ArraysOfTheWrongLengthAndFrictionOutOfRangeAreRefusedInOneSentence)
{
  const TriangleMesh mesh = sheet(4, 118);
  MaterialFields fields;
  fields.frictionStatic = { 0.1, 0.2 };
  SceneBuildResult built = build(mesh, {}, fields);
  EXPECT_EQ(built.scene, nullptr);
  EXPECT_NE(built.reports[0].refusal.find("2 values for " + std::to_string(mesh.vertices_W.size())), std::string::npos);
  for (const Material& bad : { Material{ 1.5 }, Material{ nan }, Material{ 1.0, 0.2, 0.3 }, Material{ 1.0, 11.0, 1.0 } })
  {
    built = build(mesh, bad, {});
    EXPECT_EQ(built.scene, nullptr);
    EXPECT_FALSE(built.reports[0].refusal.empty());
  }
}

} // namespace
} // namespace palpate
