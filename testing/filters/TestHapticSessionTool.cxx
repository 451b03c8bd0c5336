// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh in the hand of a session: the held tool, its texts, its refusals. Virtual time.
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "SoftBlockPush.h"
#include "VirtualSession.h"
#include "VtkScenes.h"
#include "haptics/session/HapticSession.h"
#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkHapticHandPace.h"
#include "vtkHapticServerSurfaces.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkHapticToolProps.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkTouchAlongPath.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

namespace
{
constexpr double springOfTool = 300.0; // N/m
constexpr double halfSide = 5.0;       // u, of the cube
constexpr int ticksToRest = 1000;      // updates, and the blend of 30 ms

/// A cube whose data lie around (100, 0, 0).
vtkSmartPointer<vtkPolyData> cubeFarAway()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(2.0 * halfSide);
  cube->SetYLength(2.0 * halfSide);
  cube->SetZLength(2.0 * halfSide);
  cube->SetCenter(100.0, 0.0, 0.0);
  cube->Update();
  return cube->GetOutput();
}

class HapticSessionTool : public VirtualSession
{
protected:
  HapticSessionTool()
  {
    this->session_->SetSetting("Passivity", false);
    this->session_->SetSetting("Stiffness", springOfTool);
    this->show(makePlane(40.0));
    this->session_->SetSetting("ToolSource", "Cube1");
  }

  void touchAt(double z)
  {
    this->session_->SetHandPosition(0.0, 0.0, z);
    this->session_->TouchingOn();
    this->session_->Step(ticksToEngage);
  }

  void goTo(double z)
  {
    this->session_->SetHandPosition(0.0, 0.0, z);
    this->session_->Step(ticksToRest);
  }
};

TEST_F(HapticSessionTool, NeedsOfAServersSurfaceAllThatItReaches)
{
  const auto reach = [this] { return this->session_->GetSight()->ServerSurfaces().GetReach(); };
  const double ahead = vtkHapticHandPace::fastest_m_per_s * vtkHapticHandPace::ahead_s * scale;
  this->session_->SetHandPosition(0.0, 0.0, 20.0);
  const double bare = reach();
  ASSERT_TRUE(this->session_->AddTool("Cube1", cubeFarAway()));
  const double corner = std::sqrt(3.0) * halfSide;
  EXPECT_NEAR(reach(), 2.0 * (ahead + corner), 1e-9);
  this->touchAt(halfSide + 5.0);
  this->goTo(halfSide - 2.0); // which pulls by 2
  EXPECT_NEAR(reach(), 2.0 * (ahead + corner + 2.0), 1e-3);
  vtkNew<vtkSphereSource> ball; // felt as a ball
  ball->SetRadius(halfSide);
  ball->SetThetaResolution(100);
  ball->SetPhiResolution(100);
  ball->Update();
  ASSERT_TRUE(this->session_->AddTool("Cube1", ball->GetOutput()));
  this->goTo(halfSide + 5.0);
  EXPECT_NEAR(reach(), 2.0 * (ahead + halfSide), 1e-2);
  this->session_->AddTool(nullptr, nullptr);
  this->goTo(20.0);
  EXPECT_NEAR(reach(), bare, 1e-9);
}

TEST_F(HapticSessionTool, LiesOnASurfaceAndPushesTheHandThatHoldsItsCentre)
{
  ASSERT_TRUE(this->session_->AddTool("Cube1", cubeFarAway()));
  this->touchAt(halfSide + 5.0);
  EXPECT_THAT(this->session_->GetToolText(), HasSubstr("Cube1, 12 triangles"));
  this->goTo(halfSide - 2.0);
  const double* const force = this->session_->GetForce();
  EXPECT_NEAR(force[2], springOfTool * 2.0 / scale, 1e-5);
  EXPECT_NEAR(force[0], 0.0, 1e-9);
  // Its data lie at x = 100, so their origin is 100 to the left of the hand.
  const double* const pose = this->session_->GetToolPose();
  EXPECT_NEAR(pose[0], -100.0, 1e-5);
  EXPECT_NEAR(pose[2], halfSide, 1e-4);
  EXPECT_NEAR(this->session_->GetToolHandPose()[2], halfSide - 2.0, 1e-12);
  EXPECT_GT(this->session_->GetContacts(), 0);
  EXPECT_THAT(this->session_->GetToolText(), HasSubstr(" contacts"));
  EXPECT_THAT(this->session_->GetToolContacts(), HasSubstr("surface at ("));
  EXPECT_THAT(this->session_->GetToolContacts(), HasSubstr(" %"));
  ASSERT_TRUE(this->session_->InspectContact());
  EXPECT_NEAR(this->session_->GetContactPosition()[2], 0.0, 1e-9) << "on the plane, not at the hand";
  const double up[3] = { 0.0, 0.0, 1.0 };
  EXPECT_NEAR(this->session_->GetSight()->GetToolReach(up), halfSide, 1e-9);
}

