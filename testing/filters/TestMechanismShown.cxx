// SPDX-License-Identifier: GPL-3.0-or-later
// A mechanism in the hand as it is drawn: its soft bodies bent, the held body solid and as a ghost, and where the hand
// was when the bodies were computed last. Judges: the hand's spring, the needle's own place, and the whole stiffness of
// a body, assembled and solved here.
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "haptics/compliance/snapshot/SoftSurface.h"
#include "testing/support/Linear.h"
#include "testing/support/Says.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkHapticMechanism.h"
#include "vtkHapticMechanismFile.h"
#include "vtkHapticSight.h"
#include "vtkHapticToolProps.h"
#include "vtkHapticTouchedMechanism.h"
#include "vtkIdList.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::test;
using namespace palpate::testing;

namespace
{
constexpr int ticksOfRest = 1500;
constexpr double needle = 40.0, face = 40.0; // u: its length; the tissue's lower side
constexpr double rate_Hz = 20.0;
const Vec3 joint_W(3.0, 2.0, face);  // within a triangle of that side
const Vec3 corner_W(7.5, 0.0, face); // a vertex of it

/// A needle whose tip is joined to a block above it, which is fixed on top.
const std::string joined = R"({ "format": "palpate mechanism", "version": 1, "unit_m": 0.001,
  "bodies": [
    { "name": "needle", "kind": "held", "length": 40, "diameter": 1 },
    { "name": "tissue", "kind": "soft", "box": [60, 60, 15], "at": [0, 0, 47.5], "edge": 7.5, "fixed": "zmax",
      "young_Pa": 30000, "poisson": 0.4, "model": "linear", "tip_diameter": 0 },
    { "name": "plate", "kind": "soft", "box": [30, 30, 10], "at": [0, 0, 90], "edge": 10, "fixed": "zmax",
      "young_Pa": 30000, "poisson": 0.4, "model": "linear", "tip_diameter": 0 } ],
  "laws": [ )";
const std::string thread = R"({ "name": "thread", "kind": "attachment", "a": "needle", "b": "tissue",
  "point_a": [0, 0, 40], "point_b": [3, 2, 40] })";
const std::string knot = R"({ "name": "knot", "kind": "attachment", "a": "needle", "b": "tissue",
  "point_a": [0, 0, 40], "point_b": [7.5, 0, 40] })";
const std::string skin = R"({ "name": "skin", "kind": "puncture", "a": "needle", "b": "tissue", "strength_N": 50,
  "friction": 1 })";

/// Which nodes are fixed: a node halfway is where both ends of its edge are.
std::vector<bool> fixedNodes(const StrainPoints& points, std::vector<bool> fixed)
{
  for (const auto& [a, b] : points.halves)
  {
    fixed.push_back(fixed[a] && fixed[b]);
  }
  return fixed;
}

/// The stiffness of a body of Hooke's material, all of it [N/u]; a fixed node has its own unit row.
Eigen::MatrixXd stiffnessOf(const StrainPoints& points, const std::vector<bool>& fixed)
{
  const auto size = 3 * static_cast<Eigen::Index>(points.rest_W.size());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
  for (const StrainPoint& p : points.points)
  {
    const auto nodes = points.nodesOf(p);
    const auto g = points.gradientsOf(p);
    for (std::size_t a = 0; a < nodes.size(); ++a)
    {
      for (std::size_t b = 0; b < nodes.size(); ++b)
      {
        const Mat3 shear = g[a].dot(g[b]) * Mat3::Identity() + g[b] * g[a].transpose();
        k.block<3, 3>(3 * nodes[a], 3 * nodes[b]) +=
          p.volume_u3 * (p.moduli.lambda * g[a] * g[b].transpose() + p.moduli.mu * shear);
      }
    }
  }
  for (std::size_t v = 0; v < fixed.size(); ++v)
  {
    for (Eigen::Index i = 3 * static_cast<Eigen::Index>(v); fixed[v] && i < 3 * static_cast<Eigen::Index>(v + 1); ++i)
    {
      k.row(i).setZero();
      k.col(i).setZero();
      k(i, i) = 1.0;
    }
  }
  return k;
}

class MechanismShown : public VirtualSession
{
protected:
  MechanismShown()
  {
    this->session_->SetSetting("Passivity", false);
    this->session_->SetSetting("SoftRate", rate_Hz);
    this->session_->SetSetting("MechanismTurning", 1.0);
    this->session_->SetSetting("MechanismSource", "Mechanism1");
  }

