// SPDX-License-Identifier: GPL-3.0-or-later
// The workspace of a device follows the view and the hand that holds it. Judged by where VTK draws a place.
#include <array>
#include <cmath>
#include <functional>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "haptics/core/Types.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/Eventually.h"
#include "testing/support/Random.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkHapticKnownDevices.h"
#include "vtkHapticSight.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
constexpr double reach_m = 0.01; // of the stroke to each side

/// A simulated hand that goes to and fro along the device's x, over a plane that it never meets.
class HapticSessionView : public VirtualSession
{
protected:
  void SetUp() override
  {
    this->show(makePlane(500.0));
    this->session_->SetSetting("Offset", 0.0, 0.0, 300.0);
    this->session_->SetSetting("DeviceName", "simulated-ideal");
    this->session_->AddStrokePoint(-1e3 * reach_m, 0.0, 300.0);
    this->session_->AddStrokePoint(1e3 * reach_m, 0.0, 300.0);
    this->session_->SetSetting("StrokeSpeed", 0.02);
    this->window_->SetOffScreenRendering(1);
    this->window_->SetSize(400, 300);
    this->window_->AddRenderer(this->renderer_);
  }

  [[nodiscard]] Vec3 hand_W() const { return Vec3(this->session_->GetHandPosition()); }
  [[nodiscard]] vtkCamera& camera() const { return *this->renderer_->GetActiveCamera(); }

  void lookFrom(palpate::test::Random& random)
  {
    const Vec3 eye_W = random.uniform(500.0, 3000.0) * random.direction(), at_W = random.inCube(200.0);
    const Vec3 up_W = random.direction();
    this->camera().SetPosition(eye_W.data());
    this->camera().SetFocalPoint(at_W.data());
    this->camera().SetViewUp(up_W.data());
    this->camera().SetParallelProjection(random.below(2));
    this->camera().SetClippingRange(1.0, 10000.0);
    this->session_->GetSight()->FollowCamera(&this->camera());
  }

  /// Where VTK draws it: pixels to the right and up, and a depth that grows away from the person.
  [[nodiscard]] Vec3 drawnAt(const Vec3& p_W) const
  {
    this->renderer_->SetWorldPoint(p_W.x(), p_W.y(), p_W.z(), 1.0);
    this->renderer_->WorldToDisplay();
    return Vec3(this->renderer_->GetDisplayPoint());
  }

  /// The session's map, from its properties.
  [[nodiscard]] Vec3 toScene(const Vec3& p_D) const
  {
    const double* const q = this->session_->GetSettingNumbers("Rotation");
    return Vec3(this->session_->GetSettingNumbers("Offset")) +
           this->session_->GetSetting("Scale") * (Quat(q[0], q[1], q[2], q[3]) * p_D);
  }

  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
};
} // namespace

TEST_F(HapticSessionView, AlignedOnTouchTheSixDirectionsOfTheDeviceAreThoseOfTheScreen)
{
  palpate::test::Random random(palpate::test::testSeed(171));
  this->session_->SetSetting("ViewAlignment", vtkHapticSession::AlignWhenTouched);
  for (std::size_t i = 0; i < palpate::test::testCount(40); ++i)
  {
    this->lookFrom(random);
    this->startTouching();
    const Vec3 middle = this->drawnAt(this->toScene(Vec3::Zero()));
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double sign : { -1.0, 1.0 })
      {
        const Vec3 drawn = this->drawnAt(this->toScene(0.01 * sign * Vec3::Unit(axis))) - middle;
        EXPECT_TRUE(axis == 2 || sign * drawn[axis] > 0.0) << "right is right, up is up";
        EXPECT_TRUE(axis != 2 || sign * drawn.z() < 0.0) << "towards the person is nearer";
        EXPECT_TRUE(axis == 2 || std::fabs(drawn[1 - axis]) < 1e-6 * std::fabs(drawn[axis])) << "and nothing else";
      }
    }
    this->session_->TouchingOff();
  }
}

