// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of a scene that are loose bodies. Judges: statics and Newton's law of blocks of which mass and friction are
// known.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/check/BodiesOverlap.h"
#include "haptics/recording/Recording.h"
#include "testing/haptics/session/LooseStones.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A ball in the hand, without a tool and a soft body.
struct FreeHand : PressingHand
{
  explicit FreeHand(double friction = 0.0, const std::string& file = {}) : PressingHand(file)
  {
    this->session.choose<SoftTask>({});
    HapticParameters parameters = this->session.parameters();
    parameters.contact.radius_u = fingertip_m;
    parameters.contact.friction = { friction, friction };
    EXPECT_EQ(this->session.setParameters(parameters), "");
  }

  const HapticState& at(const Vec3& hand_W, int ticks = 1) { return this->hold({ hand_W, Quat::Identity() }, ticks); }

  [[nodiscard]] int bodyNamed(const std::string& name)
  {
    const auto& bodies = this->session.feltMechanism()->mechanism.bodies;
    const auto found = std::ranges::find(bodies, name, &MechanismBody::name);
    return found != bodies.end() ? static_cast<int>(found - bodies.begin()) : -1;
  }
  /// Where the middle of a loose body is.
  [[nodiscard]] Vec3 middleOf(const std::string& name)
  {
    return this->session.state().mechanism.pose_W[static_cast<std::size_t>(this->bodyNamed(name))].p;
  }
  /// Force on a body by another one.
  [[nodiscard]] Vec3 pressOn(const std::string& name, const std::string& by)
  {
    const int body = this->bodyNamed(name), other = this->bodyNamed(by);
    const MechanismNow& now = this->session.state().mechanism;
    Vec3 sum_N = Vec3::Zero();
    for (int i = 0; i < now.touching; ++i)
    {
      const auto& [a, b, at_W, force_W] = now.found[static_cast<std::size_t>(i)];
      sum_N += a == body && b == other ? force_W : b == body && a == other ? Vec3(-force_W) : Vec3(Vec3::Zero());
    }
    return sum_N;
  }
};

const Vec3 away(-0.3, -0.3, 0.3);

TEST(LooseSources, RestsOnTheFixedFloorWithItsWeightWhereverItsDataHaveTheirOrigin)
{
  for (const Pose& pose : { Pose{}, Pose{ Vec3(0.1, 0.05, 0.0), Quat(std::cos(0.2), 0.0, 0.0, std::sin(0.2)) } })
  {
    FreeHand hand;
    SurfaceInput stone = stoneInput(Vec3(0.02, 0.03, 0.0));
    stone.pose_WS = pose;
    hand.session.setScene(sceneOfAll({ floorInput(), stone }));
    hand.session.setLoose(stones());
    hand.at(away, 500);
    ASSERT_TRUE(hand.session.state().mechanism.held) << hand.session.looseRefusal();
    const Vec3 force_N = hand.pressOn("stone", "floor");
    EXPECT_NEAR(force_N.z(), weight_N, 1e-9 * weight_N);
    EXPECT_LE(force_N.head<2>().norm(), 1e-9 * weight_N);
    const Vec3 expected_W = pose * Vec3(0.02, 0.03, half_m.z());
    EXPECT_LE((hand.middleOf("stone") - expected_W).norm(), 1e-6);
    EXPECT_EQ(hand.session.state().force_W, Vec3(Vec3::Zero()));
  }
}

/// A block goes out of the floor from a twentieth of its diagonal, 3.7 mm, and is refused where it is deeper in it.
TEST(LooseSources, BegunInTheFloorItGoesOutOrIsRefusedWithItsDepth)
{
  FreeHand near;
  near.session.setScene(sceneOfAll({ floorInput(), stoneInput(Vec3(0.0, 0.0, -0.0035)) }));
  near.session.setLoose(stones());
  near.at(away, 4000);
  EXPECT_NEAR(near.middleOf("stone").z(), half_m.z(), 1e-5);
  FreeHand deep;
  deep.session.setScene(sceneOfAll({ floorInput(), stoneInput(Vec3(0.0, 0.0, -0.004)) }));
  deep.session.setLoose(stones());
  deep.at(away, 200);
  EXPECT_THAT(deep.session.status<MechanismTask>().problem,
    AllOf(HasSubstr("stone lies 0.004 u deep in floor"), HasSubstr("at most 0.00374 u: move one of them")));
}

