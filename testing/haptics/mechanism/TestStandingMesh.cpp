// SPDX-License-Identifier: GPL-3.0-or-later
// A soft bar is pressed onto a mesh that stands behind it: when it meets that mesh, and how much of the hand's force
// the mesh bears, against a finite element solve with all contacts at once that is written apart.
#include <cmath>

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "HeldMesh.h"
#include "haptics/core/PoseMath.h"

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

  /// Under these forces at these places of its surface, whose vertices are numbered by the surface.
  void press(std::span<const MechanismPress> presses, const std::vector<Vec3>& surface_W)
  {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(this->stiffness_.rows());
    for (const MechanismPress& press : presses)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        const int row = this->row_[this->nearest(surface_W[press.at.vertices[c]])];
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
  [[nodiscard]] std::size_t nearest(const Vec3& p) const
  {
    const auto away = [&p](const Vec3& v) { return (v - p).squaredNorm(); };
    return static_cast<std::size_t>(std::ranges::min_element(this->vertices_, {}, away) - this->vertices_.begin());
  }

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

/// Cells of the bar, and rate of its snapshots [Hz]; 0: at rest in each tick.
struct BarCase
{
  std::array<int, 3> cells{};
  double rate_Hz = 0.0;
};

class StandingMesh : public testing::TestWithParam<BarCase>
{
};

TEST_P(StandingMesh, IsMetWhereTheGapClosesAndBearsWhatAWholeSolveSays)
{
  constexpr double step_m = 5e-5, stepOfEnd_m = 1.3 * step_m; // the free end goes further than the hand
  const auto [cells, rate_Hz] = GetParam();
  MeshTouch touch(onBarAndBlock(makeIcosphere(3, 0.015), cells), firmHold(rate_Hz));
  WholeBar whole(bar(cells));
  const Vec3 above(0.08, 0.02, barSize.z() + 0.015);
  bool met = false;
  double before_m = gap_m, worst_N = 0.0, most_N = 0.0;
  for (int i = 0; i <= 90; ++i)
  {
    const MechanismResult& r = touch.to(Vec3(above - Vec3(0, 0, step_m * i)), 1e-3, rate_Hz > 0.0 ? 100 : 1);
    whole.press(pressesFrom(r, 0), touch.body().snapshot->free_W);
    const double borne_N = upwards_N(pressesFrom(r, 2)), expected_N = whole.borne_N();
    if (borne_N > 0.0 && !met)
    {
      EXPECT_GE(before_m, 0.0);
      EXPECT_LE(before_m, stepOfEnd_m);
      met = true;
    }
    before_m = whole.leastGap_m();
    most_N = std::max(most_N, expected_N);
    worst_N = std::max(worst_N, std::abs(borne_N - expected_N));
  }
  // A contact's force is spread over a patch here and acts on a vertex there.
  const double edges = barSize.x() / cells[0] / 0.005;
  EXPECT_TRUE(met);
  EXPECT_GT(most_N, 3.0);
  EXPECT_LE(worst_N, 0.02 * edges * most_N);
}

INSTANTIATE_TEST_SUITE_P(Each, StandingMesh,
  testing::Values(BarCase{ { 10, 4, 2 }, 0.0 }, BarCase{ { 20, 8, 4 }, 0.0 }, BarCase{ { 20, 8, 4 }, 30.0 }));

TEST(StandingMesh, IsMetByABarThatARodPressesAtANamedContact)
{
  MechanismInputs inputs = onBarAndBlock(makeIcosphere(1, 0.01), { 20, 8, 4 });
  constexpr double length_m = 0.05;
  const Vec3 pressed(0.08, 0.02, barSize.z());
  MechanismBody& rod = inputs.mechanism.bodies.front();
  rod.mesh.reset();
  rod.length_u = length_m;
  rod.diameter_u = 0.004;
  rod.pose_W.q = Quat(0.0, 1.0, 0.0, 0.0); // it points down
  MechanismConstraint contact;
  contact.name = "tip";
  contact.kind = ConstraintKind::Contact;
  contact.a = rod.name;
  contact.b = "bar";
  contact.point_A = Vec3(0, 0, length_m);
  contact.point_B = pressed;
  inputs.mechanism.laws = { contact };
  MeshTouch touch(inputs);
  WholeBar whole(bar({ 20, 8, 4 }));
  double worst_N = 0.0, most_N = 0.0;
  for (int i = 0; i <= 80; ++i)
  {
    const MechanismResult& r = touch.to(Vec3(pressed + Vec3(0, 0, length_m - 5e-5 * i)), 1e-3, 100);
    whole.press(pressesFrom(r, 0), touch.body().snapshot->free_W);
    const double borne_N = upwards_N(pressesFrom(r, 2)), expected_N = whole.borne_N();
    most_N = std::max(most_N, expected_N);
    worst_N = std::max(worst_N, std::abs(borne_N - expected_N));
    EXPECT_FALSE(r.ahead) << i;
  }
  EXPECT_GT(most_N, 0.5);
  EXPECT_LE(worst_N, 0.02 * most_N); // as on this mesh under a ball
}

constexpr double half_m = 0.01;
const Vec3 overBlock(0.125, 0.02, half_m - gap_m); ///< beyond the bar: the tool lies on the block

MechanismInputs boxOverBlock(double friction)
{
  return onBarAndBlock(makeBox(Vec3::Constant(-half_m), Vec3::Constant(half_m)), { 10, 4, 2 }, friction);
}

TEST(StandingMesh, StopsTheMeshInTheHandAsAStiffWallDoes)
{
  MeshTouch touch(boxOverBlock(0.0));
  for (int i = -50; i <= 100; ++i)
  {
    const double deep_m = 1e-5 * i;
    const MechanismResult& r = touch.to(Vec3(overBlock - Vec3(0, 0, deep_m)));
    EXPECT_NEAR(r.exact_W.force.z(), firmHold().stiffness_N_per_m * std::max(deep_m, 0.0), 1e-6) << i;
    EXPECT_LE(r.exact_W.force.head<2>().norm(), 1e-6) << i;
  }
}

TEST(StandingMesh, RubsTheMeshInTheHandByCoulombsLaw)
{
  constexpr double friction = 0.4;
  MeshTouch touch(boxOverBlock(friction));
  const Vec3 pressed = overBlock - Vec3(0, 0, 1e-3);
  MechanismResult slid;
  for (int i = 0; i <= 1000; ++i)
  {
    slid = touch.to(Vec3(pressed + Vec3(0, 5e-6 * i, 0)));
  }
  EXPECT_GT(slid.exact_W.force.z(), 5.0);
  EXPECT_NEAR(-slid.exact_W.force.y(), friction * slid.exact_W.force.z(), 1e-3 * slid.exact_W.force.z());
}

/// How deep a box gets into the block that comes at half a metre a second, turned and turning [m].
double deepest_m(double turns_rad_per_s)
{
  MeshTouch touch(boxOverBlock(0.0));
  const Vec3 from = overBlock + Vec3(0, 0, 0.05), axis = Vec3(1, 2, 0.5).normalized();
  double deepest_m = 0.0;
  for (int i = 0; i < 250; ++i)
  {
    const int ahead =
      std::min(i, 110); // the hand stops 5 mm below: with more, the spring turns the box about its corner
    const Quat turn(Eigen::AngleAxisd(0.4 + 1e-3 * turns_rad_per_s * ahead, axis));
    const Pose& at = touch.to(Pose{ from - Vec3(0, 0, 5e-4 * ahead), turn }).pose_W[0];
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vec3 out((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0, (corner & 4) != 0 ? 1.0 : -1.0);
      deepest_m = std::max(deepest_m, -gap_m - (at * Vec3(half_m * out)).z());
    }
  }
  return deepest_m;
}

TEST(StandingMesh, LetsNoMeshThroughThatComesAtHalfAMetreASecond)
{
  EXPECT_LE(deepest_m(0.0), 1e-6);
  // A corner that faces the block only once it has turned is found by the next answer, two periods later at most.
  const double corner_m = std::sqrt(3.0) * half_m, turned_rad = 10.0 * 2.0 / 30.0;
  EXPECT_LE(deepest_m(10.0), corner_m * (1.0 - std::cos(turned_rad)));
}

} // namespace
} // namespace palpate::test
