// SPDX-License-Identifier: GPL-3.0-or-later
// Touch Along Path with a mechanism. Judge: the balance of a lever on two springs, by hand (row 65 of the bar).
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "testing/support/Linear.h"
#include "testing/support/Says.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkHapticMechanism.h"
#include "vtkHapticMechanismFile.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTouchAlongPath.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::Contains;
using ::testing::HasSubstr;

namespace
{
constexpr double held = 1000.0, turning = 2.0, aside = 0.005; // N/m, N m/rad, m
constexpr std::array<double, 2> arms{ 0.05, 0.15 }, springs{ 500.0, 200.0 };
constexpr vtkIdType rows = 200;

vtkSmartPointer<vtkHapticMechanism> mechanism(const char* name)
{
  auto source = vtkSmartPointer<vtkHapticMechanism>::New();
  source->SetFileName(std::string(PALPATE_DATA_MECHANISMS) + "/" + name);
  source->Update();
  return source;
}

vtkSmartPointer<vtkTouchAlongPath> touchOf(vtkHapticMechanism& source, double lever)
{
  auto touch = vtkSmartPointer<vtkTouchAlongPath>::New();
  touch->SetInputConnection(source.GetOutputPort());
  touch->SetPathData(makePath(std::vector<Vec3>(rows, Vec3(aside, 0.0, 0.0))));
  touch->SetSetting("Stiffness", held);
  touch->SetSetting("ToolLever", lever);
  return touch;
}

double last(vtkTouchAlongPath& touch, const std::string& array, int component = 0)
{
  return touch.GetOutput()->GetPointData()->GetArray(array.c_str())->GetComponent(rows - 1, component);
}
} // namespace

TEST(TouchMechanism, ALeverIsPulledAsItsBalanceSaysByAHandThatTurnsIt)
{
  const auto source = mechanism("lever.json");
  const auto touch = touchOf(*source, std::sqrt(turning / held));
  touch->Update();
  Eigen::Matrix2d balance = Eigen::Vector2d(held, turning).asDiagonal();
  for (std::size_t i = 0; i < arms.size(); ++i)
  {
    const Eigen::Vector2d way(1.0, arms[i]); // of the spring's point, by place and turn of the rod
    balance += springs[i] * way * way.transpose();
  }
  // The forces and moments of the finite turn; small turns are how to come nearer.
  Eigen::Vector2d rod(0.0, 0.0);
  for (int i = 0; i < 20; ++i)
  {
    Eigen::Vector2d open(held * (aside - rod[0]), -turning * rod[1]);
    for (std::size_t k = 0; k < arms.size(); ++k)
    {
      const Eigen::Vector2d way(1.0, arms[k] * std::cos(rod[1]));
      open -= springs[k] * (rod[0] + arms[k] * std::sin(rod[1])) * way;
    }
    rod += palpate::test::solved(balance, open);
  }
  EXPECT_NEAR(last(*touch, "Force of wall"), -springs[0] * (rod[0] + arms[0] * std::sin(rod[1])), 1e-6);
  EXPECT_NEAR(last(*touch, "Force of organ"), -springs[1] * (rod[0] + arms[1] * std::sin(rod[1])), 1e-6);
  EXPECT_NEAR(last(*touch, "Force"), held * (rod[0] - aside), 1e-6);
  EXPECT_NEAR(last(*touch, "Torque", 1), turning * rod[1], 1e-6);
  EXPECT_LT(last(*touch, "Residual"), 1e-9);
}

TEST(TouchMechanism, AHandThatLeavesTheTurnFreeFeelsTheSpringsInSeriesAndNoTorque)
{
  const auto source = mechanism("lever.json");
  const auto touch = touchOf(*source, 0.0);
  touch->Update();
  // The rod turns so that no moment is left: both springs yield by forces whose arms balance about the hand.
  const double slope =
    (arms[0] * springs[0] + arms[1] * springs[1]) / (arms[0] * arms[0] * springs[0] + arms[1] * arms[1] * springs[1]);
  const double felt = springs[0] * (1.0 - arms[0] * slope) + springs[1] * (1.0 - arms[1] * slope);
  EXPECT_NEAR(last(*touch, "Force"), -aside / (1.0 / held + 1.0 / felt), 1e-6);
  EXPECT_NEAR(last(*touch, "Torque", 1), 0.0, 1e-12);
}

