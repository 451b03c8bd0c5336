// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/move/ToolPair.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

using Mat6 = Eigen::Matrix<double, 6, 6>;
constexpr int mostTurns = 12; // of both, in an update
constexpr double still = 1.0; // rest gaps: a smaller motion is none

Pose relative(const Pose& frame_W, const Pose& pose_W)
{
  const Quat back = frame_W.q.conjugate();
  return { back * (pose_W.p - frame_W.p), (back * pose_W.q).normalized() };
}

Mat3 crossing(const Vec3& v)
{
  Mat3 m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// Compliance of a body to a wrench about its centre.
Mat6 compliance(const ToolPair::Hold& hold)
{
  Vec6 diagonal = Vec6::Constant(1.0 / hold.stiffness_N_per_u);
  diagonal.tail<3>() /= hold.characteristic_u * hold.characteristic_u;
  return diagonal.asDiagonal();
}

/// The motion to the hand, its rotation in rad.
Vec6 wishOf(const Pose& pose_W, const Pose& hand_W)
{
  bool cut = false;
  return wishedMotion(pose_W, hand_W, 1.0, cut);
}

Pose moved(const Pose& pose_W, const Vec6& motion)
{
  return { pose_W.p + motion.head<3>(), (turnBy(motion.tail<3>()) * pose_W.q).normalized() };
}

/// The row of a contact in the frame of the other tool, for the motion of the one relative to the other, about the
/// centre of the one.
Vec6 rowOf(const ToolContact& contact, const Quat& other_W)
{
  const Vec3 n_W = other_W * contact.n_W, arm_W = other_W * contact.arm_W;
  Vec6 row;
  row << n_W, arm_W.cross(n_W);
  return row;
}

std::shared_ptr<const BoxedMesh> asScene(const ToolMesh& of, const ToolMesh& against)
{
  return makeToolScene(of.shape_B->mesh(), against);
}

} // namespace

ToolPair::ToolPair(const ToolMesh& one, const ToolMesh& other, const std::array<Hold, 2>& holds)
  : holds_(holds), moves_{ ToolMove(one, asScene(other, one), holds[0].characteristic_u),
      ToolMove(other, asScene(one, other), holds[1].characteristic_u) }
{
}

std::string ToolPair::place(const Poses& poses_W)
{
  std::string refusal = this->moves_[0].place(relative(poses_W[1], poses_W[0]));
  refusal = refusal.empty() ? this->moves_[1].place(relative(poses_W[0], poses_W[1])) : refusal;
  this->poses_W_ = refusal.empty() ? poses_W : this->poses_W_;
  return refusal;
}

/// The dual problem of both: one wrench pushes the tools apart, under which their relative motion is the
/// nearest to the wished one that the contacts allow, in the sum of both compliances.
ToolPair::Motion ToolPair::nearestOfBoth(const Poses& hands_W) const
{
  const Vec6 one = wishOf(this->poses_W_[0], hands_W[0]), other = wishOf(this->poses_W_[1], hands_W[1]);
  Mat6 carry = Mat6::Identity(); // takes a motion of the other to the centre of the one
  carry.topRightCorner<3, 3>() = -crossing(this->poses_W_[0].p - this->poses_W_[1].p);
  const Mat6 ofOne = compliance(this->holds_[0]), ofOther = compliance(this->holds_[1]);
  const Eigen::LLT<Mat6> whitening(ofOne + carry * ofOther * carry.transpose());
  const ToolContacts set = this->moves_[0].contacts();
  std::vector<MotionRow> rows;
  for (std::uint32_t i = 0; i < set.count; ++i)
  {
    const Vec6 row = whitening.matrixU() * rowOf(set.contacts[i], this->poses_W_[1].q);
    const double least = std::min(0.0, set.restGap_u - set.contacts[i].gap_u);
    rows.push_back({ row / row.norm(), least / row.norm() });
  }
  const Vec6 wish = whitening.matrixL().solve(one - carry * other);
  const NearestMotion nearest = nearestMotion(rows, wish);
  const Vec6 wrench = whitening.matrixU().solve(nearest.feasible ? Vec6(nearest.y - wish) : Vec6(-wish));
  const Vec6 onOther = -(carry.transpose() * wrench);
  const Vec6 oneGoes = one + ofOne * wrench, otherGoes = other + ofOther * onOther;
  Motion motion;
  motion.goals_W = { moved(this->poses_W_[0], oneGoes), moved(this->poses_W_[1], otherGoes) };
  motion.pushes = { Wrench{ wrench.head<3>(), wrench.tail<3>() }, Wrench{ onOther.head<3>(), onOther.tail<3>() } };
  motion.way_u = std::max(oneGoes.head<3>().norm() + oneGoes.tail<3>().norm() * this->moves_[0].tool().reach_u,
    otherGoes.head<3>().norm() + otherGoes.tail<3>().norm() * this->moves_[1].tool().reach_u);
  return motion;
}

/// One tool moves while the other stands still. The proof holds for the other one, too.
void ToolPair::move(std::size_t tool, const Pose& goal_W, std::uint64_t work)
{
  const std::size_t other = 1 - tool;
  const Pose& frame_W = this->poses_W_[other];
  this->moves_[tool].update(relative(frame_W, goal_W), work);
  const Pose& at = this->moves_[tool].pose_W();
  this->poses_W_[tool] = { frame_W.q * at.p + frame_W.p, (frame_W.q * at.q).normalized() };
  this->moves_[other].stand(relative(this->poses_W_[tool], this->poses_W_[other]));
}

bool ToolPair::update(const Poses& hands_W, std::uint64_t work)
{
  const double still_u = still * this->moves_[0].tool().restGap_u();
  for (int turn = 0; turn < mostTurns; ++turn)
  {
    const Motion motion = this->nearestOfBoth(hands_W);
    if (motion.way_u < still_u)
    {
      return true;
    }
    this->move(1, motion.goals_W[1], work);
    this->move(0, motion.goals_W[0], work);
  }
  return false;
}

ToolPair::Pushes ToolPair::pushes(const Poses& hands_W) const
{
  return this->nearestOfBoth(hands_W).pushes;
}

} // namespace palpate
