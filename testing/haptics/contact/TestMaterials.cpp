// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness, friction and texture from the data of a surface.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/contact/GodObject.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/tick/ForceRenderer.h"
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
template<class Function>
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
    : scene_(std::move(scene)), plan_(plan)
  {
    static_cast<void>(moveGodObject(*this->scene_, this->plan_, { 0, 0, 0.05 }, this->state_));
  }

  ContactResult to(const Vec3& p_W) { return moveGodObject(*this->scene_, this->plan_, p_W, this->state_); }
  /// Straight down from above: a hand that does not move along feels all of a texture.
  Vec3 restingAt(const Vec3& p_W)
  {
    static_cast<void>(this->to({ p_W.x(), p_W.y(), 0.05 }));
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
  const Vec3 slope(2000, 1500, 0);                                               // N/m per m
  const auto stiffness = [&slope](const Vec3& v) { return 500 + slope.dot(v); }; // linear: exact in every triangle
  MaterialFields fields;
  fields.stiffness_N_per_m = sampled(mesh, stiffness);
  Finger finger(build(mesh, {}, fields).scene);
  const double d = 2e-3, K = ContactPlan().coupling_N_per_m;
  for (std::size_t i = 0; i < test::testCount(500); ++i)
  {
    const Vec3 p(random.uniform(-0.09, 0.09), random.uniform(-0.09, 0.09), -d);
    const Vec3 force = stiffness(p) * d * Vec3::UnitZ() - 0.5 * d * d * slope; // -grad of k d^2 / 2
    EXPECT_NEAR((K * finger.restingAt(p) - force).norm(), 0.0, 1e-12 * K);
  }
}

TEST(Materials, OfARampThatGoesBeyondTheCouplingTheDataAreFeltUpToIt)
{
  const TriangleMesh mesh = sheet(3, 126); // coarse: most triangles have corners on both sides of the coupling's
  const Vec3 slope(24500, 0, 0);           // N/m per m: 100 to 5000 N/m
  const auto ramp = [&slope](const Vec3& v) { return 2550 + slope.dot(v); };
  MaterialFields fields;
  fields.stiffness_N_per_m = sampled(mesh, ramp);
  const auto scene = build(mesh, {}, fields).scene;
  const double d = 2e-3;
  for (const double K : { 500.0, 1000.0, 4000.0, 1e4 })
  {
    ContactPlan plan;
    plan.coupling_N_per_m = K;
    Finger finger(scene, plan);
    test::Random random(test::testSeed(127));
    for (std::size_t i = 0; i < test::testCount(300); ++i)
    {
      const Vec3 p(random.uniform(-0.09, 0.09), random.uniform(-0.09, 0.09), -d);
      const Vec3 soft = ramp(p) * d * Vec3::UnitZ() - 0.5 * d * d * slope; // -grad of k d^2 / 2
      const Vec3 force = ramp(p) < K ? soft : Vec3(0, 0, K * d);
      EXPECT_NEAR((K * finger.restingAt(p) - force).norm(), 0.0, 1e-12 * K) << K << ", " << p.transpose();
    }
  }
}

TEST(Materials, TwoWallsOfOneCornerPushWithTheirOwnStiffness)
{
  const double a = 3e-3, b = 2e-3;
  Material soft, hard;
  soft.stiffness_N_per_m = 0.25 * ContactPlan().coupling_N_per_m;
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
  const auto scene = build(mesh, { Material::rigid_N_per_m, 0.5, 0.5 }, fields).scene;
  const double d = 2e-3;
  for (const double x : { -0.08, 0.0, 0.05 })
  {
    for (const double off : { -1e-6, 1e-6 })
    {
      Finger finger(scene);
      static_cast<void>(finger.to({ x, 0, 0.01 }));
      static_cast<void>(finger.to({ x, 0, -d }));
      const ContactResult result =
        finger.to({ x, mu({ x, 0, 0 }) * d + off, -d }); // along y the coefficient is constant
      EXPECT_EQ(result.friction, off > 0 ? FrictionState::Slips : FrictionState::Sticks) << x;
    }
  }
}

