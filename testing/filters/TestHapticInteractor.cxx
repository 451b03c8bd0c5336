// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "vtkActor.h"
#include "vtkHapticInteractor.h"
#include "vtkHapticSession.h"
#include "vtkHapticToolProps.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

using namespace palpate;
using namespace palpate::testing;

namespace
{

/// A plane z = 0 shown by an actor in a renderer without a window, touched in virtual time; a millimetre a unit.
class HapticInteractor : public ::testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(this->plane_);
    this->actor_->SetMapper(mapper);
    this->renderer_->AddActor(this->actor_);
    this->touch_->SetRenderer(this->renderer_);
    this->touch_->AddActor(this->actor_);
    this->session_->SetSetting("VirtualTime", true);
    this->session_->SetHandPosition(0.0, 0.0, 20.0);
    ASSERT_TRUE(this->touch_->Start()) << this->session_->GetProblem();
    this->session_->Step(ticksToEngage);
  }

  /// The proxy when the hand goes from above to z = -1.
  double restingHeight()
  {
    this->session_->SetHandPosition(0.0, 0.0, 20.0);
    this->follow();
    this->session_->SetHandPosition(0.0, 0.0, -1.0);
    this->follow();
    return this->session_->GetProxyPosition()[2];
  }

  void follow()
  {
    this->touch_->Update();
    this->session_->FinishScene();
    this->session_->Step(300);
    this->touch_->Update();
  }

  vtkSmartPointer<vtkPolyData> plane_ = makePlane(100.0);
  vtkNew<vtkActor> actor_;
  vtkNew<vtkRenderer> renderer_;
  vtkSmartPointer<vtkHapticInteractor> touch_ = vtkSmartPointer<vtkHapticInteractor>::New();
  vtkHapticSession* session_ = this->touch_->GetSession();
};
} // namespace

TEST_F(HapticInteractor, TheToolIsDrawnWhereTheSessionSays)
{
  EXPECT_NEAR(this->restingHeight(), 0.0, 1e-12);
  const vtkHapticToolProps* props = this->touch_->GetToolProps();
  EXPECT_EQ(Vec3(props->GetProxyActor()->GetPosition()), Vec3(this->session_->GetProxyPosition()));
  EXPECT_EQ(Vec3(props->GetHandActor()->GetPosition()), Vec3(this->session_->GetHandPosition()));
  EXPECT_TRUE(props->GetProxyActor()->GetVisibility());
  // the arrow's source is one unit long along x: its frame turns x into the force, as long as ForceScale says
  double b[6];
  ASSERT_TRUE(this->session_->GetSceneBounds(b));
  const double diagonal = std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  vtkMatrix4x4* frame = props->GetForceActor()->GetMatrix();
  const Vec3 arrow(frame->GetElement(0, 0), frame->GetElement(1, 0), frame->GetElement(2, 0));
  const Vec3 expected = Vec3(this->session_->GetForce()) * this->touch_->GetToolProps()->GetForceScale() * diagonal;
  EXPECT_GT(expected.norm(), 0.0);
  EXPECT_LT((arrow - expected).norm(), 1e-12 * diagonal);
}

TEST_F(HapticInteractor, TheToolIsNotPickedAndNotPartOfTheBounds)
{
  this->restingHeight();
  for (vtkActor* actor : { this->touch_->GetToolProps()->GetProxyActor(), this->touch_->GetToolProps()->GetHandActor(),
         this->touch_->GetToolProps()->GetForceActor(), this->touch_->GetToolProps()->GetTraceActor() })
  {
    EXPECT_FALSE(actor->GetPickable());
    EXPECT_FALSE(actor->GetUseBounds());
  }
}

TEST_F(HapticInteractor, FollowsTheActorsMatrix)
{
  this->actor_->SetPosition(0.0, 0.0, 5.0);
  EXPECT_NEAR(this->restingHeight(), 5.0, 1e-12);
}

TEST_F(HapticInteractor, FollowsTheMappersData)
{
  for (vtkIdType i = 0; i < this->plane_->GetNumberOfPoints(); ++i)
  {
    double p[3];
    this->plane_->GetPoint(i, p);
    this->plane_->GetPoints()->SetPoint(i, p[0], p[1], 3.0);
  }
  this->plane_->GetPoints()->Modified();
  EXPECT_NEAR(this->restingHeight(), 3.0, 1e-12);
}

TEST_F(HapticInteractor, AHiddenActorIsNotTouched)
{
  this->actor_->VisibilityOff();
  EXPECT_EQ(this->restingHeight(), -1.0);
}

TEST_F(HapticInteractor, AFullyTransparentActorIsNotTouched)
{
  this->actor_->GetProperty()->SetOpacity(0.0);
  EXPECT_EQ(this->restingHeight(), -1.0);
}

// Nothing says how large a hand is where nothing is: it could fill the view.
TEST_F(HapticInteractor, InAnEmptySceneNoToolIsDrawn)
{
  this->actor_->VisibilityOff();
  this->restingHeight();
  ASSERT_TRUE(this->session_->GetTouching());
  EXPECT_FALSE(this->touch_->GetToolProps()->GetProxyActor()->GetVisibility());
  EXPECT_FALSE(this->touch_->GetToolProps()->GetHandActor()->GetVisibility());
}

TEST_F(HapticInteractor, AnActorThatIsTakenAwayIsNotTouched)
{
  this->touch_->RemoveActor(this->actor_);
  EXPECT_EQ(this->restingHeight(), -1.0);
}

TEST_F(HapticInteractor, StopLeavesNoForceAndHidesTheTool)
{
  this->restingHeight();
  this->touch_->Stop();
  EXPECT_FALSE(this->session_->GetTouching());
  EXPECT_EQ(this->session_->GetForceMagnitude(), 0.0);
  EXPECT_FALSE(this->touch_->GetToolProps()->GetProxyActor()->GetVisibility());
}

TEST_F(HapticInteractor, EndsWithoutForceWhileItTouches)
{
  this->restingHeight();
  const vtkSmartPointer<vtkHapticSession> session = this->session_;
  ASSERT_GT(session->GetForceMagnitude(), 0.0);
  this->touch_ = nullptr;
  EXPECT_FALSE(session->GetTouching());
  EXPECT_EQ(session->GetForceMagnitude(), 0.0);
}