/// Of two bodies in one place no vertex lies in the other one, but the middle does: 1 cm deep.
TEST(LooseSources, TwoInOnePlaceAreRefused)
{
  FreeHand hand;
  SurfaceInput twin = stoneInput();
  twin.name = "twin";
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput(), twin }));
  LooseSources loose = stones();
  loose.density_kg_per_m3["twin"] = stone_kg_per_m3;
  hand.session.setLoose(loose);
  hand.at(away, 200);
  EXPECT_THAT(hand.session.status<MechanismTask>().problem, HasSubstr("lies 0.01 u deep in"));
}

TEST(LooseSources, AUnitOfAMillimetreGivesABillionthOfTheMass)
{
  constexpr double perMetre = 1000.0;
  FreeHand hand;
  HapticParameters parameters = hand.session.parameters();
  parameters.map.scale_u_per_m = perMetre;
  parameters.contact.radius_u = perMetre * fingertip_m;
  ASSERT_EQ(hand.session.setParameters(parameters), "");
  SurfaceInput floor = floorInput(), stone = stoneInput();
  for (SurfaceInput* const each : { &floor, &stone })
  {
    each->mesh = std::make_shared<const TriangleMesh>(scaled(*each->mesh, perMetre));
  }
  hand.session.setScene(sceneOfAll({ floor, stone }));
  LooseSources loose = stones();
  loose.unit_m = 1.0 / perMetre;
  hand.session.setLoose(loose);
  hand.at(away, 500);
  EXPECT_NEAR(hand.pressOn("stone", "floor").z(), weight_N, 1e-9 * weight_N);
  EXPECT_NEAR(hand.middleOf("stone").z(), perMetre * half_m.z(), 1e-3);
}

TEST(LooseSources, PressedFromAboveItGivesTheHandTheForceOfItsSpringAndTheFloorThatAndItsWeight)
{
  constexpr double deep_m = 5e-4;
  FreeHand hand(0.3);
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  hand.session.setLoose(stones());
  const double top_m = 2.0 * half_m.z() + fingertip_m;
  hand.at(Vec3(0.001, 0.002, top_m + 1e-3), 200);
  for (double z = 1e-3; z > -deep_m; z -= 1e-5)
  {
    hand.at(Vec3(0.001, 0.002, top_m + z));
  }
  const Vec3 force_N = hand.at(Vec3(0.001, 0.002, top_m - deep_m), 500).force_W;
  EXPECT_NEAR(force_N.z(), firm_N_per_m * deep_m, 1e-3 * firm_N_per_m * deep_m);
  EXPECT_LE(force_N.head<2>().norm(), 1e-3 * force_N.z());
  EXPECT_NEAR(hand.pressOn("stone", "floor").z(), weight_N + force_N.z(), 1e-6 * force_N.z());
}