  /// The hand straight below a place.
  void hold(const std::string& law, double tip, const Vec3& below_W = joint_W)
  {
    std::ofstream(this->folder_.file("scene.json")) << joined << law << "] }";
    this->source_->SetFileName(this->folder_.file("scene.json"));
    this->source_->Update();
    ASSERT_TRUE(this->session_->AddMechanism("Mechanism1", this->source_->GetAtFirst()))
      << this->session_->GetProblem();
    this->lead(Vec3(below_W.x(), below_W.y(), tip - needle));
    this->startTouching();
    this->session_->Step(ticksToEngage);
  }

  void lead(const Vec3& hand_W)
  {
    this->hand_W_ = hand_W;
    this->session_->SetHandPosition(hand_W.data());
  }

  void press(const Vec3& way_u)
  {
    constexpr int steps = 100;
    const Vec3 from_W = this->hand_W_;
    for (int i = 1; i <= steps; ++i)
    {
      this->lead(from_W + way_u * i / steps);
      this->session_->Step(1);
    }
    this->session_->Step(ticksOfRest);
    this->session_->Update();
  }

  [[nodiscard]] bool look()
  {
    this->shown_->ShallowCopy(this->source_->GetAtFirst());
    return this->session_->GetMechanism()->Move(this->shown_);
  }

  [[nodiscard]] Vec3 vectorAt(const char* array, vtkIdType point)
  {
    return Vec3(this->shown_->GetPointData()->GetArray(array)->GetTuple3(point));
  }

  /// Where a place of a body at first is seen now, within the triangle that it is in.
  [[nodiscard]] Vec3 seen(const Vec3& place_W)
  {
    vtkPolyData* const atFirst = this->source_->GetAtFirst();
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < atFirst->GetNumberOfCells(); ++cell)
    {
      atFirst->GetCellPoints(cell, corners);
      if (corners->GetNumberOfIds() != 3)
      {
        continue;
      }
      Mat3 at_W, now_W;
      for (int c = 0; c < 3; ++c)
      {
        at_W.col(c) = Vec3(atFirst->GetPoint(corners->GetId(c)));
        now_W.col(c) = Vec3(this->shown_->GetPoint(corners->GetId(c)));
      }
      const Vec3 weights = palpate::test::solved(at_W, place_W);
      if (weights.minCoeff() > 0.0 && std::abs(weights.sum() - 1.0) < 1e-9)
      {
        return now_W * weights;
      }
    }
    ADD_FAILURE() << "no triangle";
    return Vec3::Zero();
  }

  [[nodiscard]] Vec3 felt() { return Vec3(this->session_->GetToolPose()); }
  [[nodiscard]] Vec3 tip()
  {
    const double* const pose = this->session_->GetToolPose();
    return Vec3(pose) + Quat(pose[3], pose[4], pose[5], pose[6]) * Vec3(0, 0, needle);
  }

  /// How far a vertex has gone: its node, and the patch of the border around it.
  struct Gone
  {
    int vertex = 0;
    Vec3 node;
    Vec3 patch;
  };
  /// The block as it bends under a force on the corner, solved with the whole stiffness.
  [[nodiscard]] std::vector<Gone> solved(const Vec3& force_N)
  {
    const auto read = vtkHapticReadMechanism(this->folder_.file("scene.json"));
    SoftBodyResult made = makeSoftBody(*read.Inputs->soft[0].input);
    const SoftSurface surface = makeSoftSurface(*made.body, made.checked.mesh);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(made.body->displacement().size());
    for (std::size_t i = 0; i < surface.rest_W.size(); ++i)
    {
      if (surface.rest_W[i] == corner_W)
      {
        surface.map.addForce(i, force_N, load);
      }
    }
    const std::vector<bool> fixed = fixedNodes(made.body->points(), made.checked.fixed);
    for (std::size_t v = 0; v < fixed.size(); ++v)
    {
      load.segment<3>(3 * static_cast<Eigen::Index>(v)) *= fixed[v] ? 0.0 : 1.0;
    }
    const Eigen::VectorXd u = palpate::test::solvedSymmetric(stiffnessOf(made.body->points(), fixed), load);
    std::vector<Gone> all;
    for (std::size_t i = 0; i < surface.vertices.size(); ++i)
    {
      const std::uint32_t v = surface.vertices[i];
      all.push_back({ static_cast<int>(made.checked.sourceVertex[v]), u.segment<3>(3 * static_cast<Eigen::Index>(v)),
        surface.map.displacementOf(i, u) });
    }
    return all;
  }

  TemporaryFolder folder_;
  vtkNew<vtkHapticMechanism> source_;
  vtkNew<vtkPolyData> shown_;
  Vec3 hand_W_ = Vec3::Zero();
};
} // namespace