TEST_F(HapticSessionView, ThatIsFollowedTurnsTheWorkspaceAboutTheHandWithEveryPicture)
{
  palpate::test::Random random(palpate::test::testSeed(172));
  this->session_->SetSetting("ViewAlignment", vtkHapticSession::AlignAlways);
  this->lookFrom(random);
  this->startTouching();
  this->session_->Step(200);
  for (int picture = 0; picture < 50; ++picture)
  {
    const Vec3 before_W = this->hand_W();
    this->camera().Azimuth(7.0);
    this->camera().Roll(3.0);
    this->session_->GetSight()->FollowCamera(&this->camera());
    this->session_->Update();
    this->session_->Step(1);
    EXPECT_LT((this->hand_W() - before_W).norm(), 0.05) << "0.02 m/s for 1 ms are 0.02 u";
    const Vec3 drawn = this->drawnAt(this->toScene({ 0.01, 0, 0 })) - this->drawnAt(this->toScene(Vec3::Zero()));
    EXPECT_GT(drawn.x(), 0.0);
    EXPECT_LT(std::fabs(drawn.y()), 1e-6 * drawn.x());
  }
}

TEST_F(HapticSessionView, ThatIsNotFollowedIsTakenWhenItIsAskedForAndTheHandStays)
{
  palpate::test::Random random(palpate::test::testSeed(173));
  this->startTouching();
  this->session_->Step(200);
  this->lookFrom(random);
  const Vec3 before_W = this->hand_W();
  this->session_->Update();
  EXPECT_EQ(Vec3(this->session_->GetSettingNumbers("Rotation") + 1), Vec3::Zero()) << "not asked for yet";
  this->session_->AlignWithView();
  this->session_->Step(1);
  EXPECT_LT((this->hand_W() - before_W).norm(), 0.05);
  const Vec3 drawn = this->drawnAt(this->toScene({ 0, 0.01, 0 })) - this->drawnAt(this->toScene(Vec3::Zero()));
  EXPECT_GT(drawn.y(), 0.0);
  EXPECT_LT(std::fabs(drawn.x()), 1e-6 * drawn.y());
}

TEST_F(HapticSessionView, WhileTheClutchIsHeldTheDeviceMovesAndTheHandDoesNotAndGoesOnFromThere)
{
  this->startTouching();
  this->session_->Step(200);
  this->session_->SetSetting("Clutch", true);
  this->session_->Update();
  this->session_->Step(1);
  const Vec3 held_W = this->hand_W();
  for (int i = 0; i < 30; ++i)
  {
    this->session_->Step(10); // 6 mm of the device
    ASSERT_EQ(this->hand_W(), held_W);
  }
  this->session_->SetSetting("Clutch", false);
  this->session_->Update();
  this->session_->Step(1);
  EXPECT_LT((this->hand_W() - held_W).norm(), 0.05);
  EXPECT_GT((Vec3(this->session_->GetSettingNumbers("Offset")) - Vec3(0, 0, 300)).norm(), 1.0)
    << "the workspace was moved instead";
  this->session_->Step(100);
  EXPECT_NEAR((this->hand_W() - held_W).norm(), 2.0, 0.2) << "0.02 m/s for 0.1 s";
}