/// Statics: the wall bears all that the hand presses with, so that the ball stays where the stone's face is, with the
/// force of the hand's spring, however far the hand is ahead. Turned, the ball meets the face between its vertices.
TEST(LooseSources, PressedAgainstAWallItKeepsTheBallOutHoweverDeepTheHand)
{
  constexpr double friction = 0.3, gap_m = 1e-4, within_m = 1e-4;
  const SurfaceInput wall = surfaceOf("wall", makeBox(Vec3(half_m.x() + gap_m, -0.1, 0.0), Vec3(0.1, 0.1, 0.1)));
  for (const Quat& turn : { Quat::Identity(), Quat(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized())) })
  {
    FreeHand hand(friction);
    hand.session.setScene(sceneOfAll({ floorInput(), wall, stoneInput() }));
    hand.session.setLoose(stones());
    const double face_m = gap_m - half_m.x() - fingertip_m;
    const auto ahead = [&](double x_m, int ticks = 1) -> const HapticState& {
      return hand.hold({ Vec3(face_m + x_m, 0.0, half_m.z()), turn }, ticks);
    };
    ahead(-1e-3, 200);
    double x_m = -1e-3;
    for (const double radii : { 3.0, 8.0 })
    {
      for (; x_m < radii * fingertip_m; x_m += 5e-5)
      {
        const HapticState& now = ahead(x_m);
        EXPECT_LE(now.proxy_W.p.x(), hand.middleOf("stone").x() - half_m.x() - fingertip_m + within_m) << x_m;
        EXPECT_TRUE(now.mechanism.capped || now.mechanism.residual_u <= 1e-12) << x_m;
      }
      const HapticState& state = ahead(x_m, 500);
      EXPECT_LE((state.proxy_W.p - Vec3(face_m, 0.0, half_m.z())).norm(), within_m) << radii;
      const Vec3 expected_N = firm_N_per_m * (state.proxy_W.p - Vec3(face_m + x_m, 0.0, half_m.z()));
      EXPECT_LE((state.force_W - expected_N).norm(), 1e-6 * expected_N.norm()) << radii;
      EXPECT_NEAR(hand.pressOn("stone", "wall").x(), state.force_W.x(), friction * weight_N + 1e-6 * expected_N.norm())
        << radii << ": beside the friction of the floor";
    }
  }
}

/// A hand that pushes the stone along x from rest with that acceleration. Mean force on the hand over its last tenth.
double pushed_N(FreeHand& hand, double acceleration)
{
  constexpr int ticks = 300, last = 30;
  const double from_m = -half_m.x() - fingertip_m - 1e-5;
  hand.at(Vec3(from_m, 0.0, half_m.z()), 200);
  double sum_N = 0.0;
  for (int i = 1; i <= ticks; ++i)
  {
    const double t = handTick_s * i;
    const Vec3 force_N = hand.at(Vec3(from_m + 0.5 * acceleration * t * t, 0.0, half_m.z())).force_W;
    sum_N -= i > ticks - last ? force_N.x() : 0.0;
  }
  return sum_N / last;
}

TEST(LooseSources, TheBallPushesItByMassTimesAccelerationAndFriction)
{
  constexpr double acceleration = 1.5;
  for (const double friction : { 0.0, 0.3 })
  {
    FreeHand hand(friction);
    hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
    hand.session.setLoose(stones());
    const double expected_N = mass_kg * (acceleration + friction * g_m_per_s2);
    EXPECT_NEAR(pushed_N(hand, acceleration), expected_N, 0.02 * expected_N) << friction;
    EXPECT_GT(hand.middleOf("stone").x(), 0.9 * 0.5 * acceleration * 0.09);
  }
}

TEST(LooseSources, ATwiceAsDenseOneIsPushedByTwiceTheForce)
{
  double force_N[2] = {};
  for (const int times : { 1, 2 })
  {
    FreeHand hand(0.2);
    hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
    hand.session.setLoose(stones(times * stone_kg_per_m3));
    force_N[times - 1] = pushed_N(hand, 1.0);
  }
  EXPECT_NEAR(force_N[1], 2.0 * force_N[0], 0.02 * force_N[1]);
}

TEST(LooseSources, AnotherDensityWeighsAtOnceAndTheSceneMayComeAfterTheWish)
{
  FreeHand hand(0.3);
  hand.session.setLoose(stones());
  hand.at(away, 10);
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  hand.at(away, 500);
  EXPECT_NEAR(hand.pressOn("stone", "floor").z(), weight_N, 1e-6 * weight_N);
  hand.session.setLoose(stones(3.0 * stone_kg_per_m3));
  hand.at(away, 500);
  EXPECT_NEAR(hand.pressOn("stone", "floor").z(), 3.0 * weight_N, 1e-6 * weight_N);
}

TEST(LooseSources, TheBallRubsTheFixedFloorByItsFrictionAndDoesNotRoll)
{
  constexpr double friction = 0.3, deep_m = 3e-4;
  FreeHand hand(friction);
  hand.session.setLoose(stones());
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  Vec3 at(0.2, 0.2, fingertip_m + 1e-3);
  hand.at(at, 200);
  for (; at.z() > fingertip_m - deep_m; at.z() -= 1e-5)
  {
    hand.at(at);
  }
  for (int i = 0; i < 500; ++i)
  {
    at.y() += 2e-5;
    hand.at(at);
  }
  const HapticState& state = hand.session.state();
  EXPECT_GT(state.force_W.z(), 2.0);
  EXPECT_NEAR(-state.force_W.y() / state.force_W.z(), friction, 0.01 * friction);
  EXPECT_LE(state.proxy_W.q.angularDistance(Quat::Identity()), 0.1);
}

