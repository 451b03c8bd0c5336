// SPDX-License-Identifier: GPL-3.0-or-later
// A soft bar is pressed onto a mesh that stands behind it: when it meets that mesh, and how much of the hand's force
// the mesh bears, against a finite element solve with all contacts at once that is written apart.
#include <cmath>

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "HeldMesh.h"

namespace palpate::test
{
namespace
{

const Vec3 barSize(0.1, 0.04, 0.02);
constexpr double barYoung_Pa = 200e3, barPoisson = 0.3, gap_m = 0.002;

/// A bar along x that is held at x = 0, of four-node tetrahedra.
SoftBodyInput bar(const std::array<int, 3>& cells)
{
  SoftBodyInput input;
  input.mesh = blockOf(cells, barSize);
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
  input.young_Pa = { barYoung_Pa };
  input.poisson = barPoisson;
  input.element = ElementKind::Linear;
  input.model = ElasticModel::Linear;
  return input;
}

/// A mesh in the hand, that bar, and a block that stands below its free end.
MechanismInputs onBarAndBlock(const TriangleMesh& mesh, const std::array<int, 3>& cells, double friction = 0.0)
{
  MechanismInputs inputs;
  MechanismBody tool, soft, block;
  tool.name = "tool";
  tool.kind = MechanismBodyKind::Held;
  tool.mesh = heldMesh(mesh);
  soft.name = "bar";
  soft.kind = MechanismBodyKind::Soft;
  block.name = "block";
  block.mesh = heldMesh(makeBox(Vec3(0.05, -0.02, -0.03), Vec3(0.15, 0.06, -gap_m)));
  inputs.mechanism.bodies = { tool, soft, block };
  inputs.mechanism.findsContacts = true;
  inputs.mechanism.foundFriction = friction;
  inputs.soft = { { "bar", std::make_shared<const SoftBodyInput>(bar(cells)) } };
  return inputs;
}

/// Of four-node tetrahedra (Zienkiewicz & Taylor), with contacts of all its lower vertices at once: an active set, a
/// vertex more or less at a time, until none reaches through and none draws.
class WholeBar
{
public:
  explicit WholeBar(const SoftBodyInput& input) : vertices_(input.mesh.vertices_W), row_(vertices_.size(), -1)
  {
    int rows = 0;
    for (std::size_t v = 0; v < this->vertices_.size(); ++v)
    {
      this->row_[v] = input.fixed[v] ? -1 : 3 * rows++;
      if (this->row_[v] >= 0 && this->vertices_[v].z() == 0.0 && this->vertices_[v].x() >= 0.05)
      {
        this->lower_.push_back(v);
      }
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (const Tetra& t : input.mesh.tetras)
    {
      this->addTetra(t, entries);
    }
    this->stiffness_.resize(3 * rows, 3 * rows);
    this->stiffness_.setFromTriplets(entries.begin(), entries.end());
    this->factor_.compute(this->stiffness_);
    this->columns_ = Eigen::MatrixXd::Zero(3 * rows, static_cast<Eigen::Index>(this->lower_.size()));
    for (std::size_t k = 0; k < this->lower_.size(); ++k)
    {
      this->columns_(this->row_[this->lower_[k]] + 2, static_cast<Eigen::Index>(k)) = 1.0;
    }
    this->columns_ = this->factor_.solve(this->columns_).eval();
  }

  /// Under these forces at these places of its surface.
  void press(std::span<const MechanismPress> presses)
  {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(this->stiffness_.rows());
    for (const MechanismPress& press : presses)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        const int row = this->row_[press.at.vertices[c]];
        if (row >= 0)
        {
          load.segment<3>(row) += press.at.weights[static_cast<Eigen::Index>(c)] * press.force_N;
        }
      }
    }
    this->free_ = this->factor_.solve(load);
  }
  /// The least gap to the block if that were not there [m].
  [[nodiscard]] double leastGap_m() const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t v : this->lower_)
    {
      least = std::min(least, gap_m + this->free_[this->row_[v] + 2]);
    }
    return least;
  }
  /// Force of the block on the bar, upwards [N].
  [[nodiscard]] double borne_N() const
  {
    const auto count = static_cast<Eigen::Index>(this->lower_.size());
    Eigen::MatrixXd compliance(count, count);
    Eigen::VectorXd gap(count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const int row = this->row_[this->lower_[static_cast<std::size_t>(i)]] + 2;
      compliance.row(i) = this->columns_.row(row);
      gap[i] = gap_m + this->free_[row];
    }
    std::vector<Eigen::Index> active;
    Eigen::VectorXd force = Eigen::VectorXd::Zero(count);
    for (int left = 1000; left > 0; --left)
    {
      Eigen::Index worst = 0;
      force.setZero();
      if (!active.empty())
      {
        force(active) = compliance(active, active).ldlt().solve(-Eigen::VectorXd(gap(active))).eval();
      }
      if (force.minCoeff(&worst) < -1e-12)
      {
        std::erase(active, worst);
        continue;
      }
      if (Eigen::VectorXd(gap + compliance * force).minCoeff(&worst) > -1e-12)
      {
        return force.sum();
      }
      active.push_back(worst);
    }
    ADD_FAILURE() << "no set of contacts";
    return 0.0;
  }