TEST_F(HapticSessionView, TheDevicesHandIsMappedToWhereTheSceneHasItWithAndWithoutTheClutch)
{
  Vec3 hand_D = Vec3::Zero();
  std::array<double, 4> turn{};
  vtkNew<vtkMatrix4x4> map;
  const auto asked = [&] { return this->session_->GetSight()->GetDeviceHand(hand_D.data(), turn.data(), map); };
  EXPECT_FALSE(asked()) << "nobody touches";
  this->session_->SetSetting("Rotation", std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0);
  this->startTouching();
  Vec3 before_D = Vec3::Zero();
  for (const bool clutched : { false, true })
  {
    this->session_->SetSetting("Clutch", clutched);
    this->session_->Update();
    this->session_->Step(150); // 3 mm of the device
    ASSERT_TRUE(asked());
    const Vec3 mapped_W(map->MultiplyDoublePoint(Eigen::Vector4d(hand_D.x(), hand_D.y(), hand_D.z(), 1.0).data()));
    EXPECT_LE((mapped_W - this->hand_W()).norm(), 1e-9);
    // A metre along x of the device is a kilounit along -z of the scene.
    EXPECT_LE(
      (Vec3(map->GetElement(0, 0), map->GetElement(1, 0), map->GetElement(2, 0)) - Vec3(0, 0, -1e3)).norm(), 1e-9);
    EXPECT_NEAR(turn[0], 1.0, 1e-12) << "this hand is not turned in its device";
    EXPECT_GT((hand_D - before_D).norm(), 1e-3);
    before_D = hand_D;
  }
  this->session_->TouchingOff();
  EXPECT_FALSE(asked());
}

TEST_F(HapticSessionView, PreciseTheSameWayIsThatMuchShorterAndOffItIsAsBefore)
{
  this->startTouching();
  this->session_->Step(300);
  const auto wayOf = [this](int ticks)
  {
    const Vec3 before_W = this->hand_W();
    this->session_->Step(ticks);
    return (this->hand_W() - before_W).norm();
  };
  EXPECT_NEAR(wayOf(50), 1.0, 0.1);
  const Vec3 before_W = this->hand_W();
  this->session_->SetSetting("PrecisionFactor", 4.0);
  this->session_->SetSetting("Precision", true);
  this->session_->Update();
  this->session_->Step(1);
  EXPECT_LT((this->hand_W() - before_W).norm(), 0.05);
  EXPECT_NEAR(this->session_->GetSetting("Scale"), 0.25 * scale, 1e-9);
  EXPECT_NEAR(wayOf(50), 0.25, 0.03);
  this->session_->SetSetting("Precision", false);
  this->session_->Update();
  EXPECT_NEAR(this->session_->GetSetting("Scale"), scale, 1e-9);
  this->session_->SetSetting("Precision", true);
  this->session_->Update();
  this->session_->TouchingOff();
  EXPECT_NEAR(this->session_->GetSetting("Scale"), scale, 1e-9) << "nobody holds it any more";
  EXPECT_FALSE(this->session_->IsOn("Precision"));
}

TEST_F(HapticSessionView, AHandThatAnotherMapPutsIntoABallStaysOutsideWithoutForceAndIsTold)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(50.0);
  ball->SetThetaResolution(60);
  ball->SetPhiResolution(60);
  ball->Update();
  this->show(ball->GetOutput());
  this->startTouching();
  this->session_->Step(ticksToEngage);
  this->session_->SetSetting("Offset", 0.0, 0.0, 20.0); // in the ball, 30 u deep
  double largest_N = 0.0;
  for (int tick = 0; tick < 200; ++tick)
  {
    this->session_->Step(1);
    largest_N = std::max(largest_N, this->session_->GetForceMagnitude());
  }
  EXPECT_NEAR(Vec3(this->session_->GetProxyPosition()).norm(), 50.0, 0.2) << "on the ball";
  EXPECT_THAT(this->session_->GetWarning(), HasSubstr("surface"));
  EXPECT_THAT(this->session_->GetWarning(), HasSubstr("stays outside"));
  EXPECT_LT(largest_N, 0.31) << "no more than a hand engages from";
  this->session_->SetSetting("Offset", 0.0, 0.0, 80.0);
  this->session_->Step(10);
  EXPECT_LT((Vec3(this->session_->GetProxyPosition()) - this->hand_W()).norm(), 1e-9) << "in free air again";
}