TEST(LooseSources, AFixedOneIsAWallOfTheScene)
{
  FreeHand hand;
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  hand.session.setLoose(stones());
  hand.session.setLoose({});
  EXPECT_FALSE(hand.session.toolPresses());
  EXPECT_GT(pushed_N(hand, 1.0), 0.9 * firm_N_per_m * 0.5 * 0.09 * 0.9);
  EXPECT_FALSE(hand.session.state().mechanism.held);
}

TEST(LooseSources, AnotherGravityPullsItThatWay)
{
  FreeHand hand(0.8);
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  LooseSources loose = stones();
  loose.gravity_m_per_s2 = Vec3(0.5, 0.0, -1.62);
  hand.session.setLoose(loose);
  hand.at(away, 500);
  const Vec3 force_N = hand.pressOn("stone", "floor");
  EXPECT_LE((force_N + mass_kg * loose.gravity_m_per_s2).norm(), 1e-6 * weight_N);
}

TEST(LooseSources, KeepsItsNameBesideTheBallAndTheToolInTheHand)
{
  for (const std::string name : { "ball", "tool", "ball in the hand" })
  {
    FreeHand hand;
    SurfaceInput stone = stoneInput();
    stone.name = name;
    hand.session.setScene(sceneOfAll({ floorInput(), stone }));
    LooseSources loose;
    loose.density_kg_per_m3 = { { name, stone_kg_per_m3 } };
    loose.unit_m = 1.0;
    hand.session.setLoose(loose);
    hand.at(away, 300);
    EXPECT_NEAR(hand.pressOn(name, "floor").z(), weight_N, 1e-6 * weight_N) << name;
  }
}

TEST(LooseSources, APointPushesItAsABallOfAFiftiethOfItsSize)
{
  constexpr double acceleration = 1.0, friction = 0.25;
  FreeHand hand(friction);
  HapticParameters parameters = hand.session.parameters();
  parameters.contact.radius_u = 0.0;
  ASSERT_EQ(hand.session.setParameters(parameters), "");
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  hand.session.setLoose(stones());
  const double expected_N = mass_kg * (acceleration + friction * g_m_per_s2);
  EXPECT_NEAR(pushed_N(hand, acceleration), expected_N, 0.02 * expected_N);
  const double ball_m = 0.02 * 2.0 * half_m.norm();
  EXPECT_NEAR(hand.middleOf("stone").x() - hand.session.state().proxy_W.p.x(), half_m.x() + ball_m, 0.01 * ball_m);
}

TEST(LooseSources, AToolPushesItToo)
{
  constexpr double acceleration = 1.0, friction = 0.25;
  FreeHand hand(friction);
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  hand.session.choose<ToolTask>(toolOf(makeBox(Vec3::Constant(-fingertip_m), Vec3::Constant(fingertip_m))));
  hand.session.setLoose(stones());
  ASSERT_TRUE(hand.session.toolPresses()) << hand.session.looseRefusal();
  const double expected_N = mass_kg * (acceleration + friction * g_m_per_s2);
  EXPECT_NEAR(pushed_N(hand, acceleration), expected_N, 0.02 * expected_N);
}

TEST(LooseSources, LiesOnASoftBodyThatBearsItsWeight)
{
  FreeHand hand(0.3);
  hand.session.choose<SoftTask>(padChoice());
  const Vec3 middle = middleOfPad();
  hand.session.setScene(sceneOfAll({ surfaceOf("block", makeBox(Vec3::Zero(), Vec3(0.1, 0.1, 0.05))),
    stoneInput(Vec3(middle.x(), middle.y(), middle.z() + 1e-4)) }));
  LooseSources loose = stones();
  loose.unit_m = 0.0; // the body's counts
  hand.session.setLoose(loose);
  hand.at(away, 3000);
  ASSERT_TRUE(hand.session.toolPresses()) << hand.session.looseRefusal();
  EXPECT_NEAR(hand.pressOn("stone", "block").z(), weight_N, 0.01 * weight_N);
  EXPECT_LT(hand.middleOf("stone").z(), middle.z() + half_m.z()) << "it has sunk in";
}