private:
  void addTetra(const Tetra& t, std::vector<Eigen::Triplet<double>>& entries) const
  {
    Eigen::Matrix4d places;
    for (int c = 0; c < 4; ++c)
    {
      places.row(c) << 1.0, this->vertices_[t[static_cast<std::size_t>(c)]].transpose();
    }
    const Eigen::Matrix4d shape = places.inverse(); // rows 1 to 3: gradients of the four functions
    const double volume = std::abs(places.determinant()) / 6.0;
    Eigen::Matrix<double, 6, 12> strain = Eigen::Matrix<double, 6, 12>::Zero();
    for (int c = 0; c < 4; ++c)
    {
      const double x = shape(1, c), y = shape(2, c), z = shape(3, c);
      strain.middleCols<3>(3 * c) << x, 0, 0, 0, y, 0, 0, 0, z, y, x, 0, 0, z, y, z, 0, x;
    }
    const double lame = barYoung_Pa * barPoisson / ((1 + barPoisson) * (1 - 2 * barPoisson));
    const double shear = barYoung_Pa / (2 * (1 + barPoisson));
    Eigen::Matrix<double, 6, 6> hooke = Eigen::Matrix<double, 6, 6>::Zero();
    hooke.topLeftCorner<3, 3>().setConstant(lame);
    hooke.diagonal() += (Eigen::Matrix<double, 6, 1>() << 2, 2, 2, 1, 1, 1).finished() * shear;
    const Eigen::Matrix<double, 12, 12> k = volume * strain.transpose() * hooke * strain;
    for (int i = 0; i < 12; ++i)
    {
      for (int j = 0; j < 12; ++j)
      {
        const int row = this->row_[t[static_cast<std::size_t>(i / 3)]],
                  column = this->row_[t[static_cast<std::size_t>(j / 3)]];
        if (row >= 0 && column >= 0)
        {
          entries.emplace_back(row + i % 3, column + j % 3, k(i, j));
        }
      }
    }
  }

  std::vector<Vec3> vertices_;
  std::vector<int> row_; ///< of each vertex; -1: it is fixed
  std::vector<std::size_t> lower_;
  Eigen::SparseMatrix<double> stiffness_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  Eigen::MatrixXd columns_; ///< displacements under a force of 1 N on each lower vertex
  Eigen::VectorXd free_;
};

std::vector<MechanismPress> pressesFrom(const MechanismResult& r, int body)
{
  std::vector<MechanismPress> from;
  std::copy_if(r.presses.begin(), r.presses.begin() + r.pressCount, std::back_inserter(from),
    [body](const MechanismPress& press) { return press.from == body; });
  return from;
}

double upwards_N(const std::vector<MechanismPress>& presses)
{
  double sum_N = 0.0;
  for (const MechanismPress& press : presses)
  {
    sum_N += press.force_N.z();
  }
  return sum_N;
}

