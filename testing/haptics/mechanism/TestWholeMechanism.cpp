// SPDX-License-Identifier: GPL-3.0-or-later
// The rod through two soft blocks against all of their nodes, the rod, the device and the laws in one system.
#include <gtest/gtest.h>

#include "testing/haptics/compliance/SoftPads.h"
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
    PacketRequest request;
    request.ball_W = this->top_W();
    this->packet_ = PacketMaker(*this->pad_.body, this->pad_.surface).make(request);
    SurfaceInput input;
    input.name = "pad";
    input.mesh = std::make_shared<TriangleMesh>(TriangleMesh{ this->packet_->free_W, this->pad_.surface.triangles });
    input.ordered = true;
    auto body = std::make_shared<PressedBody>();
    body->revision = revision;
    body->scene = SceneBuilder().build({ input }, nullptr).scene;
    body->packet = this->packet_;
    body->touch = { 0, this->packet_.get() };
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

  /// Column by column: what strain puts on the nodes where one of them is displaced by a metre.
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
  std::shared_ptr<const CompliancePacket> packet_;
  std::vector<Eigen::Index> free_;
};

TEST(WholeMechanism, SixRowsOfTheTickAreTheAnswerOfAllFourteenHundredUnknowns)
{
  WholePad wall(8, Vec3::Zero(), 1);
  WholePad organ(6, Vec3(0.0, 0.0, -0.08), 2);
  MechanismRig rig(0.2);
  rig.addSoft("wall", wall.pressed);
  rig.addSoft("organ", organ.pressed);
  for (const auto& [name, pad] : { std::pair("wall", &wall), std::pair("organ", &organ) })
  {
    rig.join(LawKind::Insertion, name, Vec3::Zero(), pad->top_W()).dryFriction_N = 100.0; // it sticks
  }
  const Vec3 origin_W = middleOfPad() + Vec3(0.0, 0.0, 0.04);
  const Quat down(0.0, 1.0, 0.0, 0.0);
  (void)rig.step(Pose{ origin_W, down });
  constexpr double small =
    1e-6; // the system below is one of small turns: a share of the forces, of that size, it lacks
  const Vec3 moved_W = small * Vec3(2e-3, -1e-3, -1.5e-3);
  const MechanismResult& r = rig.step(Pose{ origin_W + moved_W, down });

  // Unknown: displacements of both pads, motion of the rod and of the device, forces of the rows along x, y, z.
  const Eigen::Index w = wall.size(), o = organ.size(), rod = w + o, device = rod + 6, rows = device + 6, n = rows + 6;
  ASSERT_EQ(n, 1431);
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  m.block(0, 0, w, w) = wall.stiffness();
  m.block(w, w, o, o) = organ.stiffness();
  Eigen::Matrix<double, 6, 1> grip;
  grip << Vec3::Constant(kc), Vec3::Constant(kr);
  m.block<6, 6>(rod, rod) = grip.asDiagonal();
  m.block<6, 6>(rod, device) = -Eigen::MatrixXd(grip.asDiagonal());
  m.block<6, 6>(device, device).setIdentity();
  right.segment<3>(device) = moved_W;
  int row = 0;
  for (const WholePad* pad : { &wall, &organ })
  {
    // About the device's place, where the rows are linearised: the shaft beside the hole.
    const Vec3 hand_W = origin_W + moved_W;
    const Vec3 arm_W(0.0, 0.0, pad->top_W().z() - hand_W.z());
    Eigen::Matrix<double, 3, 6> j;
    j.leftCols<3>().setIdentity();
    j.rightCols<3>() << 0.0, arm_W.z(), 0.0, -arm_W.z(), 0.0, 0.0, 0.0, 0.0, 0.0;
    const Eigen::MatrixXd h = pad->topForces();
    const Eigen::Index first = pad == &wall ? 0 : w;
    m.block(rows + row, rod, 3, 6) = j;
    m.block(rod, rows + row, 6, 3) = -j.transpose();
    m.block(rows + row, first, 3, h.rows()).transpose() = -h;
    m.block(first, rows + row, h.rows(), 3) = h;
    row += 3;
  }
  const Eigen::VectorXd x = m.partialPivLu().solve(right);
  ASSERT_LE(
    (m * x - right).lpNorm<Eigen::Infinity>(), 1e-12 * x.lpNorm<Eigen::Infinity>() * m.lpNorm<Eigen::Infinity>());
  const Vec3 hand_N = x.segment<3>(rows) + x.segment<3>(rows + 3);
  EXPECT_LE((r.laws[0].force_W - x.segment<3>(rows)).norm(), 1e-12);
  EXPECT_LE((r.laws[1].force_W - x.segment<3>(rows + 3)).norm(), 1e-12);
  EXPECT_LE((r.exact_W.force - hand_N).norm(), 1e-12);
  EXPECT_LE((r.exact_W.force - hand_N).norm(), small * hand_N.norm());
  EXPECT_GT(hand_N.norm(), small * 0.1);
}

} // namespace
} // namespace palpate::test