TEST(Materials, TextureOfASlopeIsFeltAsTheForceOfItsPotential)
{
  const TriangleMesh mesh = sheet(10, 113);
  const Vec3 slope(0.02, -0.015, 0);                    // hollows of 7 mm at most: never below the finger
  const double highest = slope.dot(Vec3(0.1, -0.1, 0)); // a corner of the sheet
  MaterialFields fields;
  fields.height_u = sampled(mesh, [&slope](const Vec3& v) { return slope.dot(v); });
  Finger finger(build(mesh, {}, fields).scene);
  test::Random random(test::testSeed(114));
  const double d = 8e-3;
  for (std::size_t i = 0; i < test::testCount(300); ++i)
  {
    const Vec3 p(random.uniform(-0.09, 0.09), random.uniform(-0.09, 0.09), -d);
    const double deep = d + slope.dot(p) - highest; // V = K deep^2 / 2, F = -grad V
    EXPECT_NEAR((finger.restingAt(p) - deep * (Vec3::UnitZ() - slope)).norm(), 0.0, 1e-12);
  }
}

TEST(Materials, AClosedWayOverTextureAndChangingStiffnessTakesNoWork)
{
  const TriangleMesh mesh = sheet(40, 115, 0.0);
  MaterialFields fields;
  fields.stiffness_N_per_m = sampled(mesh, [](const Vec3& v) { return 600 + 300 * std::cos(90 * v.x() + 40 * v.y()); });
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

/// Work on a hand [J] along a closed path of straight parts: the trapezium is exact where the force changes linearly,
/// as it does over hollows of one slope between the places where it begins and ends.
double workOf(Finger& finger, double stiffness_N_per_m, const std::vector<Vec3>& corners_W, int stepsPerPart)
{
  static_cast<void>(finger.to(corners_W[0]));
  Vec3 before = finger.to(corners_W[0]).pull_W;
  double work = 0.0;
  for (std::size_t part = 0; part < corners_W.size(); ++part)
  {
    const Vec3 &from = corners_W[part], &to = corners_W[(part + 1) % corners_W.size()];
    for (int i = 1; i <= stepsPerPart; ++i)
    {
      const Vec3 pull = finger.to(from + (to - from) * i / stepsPerPart).pull_W;
      work += 0.5 * stiffness_N_per_m * (pull + before).dot(to - from) / stepsPerPart;
      before = pull;
    }
  }
  return work;
}

TEST(Materials, AHandThatTouchesATextureAndLeavesItAtAnotherHeightGetsNoWork)
{
  const TriangleMesh mesh = sheet(10, 123, 0.0);
  const double slope = 1.0 / 32, unit = 1.0 / 1024, K = 1000.0; // every kink is a sample: hollows end at multiples
  for (const double offset : { 0.0, 4 * unit, -8 * unit })      // a height counts from the highest place
  {
    MaterialFields fields;
    fields.height_u = sampled(mesh, [=](const Vec3& v) { return slope * v.x() + offset; });
    const auto scene = build(mesh, {}, fields).scene;
    for (const double depth : { 4 * unit, 8 * unit }) // less and more than the deepest hollow on the path
    {
      const double x = 0.0625; // hollows from x on: slope (0.1 -+ x)
      const std::vector<Vec3> way = { { x, 0, unit }, { x, 0, -depth }, { -x, 0, -depth }, { -x, 0, unit } };
      const std::vector<Vec3> back(way.rbegin(), way.rend());
      for (const std::vector<Vec3>& corners_W : { way, back })
      {
        Finger finger(scene);
        // Where a step straddles the end of a hollow the trapezium is wrong by K step^2 / 2 at most, on three parts.
        const int steps = 8192;
        const double rounded = 2 * K * std::pow((depth + unit) / steps, 2);
        EXPECT_NEAR(workOf(finger, K, corners_W, steps), 0.0, rounded) << offset << ", " << depth;
      }
    }
  }
}

TEST(Materials, AClosedWayInBelowTheCouplingsStiffnessAndOutBeyondItTakesNoWork)
{
  const TriangleMesh mesh = sheet(3, 128);
  const double slope = 24500, K = 1000.0, d = 2e-3, x = 0.09;
  MaterialFields fields;
  fields.stiffness_N_per_m = sampled(mesh, [=](const Vec3& v) { return 2550 + slope * v.x(); });
  ContactPlan plan;
  plan.coupling_N_per_m = K;
  Finger finger(build(mesh, {}, fields).scene, plan);
  const int steps = 8192;
  // Where the coupling's stiffness is reached the force along the path ends within a step.
  const double jump = 0.5 * d * d * slope * 2 * x / steps, landing = 2 * K * std::pow(2 * d / steps, 2);
  const double work = workOf(finger, K, { { -x, 0.01, d }, { -x, 0.01, -d }, { x, 0.01, -d }, { x, 0.01, d } }, steps);
  EXPECT_NEAR(work, 0.0, 0.5 * jump + landing);
}

TEST(Materials, ATextureIsMetWithoutAStepAtTheSurfaceWhereverItIsTouched)
{
  const TriangleMesh mesh = sheet(10, 124);
  MaterialFields fields;
  fields.height_u = sampled(mesh, [](const Vec3& v) { return 5e-3 * std::cos(60 * v.x()) * std::cos(50 * v.y()); });
  const auto scene = build(mesh, {}, fields).scene;
  test::Random random(test::testSeed(125));
  for (std::size_t i = 0; i < test::testCount(200); ++i)
  {
    const Vec3 at(random.uniform(-0.09, 0.09), random.uniform(-0.09, 0.09), 0.0);
    Finger finger(scene);
    static_cast<void>(finger.to(at + Vec3(0, 0, 1e-6)));
    EXPECT_LT(finger.to(at - Vec3(0, 0, 1e-6)).pull_W.norm(), 2e-6); // slopes are below 1
  }
}

constexpr double ridge = 1e-3, rib = 0.02; // ribs along y, at even centimetres

/// Ribs on cells of 10 mm: the mesh can say no finer.
std::shared_ptr<const Scene> ribs()
{
  const TriangleMesh mesh = sheet(20, 116, 0.0);
  MaterialFields fields;
  fields.height_u = sampled(mesh, [](const Vec3& v) { return std::lround(v.x() / 0.01) % 2 == 0 ? ridge : 0.0; });
  return build(mesh, {}, fields).scene;
}

TEST(Materials, AHandThatIsTooFastForATextureFeelsItsMean)
{
  const double d = 2e-3, mean = 0.5 * ridge;
  const auto hollowAt = [&](double ticksAPeriod)
  {
    Finger finger(ribs());
    static_cast<void>(finger.to({ -2 * rib / ticksAPeriod, 0.001, 1e-3 })); // in the air
    static_cast<void>(finger.to({ -rib / ticksAPeriod, 0.001, -d }));
    return d - finger.to({ 0.0, 0.001, -d }).pull_W.z();
  };
  const auto faded = [&](double share) { return (1.0 - share) * (ridge - mean); }; // on a ridge
  EXPECT_NEAR(hollowAt(200.0), 0.0, 1e-12);
  EXPECT_NEAR(hollowAt(10.0), 0.0, 1e-12);
  EXPECT_NEAR(hollowAt(8.0), faded(8.0 / 5.0 - 1.0), 1e-12);
  EXPECT_NEAR(hollowAt(5.0), faded(0.0), 1e-12);
  EXPECT_NEAR(hollowAt(2.0), faded(0.0), 1e-12);
}

TEST(Materials, ATextureFadesOnItsHillsAndReturnsInItsHollows)
{
  const double d = 2e-3, y = 0.001;
  Finger finger(ribs());
  const auto hollowAt = [&](double x) { return (d - finger.to({ x, y, -d }).pull_W.z()) / ridge; };
  static_cast<void>(finger.restingAt({ 0.01, y, -d }));
  EXPECT_NEAR(hollowAt(0.0125), 0.75, 1e-9); // fast, but lower than the mean: as it is
  EXPECT_NEAR(hollowAt(0.0225), 0.5, 1e-9);  // on a hill: faded
  EXPECT_NEAR(hollowAt(0.0225), 0.5, 1e-9);  // and at rest there it stays so
  for (int i = 1; i <= 11; ++i)
  {
    const double x = 0.0225 + i * 5e-4, there = (x - 0.02) / 0.01; // slowly down the other side
    EXPECT_NEAR(hollowAt(x), std::max(0.5, there), 1e-9);
  }
  for (int i = 1; i <= 16; ++i)
  {
    const double x = 0.028 - i * 5e-4; // and up again: all of it
    EXPECT_NEAR(hollowAt(x), (x - 0.02) / 0.01, 1e-9);
  }
}

/// Work [J] of forces in the middle of steps: exact where they change linearly over a step.
double middlesWork(Finger& finger, double stiffness_N_per_m, const Vec3& from, const Vec3& to, int steps)
{
  double work = 0.0;
  const Vec3 step = (to - from) / steps;
  for (int i = 0; i < steps; ++i)
  {
    work += stiffness_N_per_m * finger.to(from + (i + 0.5) * step).pull_W.dot(step);
  }
  return work;
}

TEST(Materials, AHandThatEntersAndLeavesATextureSlowlyAndStrokesItFastIsNotPaid)
{
  const double d = 2e-3, K = 1000.0, y = 0.001;
  const int slowly = 4000;                      // steps of 1 um: every kink of a full or faded texture is an end of one
  for (const int ticksAPeriod : { 4, 8, 4000 }) // not felt, faded, felt
  {
    for (const auto& [in, out] : { std::pair(0.01, 0.04), std::pair(0.02, 0.05), std::pair(0.01, 0.05) })
    {
      Finger finger(ribs());
      const int ticks = static_cast<int>(std::lround((out - in) / rib * ticksAPeriod));
      const double work = middlesWork(finger, K, { in, y, d }, { in, y, -d }, slowly) +
                          middlesWork(finger, K, { in, y, -d }, { out, y, -d }, ticks) +
                          middlesWork(finger, K, { out, y, -d }, { out, y, d }, slowly);
      EXPECT_LT(work, 1e-8) << in << " to " << out << ", " << ticksAPeriod; // of 1.5e-3 J where the speed alone decides
      if (ticksAPeriod == 4000)
      {
        EXPECT_NEAR(work, 0.0, 1e-8) << in << " to " << out;
      }
    }
  }
}

TEST(Materials, ThePeriodOfATextureIsTheLengthOfItsWaveHoweverFineTheMesh)
{
  const double wave = 0.02; // ten of them on the sheet
  for (const int cells : { 200, 300 })
  {
    const TriangleMesh mesh = sheet(cells, 119, 0.0);
    const TextureScale scale = measureTexture(
      mesh, sampled(mesh, [=](const Vec3& v) { return 1e-3 + 4e-4 * std::sin(2 * std::numbers::pi * v.x() / wave); }));
    EXPECT_NEAR(scale.period_u, wave, 0.01 * wave);
    EXPECT_NEAR(scale.mean_u, 1e-3, 1e-6);
    const double besideCrest = std::numbers::pi * 0.2 / cells / wave; // half a cell, as a phase
    EXPECT_NEAR(scale.largest_u, 1.4e-3, 4e-4 * (1.0 - std::cos(besideCrest)));
  }
  const TriangleMesh mesh = sheet(4, 120);
  EXPECT_EQ(measureTexture(mesh, sampled(mesh, [](const Vec3&) { return 2e-3; })).period_u,
    std::numeric_limits<double>::infinity()); // a level texture is felt at every speed
}

/// A hand that is led, a tick a place; scene units are metres.
class Hand
{
public:
  Hand(std::shared_ptr<const Scene> scene, const HapticParameters& parameters)
    : scene_(std::move(scene)), parameters_(parameters)
  {
    this->parameters_.safety = SafetyLimits::none();
  }
  HapticState to(const Vec3& p_W)
  {
    TickInput input;
    input.scene = this->scene_.get();
    input.sample.pose_D.p = p_W;
    return renderTick(input, this->parameters_, this->renderer_).state;
  }

private:
  std::shared_ptr<const Scene> scene_;
  HapticParameters parameters_;
  RendererState renderer_;
};

TEST(Materials, WhatIsFeltIsTheStiffnessOfTheDataUpToTheCouplingsOwn)
{
  const TriangleMesh mesh = sheet(4, 121);
  const double d = 2e-3;
  for (const double wall : { 0.0, 200.0, 700.0, 1000.0, 5000.0 })
  {
    for (const double limit : { 400.0, 1e4 }) // the device's limit
    {
      HapticParameters parameters;
      parameters.stiffness_N_per_m = 1000.0;
      parameters.stiffnessLimit_N_per_m = limit;
      MaterialFields fields;
      fields.stiffness_N_per_m = sampled(mesh, [wall](const Vec3&) { return wall; });
      Hand hand(build(mesh, {}, fields).scene, parameters);
      static_cast<void>(hand.to({ 0, 0, 0.01 }));
      const double felt = std::min({ wall, parameters.stiffness_N_per_m, limit });
      EXPECT_NEAR(hand.to({ 0, 0, -d }).force_W.z(), felt * d, 1e-12) << wall << ", limit " << limit;
    }
  }
}

TEST(Materials, TheEnergyOfASoftWallIsMeasuredAsItIs)
{
  const double wall = 250.0, d = 2e-3;
  const int steps = 100;
  const double h = d / steps;
  Material soft;
  soft.stiffness_N_per_m = wall;
  Hand hand(build(sheet(4, 122), soft, {}).scene, HapticParameters());
  static_cast<void>(hand.to({ 0, 0, h }));
  HapticState state;
  for (int i = 0; i <= steps; ++i)
  {
    state = hand.to({ 0, 0, -i * h });
  }
  const double taken = wall * h * h * steps * (steps - 1) / 2.0; // held forces k h i over steps of h
  EXPECT_NEAR(state.energy.delivered_J, -taken, 1e-12);
  EXPECT_NEAR(state.energy.excess_J, 0.5 * wall * d * d - taken, 1e-12); // energy of a spring of k beyond that
}

TEST(Materials, ValuesThatCannotBeUsedFallBackToTheSurfacesOwnAndAreCounted)
{
  const TriangleMesh mesh = sheet(4, 117);
  MaterialFields fields;
  fields.stiffness_N_per_m = sampled(mesh, [](const Vec3&) { return 500.0; });
  fields.stiffness_N_per_m[0] = nan;
  fields.stiffness_N_per_m[1] = -1.5;
  fields.height_u = sampled(mesh, [](const Vec3& v) { return -1.0 + 0.1 * v.x(); });
  fields.height_u[2] = std::numeric_limits<double>::infinity();
  const double highest = *std::max_element(fields.height_u.begin() + 3, fields.height_u.end());
  Material own;
  own.stiffness_N_per_m = 750.0;
  const SceneBuildResult built = build(mesh, own, fields);
  ASSERT_NE(built.scene, nullptr);
  EXPECT_EQ(built.reports[0].materialReplaced, 3u);
  for (const double value : built.scene->surfaces()[0].fields->stiffness_N_per_m)
  {
    EXPECT_TRUE(value == 500.0 || value == 750.0);
  }
  const MaterialFields& felt = *built.scene->surfaces()[0].fields;
  EXPECT_EQ(felt.texture.largest_u, highest);
  EXPECT_GE(std::count(felt.height_u.begin(), felt.height_u.end(), highest), 2); // no hollow where there is no height
}

TEST(Materials, ArraysOfTheWrongLengthAndFrictionOutOfRangeAreRefusedInOneSentence)
{
  const TriangleMesh mesh = sheet(4, 118);
  MaterialFields fields;
  fields.frictionStatic = { 0.1, 0.2 };
  SceneBuildResult built = build(mesh, {}, fields);
  EXPECT_EQ(built.scene, nullptr);
  EXPECT_NE(built.reports[0].refusal.find("2 values for " + std::to_string(mesh.vertices_W.size())), std::string::npos);
  for (const Material& bad :
    { Material{ -1.5 }, Material{ nan }, Material{ 500.0, 0.2, 0.3 }, Material{ 500.0, 11.0, 1.0 } })
  {
    built = build(mesh, bad, {});
    EXPECT_EQ(built.scene, nullptr);
    EXPECT_FALSE(built.reports[0].refusal.empty());
  }
}

} // namespace
} // namespace palpate