TEST_F(HapticSessionTool, TurnsWithTheHandAndSaysTheTorqueThatADeviceWithoutOneCannotGive)
{
  ASSERT_TRUE(this->session_->AddTool("Cube1", cubeFarAway()));
  this->touchAt(halfSide + 5.0);
  this->goTo(halfSide - 2.0);
  const double angle = 0.05;
  this->session_->SetHandTurn(std::cos(0.5 * angle), 0.0, std::sin(0.5 * angle), 0.0);
  this->session_->Step(ticksToRest);
  // Pressed by K d the flat cube tips only beyond K d h = K L^2 a, so it lies; K L^2 a turns back. Of a solid cube of
  // side s: L^2 = s^2 / 6.
  const double side_m = 2.0 * halfSide / scale;
  const double expected = springOfTool * side_m * side_m / 6.0 * angle;
  EXPECT_NEAR(this->session_->GetToolTorque()[1], -expected, 1e-3 * expected);
  EXPECT_NEAR(this->session_->GetToolPose()[3], 1.0, 1e-9) << "it lies flat";
  EXPECT_NEAR(this->session_->GetToolHandPose()[3], std::cos(0.5 * angle), 1e-9);
  EXPECT_EQ(this->session_->GetTorque()[1], 0.0);
}

TEST_F(HapticSessionTool, IsHeldAtTheOriginOfItsDataIfThatIsWanted)
{
  this->session_->SetSetting("ToolHandle", 1);
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(10.0);
  cube->SetYLength(10.0);
  cube->SetZLength(10.0);
  cube->SetCenter(0.0, 0.0, 20.0);
  cube->Update();
  ASSERT_TRUE(this->session_->AddTool("Cube1", cube->GetOutput()));
  this->touchAt(-10.0);
  this->goTo(-16.0); // the lower face would be 1 below the plane
  EXPECT_NEAR(this->session_->GetToolPose()[2], -15.0, 1e-4);
  EXPECT_NEAR(this->session_->GetForce()[2], springOfTool * 1.0 / scale, 1e-5);
}

TEST_F(HapticSessionTool, IsHeldAtAHandleAndTurnsAboutItByTheWayToItsTip)
{
  ASSERT_TRUE(this->session_->AddTool("Cube1", cubeFarAway())); // its middle at x = 100
  this->session_->SetSetting("ToolHandlePoint", 100.0, 0.0, halfSide);
  this->session_->SetSetting("ToolTipPoint", 100.0, 0.0, -3.0 * halfSide);
  this->session_->SetSetting("ToolHandle", 2);
  this->touchAt(2.0 * halfSide + 5.0);
  this->goTo(2.0 * halfSide - 2.0);
  EXPECT_NEAR(this->session_->GetToolTip()[2], -2.0 * halfSide, 1e-4) << "the cube lies, its tip is a side below it";
  EXPECT_NEAR(this->session_->GetToolTip()[0], 0.0, 1e-5);
  EXPECT_NEAR(this->session_->GetForce()[2], springOfTool * 2.0 / scale, 1e-5);
  const double angle = 0.002; // K d h would let it lie up to K L^2 a = K d h, a = 0.0125
  this->session_->SetHandTurn(std::cos(0.5 * angle), 0.0, std::sin(0.5 * angle), 0.0);
  this->session_->Step(ticksToRest);
  const double lever_m = 4.0 * halfSide / scale;
  const double expected = springOfTool * lever_m * lever_m * angle;
  EXPECT_NEAR(this->session_->GetToolTorque()[1], -expected, 1e-3 * expected);
}

