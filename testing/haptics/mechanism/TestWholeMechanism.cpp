// SPDX-License-Identifier: GPL-3.0-or-later
// The rod through two soft blocks against all of their nodes and the statics of the finite turn of the rod.
#include <gtest/gtest.h>

#include "haptics/tool/motion/Turn.h"
#include "testing/haptics/compliance/SoftPads.h"
#include "testing/oracles/statics/HeldRod.h"
#include "testing/support/Linear.h"
#include "testing/support/MechanismRig.h"

namespace palpate::test
{
namespace
{

/// A pad somewhere, as the tick gets it and as the stiffness of its free nodes.
class WholePad
{
public:
  WholePad(int cells, const Vec3& shift_W, std::uint64_t revision)
    : shift_W_(shift_W), pad_(cells, patchEdges, ElementKind::EdgeSmoothed,
                           [&shift_W](SoftBodyInput& input)
                           {
                             for (Vec3& p : input.mesh.vertices_W)
                             {
                               p += shift_W;
                             }
                           })
  {
    SnapshotRequest request;
    request.ball_W = this->top_W();
    this->snapshot_ = SnapshotMaker(*this->pad_.body, this->pad_.surface).make(request);
    SurfaceInput input;
    input.name = "pad";
    input.mesh = std::make_shared<TriangleMesh>(TriangleMesh{ this->snapshot_->free_W, this->pad_.surface.triangles });
    input.ordered = true;
    auto body = std::make_shared<PressedBody>();
    body->revision = revision;
    body->scene = SceneBuilder().build({ input }, nullptr).scene;
    body->snapshot = this->snapshot_;
    body->touch = { 0, this->snapshot_.get() };
    this->pressed = body;
    for (std::size_t v = 0; v < this->pad_.mesh.vertices_W.size(); ++v)
    {
      for (std::size_t k = 0; k < 3 && this->pad_.mesh.vertices_W[v].z() > shift_W.z() + 1e-9; ++k)
      {
        this->free_.push_back(static_cast<Eigen::Index>(3 * v + k));
      }
    }
  }

  [[nodiscard]] Vec3 top_W() const { return middleOfPad() + this->shift_W_; }
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(this->free_.size()); }

  /// Column by column: forces of the strain on the nodes where one of them is displaced by a metre.
  [[nodiscard]] Eigen::MatrixXd stiffness()
  {
    Eigen::MatrixXd k(this->size(), this->size());
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(this->pad_.body->displacement().size());
    for (Eigen::Index i = 0; i < this->size(); ++i)
    {
      Eigen::VectorXd displaced = rest;
      displaced[this->free_[static_cast<std::size_t>(i)]] = 1.0;
      this->pad_.body->place(displaced);
      k.col(i) = -this->pad_.body->innerForces()(this->free_);
    }
    this->pad_.body->place(rest);
    return k;
  }

  /// Forces on the free nodes by a unit of force on the middle of the top, along each axis.
  [[nodiscard]] Eigen::MatrixXd topForces() const
  {
    std::size_t top = 0;
    const auto& rest_W = this->pad_.surface.rest_W;
    for (std::size_t v = 0; v < rest_W.size(); ++v)
    {
      top = (rest_W[v] - this->top_W()).norm() < (rest_W[top] - this->top_W()).norm() ? v : top;
    }
    Eigen::MatrixXd forces(this->size(), 3);
    for (int k = 0; k < 3; ++k)
    {
      Eigen::VectorXd load = Eigen::VectorXd::Zero(this->pad_.body->displacement().size());
      this->pad_.surface.map.addForce(top, Vec3::Unit(k), load);
      forces.col(k) = load(this->free_);
    }
    return forces;
  }

  std::shared_ptr<const PressedBody> pressed;

private:
  Vec3 shift_W_;
  SoftPad pad_;
  std::shared_ptr<const ComplianceSnapshot> snapshot_;
  std::vector<Eigen::Index> free_;
};

TEST(WholeMechanism, SixRowsOfTheTickAreTheAnswerOfAllFourteenHundredUnknownsHoweverTheRodLeans)
{
  WholePad wall(8, Vec3::Zero(), 1);
  WholePad organ(6, Vec3(0.0, 0.0, -0.08), 2);
  MechanismRig rig(0.2);
  rig.addSoft("wall", wall.pressed);
  rig.addSoft("organ", organ.pressed);
  for (const auto& [name, pad] : { std::pair("wall", &wall), std::pair("organ", &organ) })
  {
    rig.join(ConstraintKind::Insertion, name, Vec3::Zero(), pad->top_W()).dryFriction_N = 100.0; // it sticks
  }
  const Vec3 origin_W = middleOfPad() + Vec3(0.0, 0.0, 0.04);
  const Quat down(0.0, 1.0, 0.0, 0.0);
  (void)rig.step(Pose{ origin_W, down });
  const Pose hand_W{ origin_W + Vec3(2e-3, -1e-3, -1.5e-3), turnBy(Vec3(0.01, -0.02, 0.03)) * down };
  const MechanismResult& r = rig.step(hand_W);

  // Every node of both pads has a share in the inverse of the whole stiffness: the yield of the tops is condensed from
  // it.
  ASSERT_EQ(wall.size() + organ.size() + 18, 1431) << "and the rod, the device and six rows";
  std::array<Mat3, 2> yields;
  std::array<Vec3, 2> tops, places; // places on the rod, which stay the same
  for (std::size_t i = 0; WholePad * pad : { &wall, &organ })
  {
    const Eigen::MatrixXd forces = pad->topForces();
    yields[i] = forces.transpose() * solvedSymmetric(pad->stiffness(), forces);
    tops[i] = pad->top_W();
    places[i++] = down.conjugate() * (pad->top_W() - origin_W);
  }
  const HeldRod rod{ hand_W.p, hand_W.q, kc, kr };
  const auto energy = [&](const FiniteStatics::Coordinates& z)
  {
    Jet sum = rod.energy(z);
    for (std::size_t i = 0; i < yields.size(); ++i)
    {
      const JetVector force = kc * FiniteStatics::vectorOf(z, 6 + 3 * i);
      const JetVector yielded{ dot(Vec3(yields[i].col(0)), force), dot(Vec3(yields[i].col(1)), force),
        dot(Vec3(yields[i].col(2)), force) };
      sum = sum + dot(force, rod.point(z, places[i]) - tops[i]) - 0.5 * dot(force, yielded);
    }
    return sum;
  };
  Eigen::VectorXd z = Eigen::VectorXd::Zero(12);
  ASSERT_TRUE(FiniteStatics::makeStationary(energy, z));
  EXPECT_LE((r.laws[0].force_W + kc * z.segment<3>(6)).norm(), 1e-12);
  EXPECT_LE((r.laws[1].force_W + kc * z.segment<3>(9)).norm(), 1e-12);
  EXPECT_LE((r.exact_W.force - rod.force(z)).norm(), 1e-12);
  EXPECT_LE((r.exact_W.torque - rod.moment(z)).norm(), 1e-12);
  EXPECT_GT(r.exact_W.force.norm(), 0.1);
}

} // namespace
} // namespace palpate::test
