// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

namespace palpate::test
{

/// A thin rod in the plane that is pushed from a sheath into a channel: many short pieces that stretch, joints that
/// bend, walls by penalty at each joint, Coulomb's friction by the slip of a step, smoothed below a micrometre. Each
/// step is solved to rest by Newton's method with an exact Jacobian. Units: mm, N.
class RodInChannel
{
public:
  struct Form
  {
    double length_mm = 100.0;
    int pieces = 500;
    double stretch_N = 1.0;     ///< E A
    double bend_Nmm2 = 1.0;     ///< E I
    double first_mm = 40.0;     ///< of the channel along x, which begins at the origin
    double middle_mm = 25.0;    ///< radius of the bend's middle line, towards y
    double angle_rad = 0.0;     ///< of the bend
    double clearance_mm = 0.75; ///< of the rod's middle line from that of the channel
    double friction = 0.0;
    double hand_N_per_mm = 1.0;
  };

  explicit RodInChannel(const Form& form);
  /// The hand is so far along x, from where the rod's tip is at the origin. The force that it pushes with.
  double push(double hand_mm);
  /// Whether the last step came to rest.
  [[nodiscard]] bool rests() const { return this->rests_; }
  [[nodiscard]] Eigen::Vector2d tip() const { return this->at_.tail<2>(); }
  /// The largest force of the walls on a joint.
  [[nodiscard]] double largestWall_N() const;

private:
  static constexpr int half = 5; ///< half the width of the band
  struct Wall
  {
    double off_mm = 0.0; ///< beyond the clearance; below 0: free
    Eigen::Vector2d out;
    double bends_per_mm = 0.0; ///< how fast `out` turns along the wall, with its sign
  };
  [[nodiscard]] Wall wallAt(const Eigen::Vector2d& p) const;
  void assemble(double hand_mm);
  void addPieces();
  void addJoints();
  void addWalls();
  void addBlock(int row, int column, const Eigen::Matrix2d& block);
  [[nodiscard]] double& band(int row, int column);
  [[nodiscard]] Eigen::VectorXd solve(double drag) const;

  Form form_;
  double piece_mm_ = 0.0;
  Eigen::VectorXd at_;     ///< of the joints, two numbers each
  Eigen::VectorXd before_; ///< at the end of the step before
  Eigen::VectorXd force_;  ///< on the joints
  Eigen::MatrixXd band_;   ///< minus its derivative, rows of 2 half + 1
  int out_ = 0; ///< the first joint that was out of the sheath before; those that come back beside it are not in it
  bool rests_ = true;
};

} // namespace palpate::test