TEST_F(HapticSessionTool, WhoseHandleIsFarAwayIsRefusedInWords)
{
  ASSERT_TRUE(this->session_->AddTool("Cube1", cubeFarAway()));
  this->session_->SetSetting("ToolHandle", 2);
  EXPECT_THAT(errorsOf(this->session_, [&] { this->session_->SetSetting("ToolHandlePoint", 1e6, 1.0, 0.0); }),
    ElementsAre(HasSubstr("the handle lies far outside of the tool")));
  EXPECT_TRUE(errorsOf(this->session_, [&] { this->session_->SetSetting("ToolHandle", 0); }).empty())
    << "held at its centre again";
}

TEST_F(HapticSessionTool, WithoutItsSourceOrWithDataThatCannotBeHeldSaysSoAndTheBallTouches)
{
  EXPECT_STREQ(this->session_->GetToolText(), "Cube1 is chosen; press Touch") << "nobody has looked for it yet";
  static_cast<void>(this->session_->AddTool("Cube1", nullptr));
  EXPECT_THAT(this->session_->GetToolText(), HasSubstr("Cube1 does not exist"));
  vtkNew<vtkPolyData> nothing;
  const auto refused = [this](const std::function<void()>& change) { return errorsOf(this->session_, change).size(); };
  EXPECT_EQ(refused([&] { this->session_->AddTool("Cube1", nothing); }), 1u);
  EXPECT_THAT(this->session_->GetToolText(), HasSubstr("Cube1 cannot be held"));
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("Cube1 cannot be held"));
  EXPECT_TRUE(this->session_->AddTool("Cube1", cubeFarAway()));
  EXPECT_STREQ(this->session_->GetProblem(), "") << "taken back";
  EXPECT_EQ(refused([&] { this->session_->SetHandTurn(0.0, 0.0, 0.0, 0.0); }), 1u);
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("quaternion"));
  this->session_->SetSetting("ToolSource", "");
  EXPECT_STREQ(this->session_->GetToolText(), "");
  this->touchAt(5.0);
  this->goTo(-1.0);
  EXPECT_NEAR(this->session_->GetForce()[2], springOfTool * 1.0 / scale, 1e-9) << "by the ball";
}

/// A session in virtual time with the tool Cube1 and the soft body "block", whose top is z = 0.
struct ToolOnBlock
{
  ToolOnBlock()
  {
    this->session->SetSetting("VirtualTime", true);
    this->session->SetSetting("Passivity", false);
    this->session->SetSetting("Stiffness", springOfTool);
    this->session->SetSetting("Scale", scale);
    this->session->SetSetting("ToolSource", "Cube1");
    this->session->SetSetting("SoftSource", "block");
  }

  void touch(double z)
  {
    this->handAt(z);
    this->session->TouchingOn();
    this->session->Step(ticksToEngage);
  }

  /// By a tenth of a unit in two ticks, so that contacts are looked for in time.
  void lower(double from, double to)
  {
    for (double z = from; z > to; z -= 0.1)
    {
      this->handAt(z);
      this->session->Step(2);
    }
    this->handAt(to);
    this->session->Step(ticksToRest);
  }

  void handAt(double z) { this->session->SetHandPosition(this->place.x(), this->place.y(), z); }

  Vec3 place{ 3.0, 1.0, 0.0 }; ///< above which the hand comes down
  vtkNew<vtkHapticSession> session;
  vtkSmartPointer<vtkUnstructuredGrid> body = makeSoftBlock(100.0, 1.0 / scale);
};

