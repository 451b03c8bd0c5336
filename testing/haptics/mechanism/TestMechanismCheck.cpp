// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include <gtest/gtest.h>

#include "haptics/mechanism/check/BodiesOverlap.h"
#include "testing/support/MechanismRig.h"
#include "testing/support/Says.h"

namespace palpate::test
{
namespace
{

class Checked : public testing::Test
{
protected:
  Checked()
  {
    this->rig.addSoft("wall", springWall("wall", Vec3(0.0, 0.0, 0.05), -Vec3::UnitZ(), 0.02, 2e-3));
    this->rig.addSoft("liver", springWall("liver", Vec3(0.0, 0.0, 0.15), -Vec3::UnitZ(), 0.02, 5e-3));
    this->rig.join(ConstraintKind::Insertion, "wall", Vec3::Zero(), Vec3(0.0, 0.0, 0.05)).name = "hole";
    this->rig.join(ConstraintKind::Puncture, "liver", Vec3::Zero(), Vec3::Zero()).name = "entry";
  }

  MechanismRig rig{ 0.2 };
};

TEST_F(Checked, AMechanismIsSaidToBecomeRowsRankAndFreeTurns)
{
  const MechanismCheck check = this->rig.check();
  EXPECT_TRUE(check.faults.empty());
  EXPECT_EQ(check.rows, 8);
  // Both dry rows are along one rod, but through two tissues of their own, and so are its ends at the hub, along the
  // same directions.
  EXPECT_EQ(check.rank, 6);
  EXPECT_EQ(check.freeTurns, 0);
  EXPECT_TRUE(check.redundant.empty());
  this->rig.grip.turning_Nu_per_rad = 0.0;
  const MechanismCheck free = this->rig.check();
  EXPECT_EQ(free.freeTurns, 3);
  EXPECT_EQ(free.free, std::vector<std::string>{ "needle" }); // about its own axis nothing holds it
}

struct Wrong
{
  const char* name;
  std::function<void(MechanismRig&)> change;
  const char* says;
};

void PrintTo(const Wrong& wrong, std::ostream* out)
{
  *out << wrong.name;
}

class WrongMechanism
  : public Checked
  , public testing::WithParamInterface<Wrong>
{
};

TEST_P(WrongMechanism, IsRefusedInASentenceThatSaysWhatIsWrong)
{
  GetParam().change(this->rig);
  const MechanismCheck check = this->rig.check();
  EXPECT_TRUE(std::ranges::any_of(
    check.faults, [](const std::string& fault) { return fault.find(GetParam().says) != std::string::npos; }))
    << (check.faults.empty() ? "no fault" : check.faults.front());
}

const Vec3 aside(0.0, 0.0, 0.01);

INSTANTIATE_TEST_SUITE_P(All, WrongMechanism,
  testing::Values(Wrong{ "JoinedToItself", [](MechanismRig& r) { r.mechanism.laws[0].b = "needle"; }, "to itself" },
    Wrong{ "JoinedToNothing", [](MechanismRig& r) { r.mechanism.laws[0].b = "spleen"; }, "no body has that name" },
    Wrong{ "SoftBodyIsGone", [](MechanismRig& r) { r.soft.pop_back(); }, "\"liver\" is missing" },
    Wrong{ "BreakForceOf0",
      [](MechanismRig& r) { r.join(ConstraintKind::Break, "world", Vec3::Zero(), Vec3::Zero()).strength_N = 0.0; },
      "breaks at 0 N" },
    Wrong{
      "StrengthIsNoNumber", [](MechanismRig& r) { r.mechanism.laws[1].strength_N = std::nan(""); }, "breaks at 0 N" },
    Wrong{ "JointBeyondTheTip",
      [](MechanismRig& r) { r.join(ConstraintKind::Attachment, "world", 0.21 * Vec3::UnitZ(), Vec3::Zero()); },
      "outside of \"needle\"" },
    Wrong{ "HoleBesideTheWall", [](MechanismRig& r) { r.mechanism.laws[0].point_B = Vec3(0.0, 0.1, 0.05); },
      "outside of \"wall\"" },
    Wrong{ "LimitTurnedRound",
      [](MechanismRig& r)
      {
        MechanismConstraint& law = r.join(ConstraintKind::Limit, "world", Vec3::Zero(), Vec3::Zero());
        law.least_u = 1.0;
        law.most_u = -1.0;
      },
      "empty range" },
    Wrong{ "HeldInTwoPlaces",
      [](MechanismRig& r)
      {
        r.join(ConstraintKind::Attachment, "world", Vec3::Zero(), Vec3::Zero());
        r.join(ConstraintKind::Attachment, "world", Vec3::Zero(), aside);
      },
      "conflicts with the others" },
    Wrong{ "RodBetweenPointsThatAreTooFarApart",
      [](MechanismRig& r)
      {
        r.join(ConstraintKind::Attachment, "world", Vec3::Zero(), Vec3::Zero());
        r.join(ConstraintKind::Attachment, "world", 0.1 * Vec3::UnitZ(), 0.11 * Vec3::UnitZ());
      },
      "conflicts with the others" },
    Wrong{ "ContactsFromBothSidesOfNoRoom",
      [](MechanismRig& r)
      {
        r.join(ConstraintKind::Contact, "world", Vec3::Zero(), Vec3(0.05, 0.0, 0.0)).axis_B = Vec3::UnitX();
        r.join(ConstraintKind::Contact, "world", Vec3::Zero(), Vec3::Zero()).axis_B = -Vec3::UnitX();
      },
      "conflicts with the others" },
    Wrong{ "StiffLimitBesideAnAttachment",
      [](MechanismRig& r)
      {
        r.join(ConstraintKind::Attachment, "world", Vec3::Zero(), Vec3::Zero());
        MechanismConstraint& limit = r.join(ConstraintKind::Limit, "world", Vec3::Zero(), Vec3::Zero());
        limit.axis_B = Vec3::UnitX();
        limit.least_u = 0.1;
      },
      "conflicts with the others" },
    Wrong{ "RestBeyondAllNumbers",
      [](MechanismRig& r) { r.join(ConstraintKind::Spring, "world", Vec3::Zero(), Vec3::Zero()).rest_u = 1e308; },
      "a position beyond 1e9" },
    Wrong{ "RodBeyondAllNumbers", [](MechanismRig& r) { r.mechanism.bodies[0].length_u = 1e300; }, "no length" },
    Wrong{ "MoreRowsThanTheBudget",
      [](MechanismRig& r)
      {
        for (int i = 0; i < 10; ++i)
        {
          r.join(ConstraintKind::Hinge, "world", Vec3::Zero(), Vec3::Zero());
        }
      },
      "rows, at most 48" },
    Wrong{ "TwoInTheHand",
      [](MechanismRig& r)
      {
        r.mechanism.bodies.push_back(r.mechanism.bodies.front());
        r.mechanism.bodies.back().name = "second";
      },
      "in the hand, at most 1" },
    Wrong{ "OneNameTwice", [](MechanismRig& r) { r.mechanism.laws[1].name = "hole"; }, "a unique name" },
    Wrong{ "RodWithoutLength", [](MechanismRig& r) { r.mechanism.bodies[0].length_u = 0.0; }, "no length" },
    Wrong{ "HingeOfASoftBody",
      [](MechanismRig& r) { r.join(ConstraintKind::Hinge, "wall", Vec3::Zero(), Vec3(0.0, 0.0, 0.05)); },
      "no rotation of its own" },
    Wrong{ "PunctureOfTheWorld", [](MechanismRig& r) { r.mechanism.laws[1].b = "world"; }, "needs a soft body" },
    Wrong{ "AxisWithoutDirection", [](MechanismRig& r) { r.mechanism.laws[0].axis_B.setZero(); }, "axis of length 0" },
    Wrong{ "FrictionThatNothingDividesAmongItsPoints",
      [](MechanismRig& r)
      {
        r.grip.turning_Nu_per_rad = 0.0;
        for (const double z : { 0.0, 0.1, 0.2 })
        {
          r.join(ConstraintKind::Friction, "world", z * Vec3::UnitZ(), z * Vec3::UnitZ()).friction = 0.3;
        }
      },
      "share of the friction is undetermined" },
    Wrong{ "LoadOnABodyThatNoLawJoins",
      [](MechanismRig& r)
      {
        MechanismBody block;
        block.name = "block";
        block.kind = MechanismBodyKind::Rigid;
        block.halfSize_u = Vec3::Constant(0.01);
        block.load_W = Vec3(0.0, 0.0, -1.0);
        r.mechanism.bodies.push_back(block);
      },
      "No constraint supports body \"block\" against its load" },
    Wrong{ "HandWithoutStiffness", [](MechanismRig& r) { r.grip.coupling_N_per_u = 0.0; }, "holds no body" }),
  [](const testing::TestParamInfo<Wrong>& info) { return info.param.name; });

TEST(CheckedBodies, ThatOverlapAsTheyStandAreSaidAndSuchThatTouchAreNot)
{
  const auto stand = [](const Vec3& at, const Quat& turn)
  {
    MechanismRig rig;
    for (const auto& [name, p, q] :
      { std::tuple("table", Vec3(0.0, 0.0, -1.0), Quat(Quat::Identity())), std::tuple("box", at, turn) })
    {
      MechanismBody body;
      body.name = name;
      body.kind = MechanismBodyKind::Rigid;
      body.halfSize_u = Vec3::Ones();
      body.pose_W = { p, q };
      rig.mechanism.bodies.push_back(body);
      rig.join(ConstraintKind::Attachment, "world", Vec3::Zero(), p).a = name;
    }
    return rig.check();
  };
  const Quat upright = Quat::Identity();
  const Quat onEdge(Eigen::AngleAxisd(M_PI / 4.0, Vec3::UnitX()));
  EXPECT_TRUE(stand(Vec3(0.3, 0.2, 1.0), upright).overlaps.empty()) << "it stands on the table";
  EXPECT_TRUE(stand(Vec3(3.0, 0.0, 0.0), upright).overlaps.empty());
  EXPECT_TRUE(stand(Vec3(0.0, 0.0, std::sqrt(2.0) + 1e-3), onEdge).overlaps.empty());
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  const Pairs both{ { "table", "box" } };
  EXPECT_EQ(stand(Vec3(0.3, 0.2, 0.99), upright).overlaps, both);
  EXPECT_EQ(stand(Vec3(0.0, 0.0, std::sqrt(2.0) - 1e-3), onEdge).overlaps, both);
  EXPECT_EQ(stand(Vec3(0.0, 0.0, -1.0), upright).overlaps, both) << "the one is in the other's place";
  const MechanismCheck said = stand(Vec3(0.0, 0.0, 0.9), upright);
  ASSERT_TRUE(said.faults.empty());
  EXPECT_NE(std::ranges::find(said.remarks, "Bodies \"table\" and \"box\" overlap in the scene file: bodies without a "
                                            "constraint between them pass through each other."),
    said.remarks.end());
}

TEST(CheckedBodies, ARigidOneThatPassesThroughASoftSurfaceIsSaid)
{
  for (const double height : { 0.3, 0.02, -0.3 })
  {
    MechanismRig rig;
    rig.addSoft("wall", springWall("wall", Vec3::Zero(), Vec3::UnitZ(), 0.5, 2e-3));
    MechanismBody body;
    body.name = "box";
    body.kind = MechanismBodyKind::Rigid;
    body.halfSize_u = Vec3::Constant(0.1);
    body.pose_W.p = Vec3(0.05, 0.02, height);
    rig.mechanism.bodies.push_back(body);
    rig.join(ConstraintKind::Attachment, "world", Vec3::Zero(), body.pose_W.p).a = "box";
    EXPECT_EQ(rig.check().overlaps.size(), std::abs(height) < 0.1 ? 1u : 0u) << height;
  }
}

/// A needle of .2 m below a wall and a box above it, and a watch of the ticks.
class WatchedBodies : public testing::Test
{
protected:
  WatchedBodies()
  {
    this->rig.addSoft("wall", springWall("wall", Vec3::Zero(), -Vec3::UnitZ(), 0.5, 2e-3));
    MechanismBody box;
    box.name = "box";
    box.kind = MechanismBodyKind::Rigid;
    box.halfSize_u = Vec3::Constant(0.1);
    box.pose_W.p = Vec3(0.0, 0.0, 0.15); // from .05 on
    this->rig.mechanism.bodies.push_back(box);
    this->rig.join(ConstraintKind::Attachment, "world", Vec3::Zero(), box.pose_W.p).a = "box";
  }