TEST(TouchMechanism, ANeedleThatPassesThroughAWallThatNoLawJoinsItToIsSaid)
{
  std::ifstream stream(std::string(PALPATE_DATA_MECHANISMS) + "/needle.json");
  std::string text{ std::istreambuf_iterator<char>(stream), {} };
  const std::string file = std::string(::testing::TempDir()) + "palpate-open.json";
  const std::size_t skin = text.find("\"b\": \"wall\"");
  ASSERT_NE(skin, std::string::npos);
  text.replace(skin, 11, "\"b\": \"liver\""); // both laws are the liver's
  std::ofstream(file) << text;
  vtkNew<vtkHapticMechanism> source;
  source->SetFileName(file);
  source->Update();
  const auto touch = touchOf(*source, 0.0);
  std::vector<Vec3> path;
  for (int i = 0; i < 40; ++i)
  {
    path.emplace_back(0.0, 0.0, -8.0 - 150.0 + 0.1 * (i - 20) + 0.05); // the wall begins at -8
  }
  touch->SetPathData(makePath(path));
  touch->SetSetting("Scale", 1000.0);
  std::string said;
  const auto observer = vtkSmartPointer<vtkCallbackCommand>::New();
  observer->SetClientData(&said);
  observer->SetCallback([](vtkObject*, unsigned long, void* all, void* line)
    { *static_cast<std::string*>(all) += static_cast<const char*>(line); });
  touch->AddObserver(vtkCommand::WarningEvent, observer);
  touch->Update();
  std::filesystem::remove(file);
  EXPECT_TRUE(test::says(said, { "\"needle\"", "\"wall\"", "overlap" }));
}

TEST(TouchMechanism, WhatASceneFileLacksAndWhatAMechanismDoesNotFeelIsSaid)
{
  vtkNew<vtkHapticMechanism> none;
  none->SetFileName("nowhere.json");
  EXPECT_THAT(errorsOf(none), Contains(HasSubstr("nowhere.json: cannot be read")));
  const auto source = mechanism("lever.json");
  const auto touch = touchOf(*source, 0.0);
  touch->SetSetting("Radius", 1.0);
  EXPECT_THAT(errorsOf(touch), Contains(HasSubstr("Radius has no effect on a mechanism")));
}

TEST(TouchMechanism, TheSourceShowsItsBodiesAndSaysWhatTheyBecome)
{
  const auto source = mechanism("needle.json");
  vtkPolyData* const shapes = source->GetOutput();
  ASSERT_NE(shapes->GetCellData()->GetArray("Body"), nullptr);
  double bounds[6];
  shapes->GetBounds(bounds);
  EXPECT_NEAR(bounds[5], 150.0, 1e-5) << "the needle's tip, in single precision";
  EXPECT_THAT(source->GetText(), HasSubstr("3 bodies, 2 constraints"));
}

TEST(TouchMechanism, ALeverBelowNothingAndAMechanismThatATransformHasMovedAreRefusedInOneLine)
{
  const auto source = mechanism("lever.json");
  const auto below = touchOf(*source, -5.0);
  EXPECT_THAT(errorsOf(below), Contains(HasSubstr("must be a finite number")));
  vtkNew<vtkTransform> way;
  way->Translate(1.0, 0.0, 0.0);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetTransform(way);
  moved->SetInputConnection(source->GetOutputPort());
  const auto there = touchOf(*source, 0.0);
  there->SetInputConnection(moved->GetOutputPort());
  EXPECT_THAT(errorsOf(there), Contains(HasSubstr("scene file")));
}

TEST(TouchMechanism, EveryFileOfTheExamplesIsOne)
{
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PALPATE_DATA_MECHANISMS))
  {
    if (entry.path().extension() == ".json") // others are meshes of theirs
    {
      const std::string file = entry.path().string();
      EXPECT_EQ(vtkHapticReadMechanism(file).Problem, "");
      ++files;
    }
  }
  EXPECT_GT(files, 0);
}

TEST(TouchMechanism, ARodThatIsTurnedInTheHandIsFeltAndSeenWhereItIs)
{
  std::ifstream stream(std::string(PALPATE_DATA_MECHANISMS) + "/lever.json");
  std::string text{ std::istreambuf_iterator<char>(stream), {} };
  // Half a turn about x: the rod runs down, its springs stand below.
  for (const auto& [said, instead] :
    { std::pair("\"diameter\": 0.0012", "\"diameter\": 0.0012, \"turn\": [0, 1, 0, 0]"),
      std::pair("\"point_b\": [0, 0, 0.05]", "\"point_b\": [0, 0, -0.05]"),
      std::pair("\"point_b\": [0, 0, 0.15]", "\"point_b\": [0, 0, -0.15]") })
  {
    const std::size_t at = text.find(said);
    ASSERT_NE(at, std::string::npos) << said;
    text.replace(at, std::string(said).size(), instead);
  }
  const std::string file = std::string(::testing::TempDir()) + "palpate-turned.json";
  std::ofstream(file) << text;
  vtkNew<vtkHapticMechanism> turned;
  turned->SetFileName(file);
  turned->Update();
  std::filesystem::remove(file);
  EXPECT_NEAR(turned->GetOutput()->GetBounds()[4], -0.2, 1e-8) << "its tip";
  const auto upright = mechanism("lever.json");
  const double lever = std::sqrt(turning / held);
  const auto up = touchOf(*upright, lever), down = touchOf(*turned, lever);
  up->Update();
  down->Update();
  EXPECT_NEAR(last(*down, "Force"), last(*up, "Force"), 1e-12);
  EXPECT_NEAR(last(*down, "Force of organ"), last(*up, "Force of organ"), 1e-12);
  EXPECT_NEAR(last(*down, "Torque", 1), -last(*up, "Torque", 1), 1e-12);
}