class StandingMesh : public testing::TestWithParam<std::array<int, 3>>
{
};

TEST_P(StandingMesh, IsMetWhereTheGapClosesAndBearsWhatAWholeSolveSays)
{
  MechanismHold hold = firmHold(0.0); // the bar at rest in every tick
  MeshTouch touch(onBarAndBlock(makeIcosphere(3, 0.015), GetParam()), hold);
  WholeBar whole(bar(GetParam()));
  const Vec3 above(0.08, 0.02, barSize.z() + 0.015);
  bool met = false;
  double worst = 0.0, most_N = 0.0;
  for (int i = 0; i <= 120; ++i)
  {
    const MechanismResult& r = touch.to(Vec3(above - Vec3(0, 0, 5e-5 * i)));
    whole.press(pressesFrom(r, 0));
    const double borne_N = upwards_N(pressesFrom(r, 2));
    if (borne_N > 0.0 && !met)
    {
      EXPECT_NEAR(whole.leastGap_m(), 0.0, 1e-4) << i;
      met = true;
    }
    const double expected_N = whole.borne_N();
    most_N = std::max(most_N, expected_N);
    worst = std::max(worst, std::abs(borne_N - expected_N));
  }
  EXPECT_TRUE(met);
  EXPECT_GT(most_N, 0.05);
  EXPECT_LE(worst, 0.01 * most_N);
}

INSTANTIATE_TEST_SUITE_P(
  Each, StandingMesh, testing::Values(std::array<int, 3>{ 10, 4, 2 }, std::array<int, 3>{ 20, 8, 4 }));

constexpr double half_m = 0.01;
const Vec3 overBlock(0.125, 0.02, half_m - gap_m); ///< beyond the bar: the tool lies on the block

MechanismInputs boxOverBlock(double friction)
{
  return onBarAndBlock(makeBox(Vec3::Constant(-half_m), Vec3::Constant(half_m)), { 10, 4, 2 }, friction);
}

TEST(StandingMesh, StopsTheMeshInTheHandAsAStiffWallDoesAndRubsItByCoulombsLaw)
{
  constexpr double friction = 0.4;
  MeshTouch touch(boxOverBlock(friction));
  const double stiffness = firmHold().stiffness_N_per_m;
  for (int i = -50; i <= 100; ++i)
  {
    const double deep_m = 1e-5 * i;
    const MechanismResult& r = touch.to(Vec3(overBlock - Vec3(0, 0, deep_m)));
    EXPECT_NEAR(r.exact_W.force.z(), stiffness * std::max(deep_m, 0.0), 1e-6) << i;
    EXPECT_LE(r.exact_W.force.head<2>().norm(), 1e-6) << i;
  }
  const Vec3 pressed = overBlock - Vec3(0, 0, 1e-3);
  MechanismResult slid;
  for (int i = 0; i <= 1000; ++i)
  {
    slid = touch.to(Vec3(pressed + Vec3(0, 5e-6 * i, 0)));
  }
  EXPECT_NEAR(-slid.exact_W.force.y(), friction * slid.exact_W.force.z(), 1e-3 * slid.exact_W.force.z());
}

TEST(StandingMesh, LetsNoMeshThroughThatComesAtHalfAMetreASecond)
{
  MeshTouch touch(boxOverBlock(0.0));
  const Vec3 from = overBlock + Vec3(0, 0, 0.05);
  for (int i = 0; i < 300; ++i)
  {
    const Pose hand{ from - Vec3(0, 0, 5e-4 * i), Quat(Eigen::AngleAxisd(0.01 * i, Vec3(1, 2, 0.5).normalized())) };
    const Pose& at = touch.to(hand).pose_W[0];
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vec3 p =
        at * Vec3(corner & 1 ? half_m : -half_m, corner & 2 ? half_m : -half_m, corner & 4 ? half_m : -half_m);
      ASSERT_GE(p.z(), -gap_m - 1e-5) << i;
    }
  }
}

} // namespace
} // namespace palpate::test