TEST_F(HapticSessionView, TheWorkspaceCanBeFittedToSomeOfWhatIsShown)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(2.0);
  ball->SetCenter(100.0, 20.0, -5.0);
  ball->Update();
  this->session_->ClearSurfaces();
  this->session_->AddSurface("large", makePlane(500.0), nullptr);
  this->session_->AddSurface("small", ball->GetOutput(), nullptr);
  this->session_->CommitScene();
  ASSERT_TRUE(this->session_->FinishScene());
  this->session_->FitWorkspace();
  const double all = this->session_->GetSetting("Scale");
  this->session_->FitToSources("small");
  EXPECT_LT(
    (Vec3(this->session_->GetSettingNumbers("Offset")) - Vec3(100.0, 20.0, -5.0)).norm(), 1e-5); // points are floats
  // half the diagonal of the ball's box over the same workspace, as that of the plane's was before
  double b[6];
  ball->GetOutput()->GetBounds(b);
  const double half = std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]) / 2.0;
  EXPECT_NEAR(this->session_->GetSetting("Scale") / all, half / (500.0 * std::sqrt(2.0)), 1e-3 * half / 707.0);
  this->session_->FitToSources("large\nsmall");
  EXPECT_NEAR(this->session_->GetSetting("Scale"), all, 0.01 * all);
  const double before = this->session_->GetSetting("Scale");
  EXPECT_THAT(errorsOf(this->session_, [this] { this->session_->FitToSources("small\nother"); }).at(0),
    HasSubstr("other is not touch"));
  EXPECT_EQ(this->session_->GetSetting("Scale"), before);
}

TEST(HapticSessionHandButtons, OfTheDeviceMakeTheHandPreciseAndHoldItWhileTheyAreDown)
{
  constexpr double lifeSize = 1000.0, finer = 4.0;
  const auto bus = std::make_shared<test::FakeHidBus>();
  test::FakePort& port = bus->plug(test::plainLayout(), "8");
  vtkNew<vtkHapticSession> session;
  session->GetDevices()->SetHidBus(bus);
  session->SetSetting("VirtualTime", true);
  session->SetSetting("Scale", lifeSize);
  session->SetSetting("DeviceName", "pid-1209-ffb0-8");
  session->SetSetting("PrecisionButton", 1);
  session->SetSetting("PrecisionFactor", finer);
  session->SetSetting("ClutchButton", 2);
  session->TouchingOn();
  ASSERT_TRUE(session->GetTouching()) << session->GetProblem();
  const auto comes = [&](const std::function<bool()>& expected)
  {
    return test::eventually(
      [&]
      {
        session->Step(1);
        session->Update();
        return expected();
      });
  };
  const auto press = [&](std::uint8_t buttons) { bus->alone([&] { port.device->buttons = buttons; }); };
  const auto handX = [&] { return session->GetHandPosition()[0]; };
  const auto moveTo = [&](double x) { bus->alone([&] { port.device->position[0] = x; }); };
  press(1);
  EXPECT_TRUE(comes([&] { return std::fabs(session->GetSetting("Scale") - lifeSize / finer) < 1e-9; }));
  press(0);
  EXPECT_TRUE(comes([&] { return std::fabs(session->GetSetting("Scale") - lifeSize) < 1e-9; }));
  const double before = handX();
  int changes = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&changes);
  count->SetCallback([](vtkObject*, unsigned long, void* changed, void*) { ++*static_cast<int*>(changed); });
  session->AddObserver(vtkCommand::PropertyModifiedEvent, count);
  press(2);
  EXPECT_TRUE(comes([&] { return changes == 1; }));
  moveTo(0.5);
  int looks = 0;
  EXPECT_TRUE(comes([&] { return ++looks == 40; })) << "as long as reports of the way may take";
  EXPECT_EQ(handX(), before);
  press(0);
  EXPECT_TRUE(comes([&] { return changes == 2; }));
  EXPECT_NEAR(handX(), before, 1e-9) << "it goes on from there";
  moveTo(0.8);
  EXPECT_TRUE(comes([&] { return handX() > before; }));
}