TEST_F(HapticSessionTool, PressesABodyThatGivesWayInWhicheverOrderTheyComeAsTheFilterSaysAndTheBodyIsBent)
{
  constexpr double deep = 2.0;
  vtkNew<vtkCubeSource> cube; // over nine vertices of the block
  cube->SetXLength(70.0);
  cube->SetYLength(70.0);
  cube->SetZLength(2.0 * halfSide);
  cube->Update();
  double felt_N = 0.0;
  for (const bool toolFirst : { true, false })
  {
    ToolOnBlock on;
    const auto session = vtkSmartPointer<vtkHapticSession>(on.session);
    const auto hold = [&] { return session->AddTool("Cube1", cube->GetOutput()); };
    EXPECT_TRUE(toolFirst ? hold() : session->AddSoftBody("block", on.body));
    EXPECT_TRUE(toolFirst ? session->AddSoftBody("block", on.body) : hold());
    EXPECT_STREQ(session->GetProblem(), "");
    on.touch(halfSide + 1.0);
    EXPECT_THAT(session->GetToolText(), HasSubstr("presses block"));
    EXPECT_THAT(session->GetToolText(), HasSubstr("0 contacts"));
    on.lower(halfSide + 1.0, halfSide - deep);
    felt_N = session->GetForce()[2];
    EXPECT_GT(felt_N, 0.02);
    EXPECT_LT(felt_N, 0.99 * springOfTool * deep / scale) << "it gives way";
    EXPECT_GE(session->GetContacts(), 4);
    EXPECT_NEAR(session->GetToolHandPose()[2], halfSide - deep, 1e-9);
    const double yields = halfSide - session->GetToolPose()[2];
    EXPECT_NEAR(felt_N, springOfTool * (deep - yields) / scale, 1e-6);
    EXPECT_THAT(session->GetSoftText(), HasSubstr("ms old"));
    EXPECT_GT(session->GetSoftStrain(), 0.0);
    vtkNew<vtkUnstructuredGrid> shown;
    shown->DeepCopy(on.body);
    EXPECT_TRUE(session->BendSoftBody(shown));
    const Vec3 top(shown->GetPoint(shown->FindPoint(0.0, 0.0, 0.0)));
    EXPECT_NEAR(-top.z(), yields, 0.3 * yields) << "the vertex below the cube goes with it";
  }
  std::vector<Vec3> way;
  for (int i = 0; i < 1200; ++i)
  {
    way.push_back(Vec3(3.0, 1.0, halfSide + 1.0 - (1.0 + deep) * std::min(1.0, i / 200.0)));
  }
  vtkNew<vtkTouchAlongPath> filter;
  filter->SetInputData(makeSoftBlock(100.0, 1.0 / scale));
  filter->SetPathData(makePath(way));
  filter->SetToolData(cube->GetOutput());
  filter->SetSetting("Stiffness", springOfTool);
  filter->SetSetting("Scale", scale);
  filter->Update();
  EXPECT_NEAR(filter->GetOutput()->GetPointData()->GetArray("Force")->GetComponent(1199, 2), felt_N, 0.01 * felt_N);
}

/// The contacts of a session's tool, as the view draws them.
struct DrawnContacts
{
  explicit DrawnContacts(vtkHapticSession* session) { session->GetSight()->GetContactForces(this->points); }

  [[nodiscard]] int count() const { return static_cast<int>(this->points->GetNumberOfPoints()); }
  [[nodiscard]] Vec3 at(int i) const { return Vec3(this->points->GetPoint(i)); }
  [[nodiscard]] Vec3 force_N(int i) const
  {
    return Vec3(this->points->GetPointData()->GetArray("Force")->GetTuple3(i));
  }
  [[nodiscard]] std::string touched(int i) const
  {
    return vtkStringArray::SafeDownCast(this->points->GetPointData()->GetAbstractArray("Touched"))->GetValue(i);
  }
  [[nodiscard]] int pair(int i) const
  {
    return static_cast<int>(this->points->GetPointData()->GetArray("Pair")->GetComponent(i, 0));
  }
  [[nodiscard]] Vec3 all_N() const
  {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < this->count(); ++i)
    {
      sum += this->force_N(i);
    }
    return sum;
  }

  vtkNew<vtkPolyData> points;
};