TEST(LooseSources, PutBackIsWhereItsSourceIs)
{
  FreeHand hand(0.3);
  EXPECT_FALSE(hand.session.putBack());
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  hand.session.setLoose(stones());
  (void)pushed_N(hand, 1.0);
  ASSERT_GT(hand.middleOf("stone").x(), 0.03);
  hand.at(away, 1000); // where the ball comes after the hand
  EXPECT_TRUE(hand.session.putBack());
  hand.at(away, 200);
  EXPECT_LE((hand.middleOf("stone") - Vec3(0, 0, half_m.z())).norm(), 1e-6);
}

TEST(LooseSources, TheHandThatIsWhereOneWouldBePutBackIsKnown)
{
  FreeHand hand(0.3);
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  hand.session.setLoose(stones());
  const auto inHand = [&]
  { return looseInHand(hand.session.feltMechanism()->mechanism, hand.session.state().mechanism.hand_W); };
  (void)pushed_N(hand, 2.0); // by 9 cm: the hand is then where the stone's front was
  ASSERT_GT(hand.middleOf("stone").x() - half_m.x(), half_m.x()) << "the stone has left its place";
  EXPECT_EQ(inHand(), "");
  const double inside_m = 1e-4;
  hand.at(Vec3(half_m.x() + fingertip_m - inside_m, 0.0, half_m.z()), 200);
  EXPECT_EQ(inHand(), "stone");
  hand.at(Vec3(half_m.x() + fingertip_m + inside_m, 0.0, half_m.z()), 200);
  EXPECT_EQ(inHand(), "");
}

TEST(LooseSources, OneThatIsDeletedWhileItIsPressedLeavesTheHandWithoutAJump)
{
  constexpr double deep_m = 1e-3;
  constexpr int fades = 30; // ticks of the blend
  FreeHand hand;
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  hand.session.setLoose(stones());
  const Vec3 over(0.0, 0.0, 2.0 * half_m.z() + fingertip_m);
  hand.at(over + Vec3(0, 0, 1e-3), 200);
  for (double z = 1e-3; z > -deep_m; z -= 1e-5)
  {
    hand.at(over + Vec3(0, 0, z));
  }
  Vec3 before_N = hand.at(over - Vec3(0, 0, deep_m), 300).force_W;
  ASSERT_NEAR(before_N.z(), firm_N_per_m * deep_m, 0.01 * firm_N_per_m * deep_m);
  const double most_N = 2.0 * before_N.z() / fades;
  hand.session.setScene(sceneOfAll({ floorInput() }));
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 now_N = hand.at(over - Vec3(0, 0, deep_m)).force_W;
    ASSERT_LE((now_N - before_N).norm(), most_N) << i;
    before_N = now_N;
  }
  EXPECT_LE(before_N.norm(), 1e-3) << "ten time constants";
  EXPECT_FALSE(hand.session.state().mechanism.held);
}

TEST(LooseSources, ASessionIsReplayedBitForBit)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("recording");
  {
    FreeHand hand(0.3, file);
    hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
    hand.session.setLoose(stones());
    EXPECT_GT(pushed_N(hand, 1.0), 0.1);
    EXPECT_EQ(hand.session.stop(), "");
  }
  const auto read = readRecording(file);
  ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  const ReplayResult result = replay(std::get<Recording>(read));
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_GT(result.ticks, 400U);
}

