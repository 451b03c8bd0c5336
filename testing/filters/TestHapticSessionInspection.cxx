// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of a session about the place that is touched, and the marks that are set there.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/Eventually.h"
#include "testing/support/Says.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkHapticInspection.h"
#include "vtkHapticKnownDevices.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace palpate::testing::inspected
{
namespace
{

using ::testing::HasSubstr;

void addArray(vtkDataSetAttributes* arrays, const char* name, int components, std::vector<double> values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  arrays->AddArray(array);
}

/// A plane z = 0 of two triangles with an array linear in x, a vector that is everywhere the same and a number a cell.
vtkSmartPointer<vtkPolyData> planeWithArrays()
{
  auto plane = makePlane(half);
  std::vector<double> linear, vector;
  for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
  {
    linear.push_back(3.0 * plane->GetPoint(i)[0] + 7.0);
    vector.insert(vector.end(), { 1.0, 2.0, 3.0 });
  }
  addArray(plane->GetPointData(), "linear", 1, linear);
  addArray(plane->GetPointData(), "vector", 3, vector);
  addArray(plane->GetCellData(), "number", 1, { 100.0, 101.0 });
  return plane;
}

double markValue(vtkHapticSession& session, vtkIdType mark, const char* column)
{
  vtkNew<vtkTable> table;
  session.GetInspection()->GetMarksTable(table);
  return table->GetValueByName(mark, column).ToDouble();
}

/// The corner of a triangle that the other one of two lacks.
vtkIdType cornerOfOne(vtkPolyData& two, vtkIdType triangle)
{
  vtkNew<vtkIdList> its, others;
  two.GetCellPoints(triangle, its);
  two.GetCellPoints(1 - triangle, others);
  const auto alone = [&](vtkIdType id) { return others->IsId(id) < 0; };
  return *std::find_if(its->begin(), its->end(), alone);
}

/// A fed hand in virtual time.
class HapticSessionInspection : public VirtualSession
{
protected:
  void press(const Vec3& from_W, const Vec3& to_W)
  {
    this->session_->SetHandPosition(from_W.data());
    this->startTouching();
    this->session_->Step(ticksToEngage);
    this->session_->SetHandPosition(to_W.data());
    this->session_->Step(100);
    ASSERT_GT(this->session_->GetContacts(), 0);
  }
  void pressPlane(double x, double y) { this->press(Vec3(x, y, 1.0), Vec3(x, y, -depth)); }
};
} // namespace

TEST_F(HapticSessionInspection, SaysPlaceNormalCellAndEveryArrayAtTheContact)
{
  const auto plane = planeWithArrays();
  this->show(plane);
  this->pressPlane(20.0, -30.0);
  ASSERT_TRUE(this->session_->InspectContact());
  EXPECT_STREQ(this->session_->GetContactSource(), "surface");
  EXPECT_NEAR((Vec3(this->session_->GetContactPosition()) - Vec3(20, -30, 0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((Vec3(this->session_->GetContactNormal()) - Vec3(0, 0, 1)).norm(), 0.0, 1e-12);
  EXPECT_EQ(this->session_->GetContactCurvature()[0], 0.0);
  EXPECT_TRUE(std::isnan(this->session_->GetContactThickness())) << "a plane has no wall behind it";
  EXPECT_NEAR(this->session_->GetInspection()->GetValue("linear"), 3.0 * 20.0 + 7.0, 1e-5);
  EXPECT_NEAR(this->session_->GetInspection()->GetValue("vector_1"), 2.0, 1e-12);
  EXPECT_NEAR(this->session_->GetInspection()->GetValue("Depth"), depth, 1e-6);
  EXPECT_NEAR(this->session_->GetInspection()->GetValue("Force"), stiffness * depth / scale, 1e-6);
  const vtkIdType cell = this->session_->GetContactCell();
  ASSERT_GE(cell, 0);
  EXPECT_EQ(this->session_->GetInspection()->GetValue("number"), 100.0 + static_cast<double>(cell));
  double inside[3], local[3], weights[3], distance2 = 0.0;
  const double at[3] = { 20, -30, 0 };
  int part = 0;
  EXPECT_EQ(plane->GetCell(cell)->EvaluatePosition(at, inside, part, local, distance2, weights), 1);
  EXPECT_THAT(this->session_->GetContactText(), HasSubstr("surface: cell " + std::to_string(cell)));
}

TEST_F(HapticSessionInspection, OfABallHasItsCurvatureAndItsDiameterAsTheWall)
{
  this->show(makeSphere(sphereRadius, 100));
  this->press(Vec3(1.0, 2.0, sphereRadius + 1.0), Vec3(1.0, 2.0, sphereRadius - depth));
  ASSERT_TRUE(this->session_->InspectContact());
  EXPECT_NEAR(this->session_->GetContactCurvature()[0], 1.0 / sphereRadius, 0.02 / sphereRadius);
  EXPECT_NEAR(this->session_->GetContactCurvature()[1], 1.0 / sphereRadius, 0.02 / sphereRadius);
  EXPECT_NEAR(this->session_->GetContactThickness(), 2.0 * sphereRadius, 0.01 * sphereRadius); // facets of 3.6 degrees
}

TEST_F(HapticSessionInspection, FindsTheCellsOfAPlacedBlockByTheIdsItCameFrom)
{
  const auto plane = planeWithArrays();
  vtkNew<vtkIdTypeArray> originals;
  originals->SetName("vtkOriginalCellIds");
  originals->InsertNextValue(555);
  originals->InsertNextValue(777);
  plane->GetCellData()->AddArray(originals);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(2, plane);
  vtkNew<vtkMatrix4x4> up;
  up->SetElement(2, 3, 10.0);
  this->session_->ClearSurfaces();
  ASSERT_TRUE(this->session_->AddSurface("blocks", blocks, up));
  this->session_->CommitScene();
  ASSERT_TRUE(this->session_->FinishScene());
  this->press(Vec3(20, -30, 11), Vec3(20, -30, 8));
  ASSERT_TRUE(this->session_->InspectContact());
  EXPECT_STREQ(this->session_->GetContactSource(), "blocks");
  EXPECT_NEAR(this->session_->GetContactPosition()[2], 10.0, 1e-6);
  EXPECT_NEAR(this->session_->GetInspection()->GetValue("linear"), 67.0, 1e-5);
  EXPECT_TRUE(this->session_->GetContactCell() == 555 || this->session_->GetContactCell() == 777);
}

// A hand that leaves the view to press a button in the panel leaves the surface too.
TEST_F(HapticSessionInspection, KeepsTheLastContactUntilAnotherSceneIsThere)
{
  this->show(planeWithArrays());
  EXPECT_FALSE(this->session_->InspectContact()) << "nothing was touched yet";
  this->session_->SetSetting("Inspect", true);
  this->pressPlane(1.0, 2.0);
  EXPECT_STREQ(this->session_->GetContactSource(), "surface") << "with Inspect every Update() looks";
  this->session_->SetHandPosition(1.0, 2.0, 5.0);
  this->session_->Step(100);
  EXPECT_FALSE(this->session_->GetContactIsNow());
  ASSERT_TRUE(this->session_->InspectContact());
  EXPECT_LT((Vec3(this->session_->GetContactPosition()) - Vec3(1.0, 2.0, 0.0)).norm(), 1e-9);
  ASSERT_TRUE(this->session_->AddMark());
  vtkNew<vtkPolyData> marks;
  this->session_->GetInspection()->GetMarks(marks);
  ASSERT_EQ(marks->GetNumberOfPoints(), 1);
  EXPECT_LT((Vec3(marks->GetPoint(0)) - Vec3(1.0, 2.0, 0.0)).norm(), 1e-5);
  this->show(planeWithArrays());
  this->session_->Step(1);
  EXPECT_FALSE(this->session_->InspectContact());
  EXPECT_STREQ(this->session_->GetContactText(), "");
  EXPECT_EQ(this->session_->GetContactCell(), -1);
}

TEST_F(HapticSessionInspection, AMarkIsKeptAsPointTableTextAndFile)
{
  const auto errors = errorsOf(static_cast<vtkObject*>(this->session_), [this] { this->session_->AddMark(); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("a mark needs a contact"));
  this->show(planeWithArrays());
  this->pressPlane(20.0, -30.0);
  EXPECT_STREQ(this->session_->GetProblem(), "") << "a refusal is gone with its reason";
  ASSERT_TRUE(this->session_->AddMark());
  this->session_->SetHandPosition(40.0, 10.0, -depth);
  this->session_->Step(300);
  ASSERT_TRUE(this->session_->AddMark());
  EXPECT_EQ(this->session_->GetNumberOfMarks(), 2);
  vtkNew<vtkPolyData> points;
  this->session_->GetInspection()->GetMarks(points);
  ASSERT_EQ(points->GetNumberOfPoints(), 2);
  EXPECT_NEAR((Vec3(points->GetPoint(0)) - Vec3(20, -30, 0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((Vec3(points->GetPoint(1)) - Vec3(40, 10, 0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(points->GetPointData()->GetArray("linear")->GetComponent(1, 0), 127.0, 1e-5);
  vtkNew<vtkTable> table;
  this->session_->GetInspection()->GetMarksTable(table);
  EXPECT_EQ(table->GetNumberOfRows(), 2);
  const palpate::test::TemporaryFolder folder;
  EXPECT_TRUE(this->session_->GetInspection()->WriteMarks(folder.file("marks.csv").c_str()));
  EXPECT_THAT(this->session_->GetSettingText("MarksText"), HasSubstr("Source,X,Y,Z,"));
  this->session_->ClearMarks();
  EXPECT_EQ(this->session_->GetNumberOfMarks(), 0);
}

TEST_F(HapticSessionInspection, AMarkIsStaleOnceTheCellItWasSetOnIsElsewhereAndHoldsAgainWhereItCameBack)
{
  const auto plane = planeWithArrays();
  this->show(plane);
  this->pressPlane(20.0, -30.0); // below the diagonal from (-half, -half) to (half, half)
  ASSERT_TRUE(this->session_->AddMark());
  this->session_->SetHandPosition(-40.0, 10.0, -depth);
  this->session_->Step(300);
  ASSERT_TRUE(this->session_->AddMark());
  const auto states = [this]
  {
    this->session_->Step(1);
    return std::vector<int>{ this->session_->GetInspection()->GetMarkState(0),
      this->session_->GetInspection()->GetMarkState(1) };
  };
  const std::vector<int> both{ vtkHapticInspection::MarkHolds, vtkHapticInspection::MarkHolds };
  EXPECT_EQ(states(), both);
  EXPECT_STREQ(this->session_->GetMarksNote(), "");
  const auto changed = planeWithArrays(); // the corner that only one of the triangles has
  const vtkIdType cell = static_cast<vtkIdType>(markValue(*this->session_, 0, "Cell"));
  changed->GetPoints()->SetPoint(cornerOfOne(*changed, cell), 2.0 * half, -half, 30.0);
  this->show(changed);
  EXPECT_EQ(states(), (std::vector<int>{ vtkHapticInspection::MarkStale, vtkHapticInspection::MarkHolds }));
  EXPECT_TRUE(test::says(this->session_->GetMarksNote(), { "1", "surface", "changed" }));
  this->show(plane);
  EXPECT_EQ(states(), both);
  vtkNew<vtkMatrix4x4> up;
  up->SetElement(2, 3, 1.0);
  ASSERT_TRUE(this->session_->SetSurfacePose("surface", up));
  this->session_->CommitScene();
  EXPECT_EQ(states(), (std::vector<int>{ vtkHapticInspection::MarkStale, vtkHapticInspection::MarkStale }));
  this->session_->ClearSurfaces();
  this->session_->CommitScene();
  EXPECT_EQ(states(), (std::vector<int>{ vtkHapticInspection::MarkUnseen, vtkHapticInspection::MarkUnseen }));
}

TEST_F(HapticSessionInspection, MarksComeBackFromTheirTextToTheBitAndATextThatIsNoneLeavesThem)
{
  this->show(planeWithArrays());
  this->pressPlane(20.0, -30.0);
  ASSERT_TRUE(this->session_->AddMark());
  const std::string text = this->session_->GetSettingText("MarksText");
  vtkNew<vtkHapticSession> other;
  other->SetSetting("MarksText", text.c_str());
  EXPECT_EQ(other->GetSettingText("MarksText"), text);
  EXPECT_EQ(other->GetNumberOfMarks(), 1);
  EXPECT_EQ(other->GetInspection()->GetMarkState(0), vtkHapticInspection::MarkUnseen);
  const auto errors =
    errorsOf(static_cast<vtkObject*>(other), [&] { other->SetSetting("MarksText", "Source,X,Y,Z\nball,1,2,three\n"); });
  EXPECT_EQ(errors.size(), 1u);
  EXPECT_TRUE(test::says(other->GetProblem(), { "1", "'three'", "number" }));
  EXPECT_EQ(other->GetSettingText("MarksText"), text);
  other->SetSetting("MarksText", "");
  EXPECT_EQ(other->GetNumberOfMarks(), 0);
}

TEST_F(HapticSessionInspection, SourcesOfTheirOwnKeepTheirTextAndWhatCannotBeLeavesThemAsTheyAre)
{
  this->session_->SetSourceTouched("a, \"b\"", false);
  ASSERT_TRUE(this->session_->SetSourceMaterial("ball", 250.0, 0.5, 0.25));
  const std::string text = this->session_->GetSettingText("SourcesText");
  EXPECT_EQ(text, "Source,Touched,Stiffness,FrictionStatic,FrictionKinetic\n\"a, \"\"b\"\"\",0,inf,-1,-1\n"
                  "ball,1,250,0.5,0.25\n");
  vtkNew<vtkHapticSession> other;
  other->SetSetting("SourcesText", text.c_str());
  EXPECT_FALSE(other->GetSourceTouched("a, \"b\""));
  EXPECT_TRUE(other->GetSourceTouched("ball"));
  double material[3];
  other->GetSourceMaterial("ball", material);
  EXPECT_THAT(material, ::testing::ElementsAre(250.0, 0.5, 0.25));
  const char* const header = "Source,Touched,Stiffness,FrictionStatic,FrictionKinetic\n";
  for (const auto& [bad, why] : { std::pair{ "ball,2,inf,-1,-1\n", "ball: Touched must be 0 or 1, not '2'" },
         std::pair{ "ball,1,-5,-1,-1\n", "ball: " }, std::pair{ "ball,1,inf,-1\n", "ball: it has 4 fields" } })
  {
    const auto errors = errorsOf(
      static_cast<vtkObject*>(other), [&] { other->SetSetting("SourcesText", (std::string(header) + bad).c_str()); });
    EXPECT_EQ(errors.size(), 1u);
    EXPECT_THAT(other->GetProblem(), HasSubstr(why));
    EXPECT_EQ(other->GetSettingText("SourcesText"), text);
  }
  EXPECT_EQ(
    errorsOf(static_cast<vtkObject*>(other), [&] { other->SetSetting("SourcesText", "Name,Felt\nball,1\n"); }).size(),
    1u);
  EXPECT_TRUE(test::says(other->GetProblem(), { "sources", "columns" }));
  other->SetSetting("SourcesText", "");
  EXPECT_TRUE(other->GetSourceTouched("a, \"b\""));
}

TEST(HapticSessionMarkButton, AsksForAMarkOnceEachTimeItIsPressed)
{
  const auto bus = std::make_shared<test::FakeHidBus>();
  test::FakePort& port = bus->plug(test::plainLayout(), "7");
  vtkNew<vtkHapticSession> session;
  session->GetDevices()->SetHidBus(bus);
  session->SetSetting("VirtualTime", true);
  session->SetSetting("DeviceName", "pid-1209-ffb0-7");
  session->SetSetting("MarkButton", 2);
  session->TouchingOn();
  ASSERT_TRUE(session->GetTouching()) << session->GetProblem();
  session->Step(10);
  std::vector<std::string> errors; // nothing is touched, so every wish for a mark is refused
  const auto press = [&](std::uint32_t buttons)
  {
    bus->alone([&] { port.device->buttons = buttons; });
    errors = errorsOf(static_cast<vtkObject*>(session),
      [&]
      {
        static_cast<void>(test::eventually(
          [&]
          {
            session->Step(1);
            return std::string(session->GetProblem()).find("a mark") != std::string::npos;
          }));
        session->Step(10);
      });
  };
  press(2);
  ASSERT_EQ(errors.size(), 1u) << "held down, it asks once";
  EXPECT_THAT(errors.front(), HasSubstr("a mark needs a contact"));
}

} // namespace palpate::testing::inspected