  /// With the needle's tip so high above the wall.
  [[nodiscard]] std::vector<BodyPair> at(double tip)
  {
    const MechanismResult& r = this->rig.step(Vec3(0.01, 0.02, tip - 0.2));
    std::array<ConstraintPhase, Mechanism::mostConstraints> phases{};
    std::ranges::transform(r.laws, phases.begin(), [](const ConstraintNow& law) { return law.phase; });
    return this->watch.look(this->rig.mechanism, this->rig.soft, r.pose_W, phases);
  }

  MechanismRig rig{ 0.2 };
  OverlapWatch watch;
};

TEST_F(WatchedBodies, ANeedleInAWallOrABoxThatNoLawJoinsItToIsNamedAsLongAsItIsThere)
{
  const BodyPair wall("needle", "wall"), box("needle", "box");
  EXPECT_TRUE(this->at(-0.01).empty());
  EXPECT_EQ(this->at(0.01), std::vector{ wall });
  EXPECT_EQ(this->at(0.07), (std::vector{ wall, box }));
  EXPECT_EQ(this->at(0.19), (std::vector{ wall, box })) << "it has gone into the box and not out of it";
  EXPECT_TRUE(this->at(-0.05).empty());
  EXPECT_TRUE(test::says(overlapText(wall), { "\"needle\"", "\"wall\"", "overlap", "constraint" }));
}

TEST_F(WatchedBodies, ANeedleThatHasPuncturedAWallIsNotNamedAndOneThatCameBehindItIs)
{
  this->rig.join(ConstraintKind::Puncture, "wall", Vec3::Zero(), Vec3::Zero()).strength_N = 0.5;
  EXPECT_TRUE(this->at(-0.01).empty());
  EXPECT_TRUE(this->at(2e-4).empty()) << "it is pressed on";
  EXPECT_TRUE(this->at(0.02).empty()) << "it is in";
  ASSERT_EQ(this->rig.tick.state().laws[1].phase, ConstraintPhase::Inside);
  this->rig.plan(); // begins anew where the hand is, and the wall is whole
  EXPECT_EQ(this->at(0.02), (std::vector{ BodyPair("needle", "wall") }));
}

TEST_F(WatchedBodies, ABoxThatItsLawHoldsOnAWallIsNotNamedAndOneThatFallsThroughItIs)
{
  const auto put = [this](double height)
  {
    Mechanism& m = this->rig.mechanism;
    m.bodies.back().pose_W.p = m.laws[0].point_B = Vec3(0.3, 0.0, height);
    this->rig.plan();
  };
  put(-0.3);
  EXPECT_TRUE(this->at(-0.05).empty());
  put(-0.05);
  EXPECT_EQ(this->at(-0.15), (std::vector{ BodyPair("wall", "box") }));
  this->rig.join(ConstraintKind::Attachment, "wall", Vec3(0.0, 0.0, 0.05), Vec3(0.3, 0.0, 0.0)).a = "box";
  this->rig.plan();
  EXPECT_TRUE(this->at(-0.5).empty()) << "the law says how they meet";
}

} // namespace
} // namespace palpate::test