TEST_F(MechanismShown, AJoinedPlaceIsSeenWhereTheHandsSpringAndTheNeedlesTipSayThatItIs)
{
  this->hold(thread, face);
  this->press(Vec3(1.0, -0.5, 2.0));
  ASSERT_TRUE(this->look());
  const Vec3 force_N(this->session_->GetForce());
  ASSERT_GT(force_N.norm(), 0.3);
  EXPECT_LE((this->felt() - (this->hand_W_ + force_N * scale / stiffness)).norm(), 1e-6);
  EXPECT_GT((this->tip() - joint_W).norm(), 0.2);
  EXPECT_LE((this->seen(joint_W) - this->tip()).norm(), 1e-6);
}

TEST_F(MechanismShown, EveryPlaceOfABodyIsSeenWhereASolveWithItsWholeStiffnessHasIt)
{
  this->hold(knot, face, corner_W);
  this->press(Vec3(1.0, -0.5, 4.0));
  ASSERT_TRUE(this->look());
  const auto expected = this->solved(-Vec3(this->session_->GetForce()));
  vtkDataArray* const bodies = this->shown_->GetPointData()->GetArray("Body");
  vtkDataArray* const vertices = this->shown_->GetPointData()->GetArray("Vertex");
  std::size_t seen = 0;
  int corners = 0;
  double most = 0.0;
  for (vtkIdType i = 0; i < this->shown_->GetNumberOfPoints(); ++i)
  {
    const auto vertex = static_cast<int>(vertices->GetComponent(i, 0));
    const auto own =
      std::find_if(expected.begin(), expected.end(), [vertex](const auto& e) { return e.vertex == vertex; });
    const bool ofTissue = bodies->GetComponent(i, 0) == 1.0;
    ASSERT_EQ(vertex >= 0, bodies->GetComponent(i, 0) > 0.0) << "the needle alone has none";
    ASSERT_TRUE(!ofTissue || own != expected.end()) << vertex;
    const Vec3 gone = ofTissue ? own->node : Vec3(Vec3::Zero()); // the plate is not touched
    EXPECT_LE((this->vectorAt("Displacement", i) - gone).norm(), 1e-6) << i;
    const bool isCorner = ofTissue && (Vec3(this->source_->GetAtFirst()->GetPoint(i)) - corner_W).norm() < 1e-6;
    const Vec3 dent = isCorner ? Vec3(own->patch - own->node) : Vec3(Vec3::Zero()); // felt by its patch
    EXPECT_LE((this->vectorAt("Dent", i) - dent).norm(), 1e-6) << i;
    corners += isCorner ? 1 : 0;
    seen += ofTissue ? 1 : 0;
    most = std::max(most, gone.norm());
  }
  EXPECT_EQ(seen, expected.size());
  EXPECT_EQ(corners, 1);
  EXPECT_GT(most, 0.3);
}

TEST_F(MechanismShown, ASurfaceThatATipPressesOnGoesWithTheTipAndBackToWhereItWas)
{
  this->hold(skin, face - 2.0);
  this->press(Vec3(0, 0, 5.0));
  ASSERT_TRUE(this->look());
  ASSERT_GT(this->session_->GetForceMagnitude(), 0.3);
  EXPECT_GT(this->tip().z() - face, 0.3);
  EXPECT_NEAR(this->seen(joint_W).z(), this->tip().z(), 1e-6);
  this->press(Vec3(0, 0, -6.0));
  ASSERT_TRUE(this->look()) << "the needle is in the hand";
  EXPECT_EQ(this->session_->GetForceMagnitude(), 0.0);
  EXPECT_LE(this->shown_->GetPointData()->GetArray("Displacement")->GetMaxNorm(), 1e-12);
  this->session_->TouchingOff();
  this->session_->Update();
  EXPECT_FALSE(this->look());
}

TEST_F(MechanismShown, OtherLawsOfTheSameBodiesLeaveThemWhereTheyAreSeenUntilTheyAreFelt)
{
  this->hold(thread, face);
  this->press(Vec3(0, 0, 4.0));
  ASSERT_TRUE(this->look());
  const Vec3 before = this->seen(joint_W);
  ASSERT_GT(before.z() - face, 0.3);
  const double depth = this->session_->GetMechanismDepth();
  ASSERT_GT(depth, 3.0);
  this->session_->SetSetting("MechanismConstraints", ("[" + skin + "]").c_str());
  this->session_->Update();
  ASSERT_TRUE(this->look());
  EXPECT_LE((this->seen(joint_W) - before).norm(), 1e-12);
  EXPECT_EQ(this->session_->GetMechanismDepth(), depth);
  EXPECT_TRUE(test::says(this->session_->GetMechanismText(), { "Mechanism1: 1 constraints", "being computed" }));
  this->session_->Step(ticksOfRest);
  this->session_->Update();
  ASSERT_TRUE(this->look());
  EXPECT_LE(this->shown_->GetPointData()->GetArray("Displacement")->GetMaxNorm(), 1e-9) << "nothing joins them now";
}