TEST_F(HapticSessionTool, OnASurfaceHasAnArrowAtEachContactAsLongAsTheForceThere)
{
  ASSERT_TRUE(this->session_->AddTool("Cube1", cubeFarAway()));
  this->touchAt(halfSide + 5.0);
  EXPECT_EQ(DrawnContacts(this->session_).count(), 0) << "it touches nothing";
  this->goTo(halfSide - 2.0);
  const DrawnContacts contacts(this->session_);
  ASSERT_GT(contacts.count(), 0);
  EXPECT_LE((contacts.all_N() - springOfTool * 2.0 / scale * Vec3::UnitZ()).norm(), 1e-5);
  double most_N = 0.0;
  Vec3 moment = Vec3::Zero(); // about the hand, which holds the middle of a cube that lies flat
  for (int i = 0; i < contacts.count(); ++i)
  {
    moment += contacts.at(i).cross(contacts.force_N(i));
    EXPECT_NEAR(contacts.at(i).z(), 0.0, 1e-4);
    EXPECT_EQ(contacts.touched(i), "surface");
    EXPECT_EQ(contacts.pair(i), 0);
    most_N = std::max(most_N, contacts.force_N(i).norm());
  }
  EXPECT_LE(moment.norm(), 1e-4 * halfSide);
  vtkNew<vtkHapticToolProps> props;
  props->UpdateFrom(this->session_);
  EXPECT_FALSE(props->GetContactsActor()->GetVisibility()) << "nobody has asked for arrows";
  this->session_->SetSetting("ShowContactForces", true);
  props->UpdateFrom(this->session_);
  EXPECT_TRUE(props->GetContactsActor()->GetVisibility());
  double box[6], scene[6];
  props->GetContactsActor()->GetMapper()->GetBounds(box);
  ASSERT_TRUE(this->session_->GetSceneBounds(scene));
  const double diagonal = Vec3(scene[1] - scene[0], scene[3] - scene[2], scene[5] - scene[4]).norm();
  EXPECT_NEAR(box[5], props->GetForceScale() * diagonal * most_N, 1e-3 * diagonal) << "they stand on the plane";
  this->goTo(halfSide + 5.0);
  props->UpdateFrom(this->session_);
  EXPECT_FALSE(props->GetContactsActor()->GetVisibility());
}

TEST_F(HapticSessionTool, AcrossABodyThatGivesWayAndABoneHasTheForcesOfEachByName)
{
  constexpr double deep = 1.0, border = 50.0, apart = 2.0; // where the block ends, and how far the bone is from it
  ToolOnBlock on;
  const auto session = vtkSmartPointer<vtkHapticSession>(on.session);
  vtkNew<vtkCubeSource> bone, cube;
  bone->SetBounds(border + apart, border + 50.0, -60.0, 60.0, -40.0, -0.5);
  bone->Update();
  cube->SetXLength(80.0);
  cube->SetYLength(40.0);
  cube->SetZLength(2.0 * halfSide);
  cube->Update();
  ASSERT_TRUE(session->AddSurface("bone", bone->GetOutput(), nullptr)) << session->GetProblem();
  session->CommitScene();
  ASSERT_TRUE(session->FinishScene()) << session->GetSceneReport();
  ASSERT_TRUE(session->AddTool("Cube1", cube->GetOutput()));
  ASSERT_TRUE(session->AddSoftBody("block", on.body));
  on.place = Vec3(border, 1.0, 0.0);
  on.touch(halfSide + 1.0);
  on.lower(halfSide + 1.0, halfSide - 0.5 - deep);
  const DrawnContacts contacts(session);
  std::map<std::string, Vec3> of;
  std::map<std::string, std::set<int>> pairs;
  for (int i = 0; i < contacts.count(); ++i)
  {
    const std::string& name = contacts.touched(i);
    of.try_emplace(name, Vec3::Zero()).first->second += contacts.force_N(i);
    pairs[name].insert(contacts.pair(i));
    EXPECT_EQ(name == "bone", contacts.at(i).x() > border + 0.5 * apart)
      << name << " at " << contacts.at(i).transpose();
    EXPECT_GT(contacts.force_N(i).z(), 0.0);
  }
  ASSERT_EQ(of.size(), 2u);
  EXPECT_GT(of.at("bone").z(), 0.02);
  EXPECT_GT(of.at("block").z(), 0.02);
  EXPECT_EQ(pairs.at("bone").size() + pairs.at("block").size(), 2u) << "a number for each";
  EXPECT_NE(pairs.at("bone"), pairs.at("block"));
  EXPECT_LE((contacts.all_N() - Vec3(session->GetForce())).norm(), 1e-6) << "and together they push the hand";
  EXPECT_THAT(session->GetToolContacts(), HasSubstr("bone at ("));
  EXPECT_THAT(session->GetToolContacts(), HasSubstr("block at ("));
}