/// Why a source of a scene is not loose; "" where all are.
std::string refusalOf(const std::vector<SurfaceInput>& surfaces, const LooseSources& loose, const SoftChoice& soft = {})
{
  FreeHand hand;
  hand.session.choose<SoftTask>(soft);
  hand.session.setScene(sceneOfAll(surfaces));
  hand.session.setLoose(loose);
  EXPECT_EQ(hand.session.toolPresses(), hand.session.looseRefusal().empty());
  const std::string refusal = hand.session.looseRefusal();
  hand.at(away, 100);
  EXPECT_EQ(hand.session.state().mechanism.held, refusal.empty()) << "else they are touched as fixed";
  hand.session.setLoose({});
  EXPECT_EQ(hand.session.looseRefusal(), "");
  return refusal;
}

TEST(LooseSources, ASourceThatCannotBeLooseIsNamedWithTheReasonAndTheRemedy)
{
  EXPECT_EQ(refusalOf({ floorInput(), stoneInput() }, stones()), "");
  TriangleMesh open = *stoneInput().mesh;
  open.triangles.pop_back();
  EXPECT_THAT(refusalOf({ floorInput(), surfaceOf("stone", open) }, stones()),
    AllOf(StartsWith("stone cannot be loose: the mesh is open"), HasSubstr("it is touched as fixed now; repair")));
  for (const double density : { 0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("") })
  {
    EXPECT_THAT(refusalOf({ floorInput(), stoneInput() }, stones(density)),
      AllOf(StartsWith("stone cannot be loose: "), HasSubstr("density")))
      << density;
  }
  EXPECT_THAT(
    refusalOf({ floorInput(), surfaceOf("stone", shifted(makeIcosphere(5, 0.02), Vec3(0, 0, 0.03))) }, stones()),
    AllOf(HasSubstr("20480 triangles"), HasSubstr("20000"), HasSubstr("simplify")));
  LooseSources unknown = stones();
  unknown.unit_m = 0.0;
  EXPECT_THAT(refusalOf({ floorInput(), stoneInput() }, unknown), HasSubstr("choose the unit of lengths"));
  EXPECT_THAT(refusalOf({ surfaceOf("floor", open), stoneInput(Vec3(0.2, 0, 0)) }, stones()),
    AllOf(StartsWith("stone cannot be loose beside floor: the mesh is open"),
      HasSubstr("it is touched as fixed now; hide floor")));
}

TEST(LooseSources, SixSurfacesAreTheMostAndALooseOneCounts)
{
  std::vector<SurfaceInput> surfaces = { floorInput() };
  for (int i = 0; i < 4; ++i)
  {
    const Vec3 low(0.1 * i, 0.2, 0.01);
    surfaces.push_back(surfaceOf("post " + std::to_string(i), makeBox(low, low + Vec3::Constant(0.05))));
  }
  surfaces.push_back(stoneInput());
  EXPECT_EQ(refusalOf(surfaces, stones()), "");
  surfaces.insert(surfaces.begin(), surfaceOf("wall", makeBox(Vec3(-0.4, -0.4, 0.01), Vec3(-0.3, -0.3, 0.1))));
  EXPECT_EQ(refusalOf(surfaces, stones()),
    "stone cannot be loose: the hand then touches at most 6 surfaces, loose ones included, and 7 are there; it is "
    "touched as fixed now; hide another source");
}

TEST(LooseSources, TheSoftBodyIsNotLooseAsWell)
{
  LooseSources both = stones();
  both.density_kg_per_m3["block"] = 1000.0;
  EXPECT_THAT(refusalOf({ surfaceOf("block", makeBox(Vec3::Zero(), Vec3(0.1, 0.1, 0.05))), stoneInput(Vec3(-0.3, 0, 0)),
                          floorInput() },
                both, padChoice()),
    AllOf(StartsWith("block cannot be loose: it is the soft body"), HasSubstr("touch it as one of the two")));
}

TEST(LooseSources, AreNotFeltWhileAMechanismIsHeld)
{
  FreeHand hand;
  hand.session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  hand.session.setLoose(stones());
  const auto inputs = hand.session.feltMechanism();
  ASSERT_TRUE(inputs);
  hand.session.choose<MechanismTask>({ std::make_shared<const MechanismInputs>(*inputs), "held", 30.0 });
  EXPECT_FALSE(hand.session.toolPresses());
  hand.session.choose<MechanismTask>({});
  EXPECT_TRUE(hand.session.toolPresses());
}

} // namespace
} // namespace palpate::test