TEST_F(MechanismShown, TheTextNamesABodyThatTheNeedlePassesThroughAsLongAsItDoes)
{
  this->hold(R"({ "name": "string", "kind": "spring", "a": "needle", "b": "plate", "axis_b": [0, 0, 1],
    "point_a": [0, 0, 40], "point_b": [0, 0, 85], "stiffness_N_per_m": 1 })",
    face - 5.0);
  const std::string said = "now bodies \"needle\" and \"tissue\" overlap: no active constraint joins them";
  const auto text = [this] { return std::string(this->session_->GetMechanismText()); };
  this->press(Vec3(0, 0, 1.0));
  EXPECT_EQ(text().find("overlap"), std::string::npos) << text();
  this->press(Vec3(0, 0, 9.0));
  EXPECT_NE(text().find(said), std::string::npos) << text();
  this->press(Vec3(0, 0, -9.0));
  EXPECT_EQ(text().find("overlap"), std::string::npos) << text();
}

TEST_F(MechanismShown, WhatIsHeldIsSolidWhereItIsFeltAGhostWhereTheHandIsAndABallWhereTheHandWas)
{
  this->hold(thread, face);
  this->session_->SetSetting("ShowSoftHand", true);
  this->press(Vec3(1.0, 0, 2.0));
  constexpr double perTick = 0.01; // u
  constexpr int ticks = 220;
  for (int i = 0; i < ticks; ++i)
  {
    this->lead(this->hand_W_ + Vec3(0, 0, perTick));
    this->session_->Step(1);
  }
  this->session_->Update();
  vtkNew<vtkHapticToolProps> props;
  props->UpdateFrom(this->session_);
  for (vtkActor* const ball : { props->GetProxyActor(), props->GetHandActor() })
  {
    EXPECT_FALSE(ball->GetVisibility());
  }
  const auto tipOf = [](vtkActor* actor)
  {
    const double own[4] = { 0.0, 0.0, needle, 1.0 }; // of the needle, from the hand along +z
    double at[4];
    actor->GetMatrix()->MultiplyPoint(own, at);
    EXPECT_TRUE(actor->GetVisibility());
    return Vec3(at);
  };
  double box[6];
  this->session_->GetSight()->GetToolShape(this->shown_);
  this->shown_->GetBounds(box);
  EXPECT_NEAR(box[4], 0.0, 1e-6);
  EXPECT_NEAR(box[5], needle, 1e-4) << "single precision";
  const double* const pose = this->session_->GetToolPose();
  const Quat turn(pose[3], pose[4], pose[5], pose[6]); // which the device leaves free
  EXPECT_GT(turn.angularDistance(Quat::Identity()), 0.01);
  EXPECT_LE((tipOf(props->GetGhostActor()) - (this->hand_W_ + turn * Vec3(0, 0, needle))).norm(), 1e-9);
  EXPECT_LE((tipOf(props->GetHeldActor()) - this->tip()).norm(), 1e-9);
  const Vec3 force_N(this->session_->GetForce());
  const Vec3 felt(props->GetHeldActor()->GetMatrix()->Element[0][3], props->GetHeldActor()->GetMatrix()->Element[1][3],
    props->GetHeldActor()->GetMatrix()->Element[2][3]);
  EXPECT_LE((felt - (this->hand_W_ + force_N * scale / stiffness)).norm(), 1e-6);
  EXPECT_GT((felt - this->hand_W_).norm(), 0.5);
  EXPECT_TRUE(props->GetSoftHandActor()->GetVisibility());
  const Vec3 was(props->GetSoftHandActor()->GetPosition());
  const double behind = (this->hand_W_ - was).z() / perTick; // ticks
  EXPECT_LE((this->hand_W_ - was).head<2>().norm(), 1e-12);
  EXPECT_NEAR(behind, std::round(behind), 1e-6) << "it was there in a tick";
  EXPECT_GE(behind, 1.0 - 1e-6);
  EXPECT_LE(behind, 1000.0 / rate_Hz + 1e-6);
  this->session_->SetSetting("MechanismSource", "");
  this->session_->Step(1);
  this->session_->Update();
  props->UpdateFrom(this->session_);
  EXPECT_FALSE(props->GetHeldActor()->GetVisibility());
}