TEST_F(HapticSessionTool, ThatIsOpenIsRefusedOnABodyThatGivesWayInWhicheverOrderTheyComeAndTheBallPresses)
{
  constexpr double ball = 10.0, deep = 2.0;
  for (const bool toolFirst : { true, false })
  {
    ToolOnBlock on;
    const auto session = vtkSmartPointer<vtkHapticSession>(on.session);
    const auto hold = [&] { return errorsOf(session, [&] { session->AddTool("Cube1", makePlane(2.0 * halfSide)); }); };
    const auto press = [&] { return errorsOf(session, [&] { session->AddSoftBody("block", on.body); }); };
    const std::vector<std::string> first = toolFirst ? hold() : press();
    EXPECT_TRUE(first.empty()) << first.front();
    const std::vector<std::string> second = toolFirst ? press() : hold();
    EXPECT_THAT(second, ElementsAre(HasSubstr("the tool cannot press a soft body: the mesh is open")));
    EXPECT_THAT(session->GetProblem(), HasSubstr("cannot press a soft body"));
    EXPECT_THAT(session->GetToolText(), HasSubstr("cannot press a soft body"));

    session->SetSetting("Radius", ball);
    on.touch(ball + 5.0);
    session->SetHandPosition(3.0, 1.0, ball - deep);
    session->Step(ticksToRest);
    EXPECT_THAT(session->GetToolText(), HasSubstr("cannot press a soft body"));
    const double push_N = pushOfSoftBlock_N(ball / scale, deep / scale, springOfTool);
    EXPECT_NEAR(session->GetForce()[2], push_N, offLayer * push_N);

    session->AddSoftBody(nullptr, nullptr); // taken away again
    EXPECT_THAT(session->GetProblem(), Not(HasSubstr("soft body")));
    EXPECT_THAT(session->GetToolText(), Not(HasSubstr("soft body")));
  }
}

TEST_F(HapticSessionTool, ThatBeginsInASurfaceWaitsAndSaysSo)
{
  ASSERT_TRUE(this->session_->AddTool("Cube1", cubeFarAway()));
  this->touchAt(1.0);
  EXPECT_THAT(this->session_->GetToolText(), HasSubstr("waits"));
  EXPECT_THAT(this->session_->GetFaultText(), HasSubstr("the tool is free"));
  EXPECT_EQ(this->session_->GetForceMagnitude(), 0.0);
  this->goTo(halfSide + 1.0);
  EXPECT_STREQ(this->session_->GetFaultText(), "");
}

TEST_F(HapticSessionTool, IsDrawnSolidWhereItIsAndAsAGhostWhereTheHandIs)
{
  ASSERT_TRUE(this->session_->AddTool("Cube1", cubeFarAway()));
  this->touchAt(halfSide + 5.0);
  this->goTo(halfSide - 2.0);
  vtkNew<vtkHapticToolProps> props;
  props->UpdateFrom(this->session_);
  EXPECT_FALSE(props->GetProxyActor()->GetVisibility());
  EXPECT_TRUE(props->GetForceActor()->GetVisibility());
  // The centre of the data goes to where centre of tool and hand are.
  const double centre[4] = { 100.0, 0.0, 0.0, 1.0 };
  for (const auto& [actor, z] : { std::pair(props->GetHeldActor(), halfSide), std::pair(props->GetGhostActor(), 3.0) })
  {
    double at[4];
    actor->GetMatrix()->MultiplyPoint(centre, at);
    EXPECT_TRUE(actor->GetVisibility());
    EXPECT_NEAR(at[0], 0.0, 1e-5);
    EXPECT_NEAR(at[2], z, 1e-4);
  }
  this->session_->SetSetting("ToolSource", "");
  this->session_->Step(1);
  props->UpdateFrom(this->session_);
  EXPECT_FALSE(props->GetHeldActor()->GetVisibility());
  EXPECT_TRUE(props->GetProxyActor()->GetVisibility());
}
} // namespace
