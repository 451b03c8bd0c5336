// SPDX-License-Identifier: GPL-3.0-or-later
// Chart C2: the nearest point in front of 1 to 20 planes by four solvers, against exact rational arithmetic.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/QR>

#include "haptics/contact/planes/Projection.h"
#include "testing/lab/Experiments.h"
#include "testing/support/QpOracle.h"
#include "testing/support/Random.h"

namespace palpate::lab
{
namespace solver_experiment
{

using Rows = std::vector<PlaneRow>;

/// argmin |y - q| subject to n_i . y >= bound_i, and the exact answer.
struct Problem
{
  Rows rows;
  Vec3 q;
  Vec3 truth;
};

/// A pit: planes that look upwards, a free point at the origin, the target below.
Problem randomPit(int planes, test::Random& random)
{
  Problem problem;
  for (int i = 0; i < planes; ++i)
  {
    Vec3 n = random.direction();
    n.z() = std::abs(n.z()) + 0.1;
    problem.rows.push_back({ n.normalized(), -random.uniform(0.0, 0.2) });
  }
  problem.q = Vec3(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), -3.0);
  problem.truth = test::projectExactly(problem.rows, problem.q).y;
  return problem;
}

double violation(const PlaneRow& row, const Vec3& y)
{
  return row.bound - row.n.dot(y);
}

Vec3 ontoPlane(const PlaneRow& row, const Vec3& y)
{
  return y + std::max(0.0, violation(row, y)) * row.n;
}

Vec3 byEnumeration(const Rows& rows, const Vec3& q)
{
  return projectOntoPlanes(rows, q, 0.0).y;
}

/// min |E u - f| subject to u >= 0 (Lawson & Hanson 1974, chapter 23), with E of four rows.
class NonNegativeLeastSquares
{
public:
  NonNegativeLeastSquares(Eigen::Matrix4Xd e, const Eigen::Vector4d& f)
    : e_(std::move(e)), f_(f), u_(Eigen::VectorXd::Zero(this->e_.cols()))
  {
  }

  /// f - E u of the solution.
  [[nodiscard]] Eigen::Vector4d residual()
  {
    constexpr double noDescent = 1e-14;
    for (int round = 0; round < 3 * this->e_.cols(); ++round)
    {
      const Eigen::VectorXd gradient = this->e_.transpose() * (this->f_ - this->e_ * this->u_);
      const int entering = this->steepestOutside(gradient);
      if (entering < 0 || gradient[entering] <= noDescent)
      {
        break;
      }
      this->passive_.push_back(entering);
      this->solvePassive();
    }
    return this->f_ - this->e_ * this->u_;
  }

private:
  [[nodiscard]] int steepestOutside(const Eigen::VectorXd& gradient) const
  {
    int steepest = -1;
    for (int i = 0; i < gradient.size(); ++i)
    {
      const bool outside = std::find(this->passive_.begin(), this->passive_.end(), i) == this->passive_.end();
      if (outside && (steepest < 0 || gradient[i] > gradient[steepest]))
      {
        steepest = i;
      }
    }
    return steepest;
  }

  /// Least squares on the passive columns; where one would become negative, it leaves on the way there.
  void solvePassive()
  {
    while (!this->passive_.empty())
    {
      Eigen::MatrixXd columns(this->e_.rows(), static_cast<Eigen::Index>(this->passive_.size()));
      for (Eigen::Index k = 0; k < columns.cols(); ++k)
      {
        columns.col(k) = this->e_.col(this->passive_[static_cast<std::size_t>(k)]);
      }
      const Eigen::VectorXd s = columns.colPivHouseholderQr().solve(this->f_);
      double step = 1.0;
      for (int k = 0; k < s.size(); ++k)
      {
        const double u = this->u_[this->passive_[static_cast<std::size_t>(k)]];
        step = s[k] <= 0.0 ? std::min(step, u / (u - s[k])) : step;
      }
      const Eigen::VectorXd before = this->u_(this->passive_);
      this->u_(this->passive_) = before + step * (s - before);
      if (step == 1.0)
      {
        return;
      }
      this->dropEmptied();
    }
  }

  void dropEmptied()
  {
    std::erase_if(this->passive_,
      [this](int i)
      {
        const bool emptied = this->u_[i] <= 1e-15;
        this->u_[i] = emptied ? 0.0 : this->u_[i];
        return emptied;
      });
  }

  Eigen::Matrix4Xd e_;
  Eigen::Vector4d f_;
  Eigen::VectorXd u_;
  std::vector<int> passive_;
};

/// Least distance by non-negative least squares: min |N^T u| with h^T u nearest to 1 gives y = q - r / r_4.
Vec3 byNnls(const Rows& rows, const Vec3& q)
{
  Eigen::Matrix4Xd e(4, static_cast<Eigen::Index>(rows.size()));
  for (Eigen::Index i = 0; i < e.cols(); ++i)
  {
    const PlaneRow& row = rows[static_cast<std::size_t>(i)];
    e.col(i) << row.n, violation(row, q);
  }
  const Eigen::Vector4d r = NonNegativeLeastSquares(std::move(e), Eigen::Vector4d::UnitW()).residual();
  return q - r.head<3>() / r[3];
}

/// The knowledge of a tick that meets one new plane a tick: the deepest.
Vec3 byOnePerTick(const Rows& rows, const Vec3& q)
{
  const auto deepest = std::max_element(
    rows.begin(), rows.end(), [&q](const PlaneRow& a, const PlaneRow& b) { return violation(a, q) < violation(b, q); });
  return ontoPlane(*deepest, q);
}

/// Onto one plane after the other, 16 steps as in a textbook's tick, or once round where there are more planes.
Vec3 byAlternating(const Rows& rows, const Vec3& q)
{
  Vec3 y = q;
  for (std::size_t step = 0; step < std::max<std::size_t>(16, rows.size()); ++step)
  {
    y = ontoPlane(rows[step % rows.size()], y);
  }
  return y;
}

struct Method
{
  const char* name;
  Vec3 (*solve)(const Rows& rows, const Vec3& q);
  double exactTo; ///< where a method solves the problem at all: relative error
  bool oneOnly;   ///< right only as long as a single plane pushes
};

constexpr std::array<Method, 4> solvers{ {
  { "enumeration", byEnumeration, 1e-12, false },
  { "nnls", byNnls, 1e-12, false },
  { "one-per-tick", byOnePerTick, 1e-12, true },
  { "alternating", byAlternating, 1e-12, true },
} };

void compare(const Method& method, const std::vector<Problem>& problems, Table& table)
{
  const std::size_t planes = problems.front().rows.size();
  const Subject subject{ caseName({ { "planes", static_cast<double>(planes) } }), method.name, "error", "" };
  test::CostSample sample(problems.size());
  double worst = 0.0;
  for (const Problem& problem : problems)
  {
    Vec3 y;
    sample.time([&] { y = method.solve(problem.rows, problem.q); });
    worst = std::max(worst, (y - problem.truth).norm() / (problem.truth - problem.q).norm());
  }
  // A hundredth of the force: a twentieth of that many pits have a second plane that pushes as hard as that.
  Row& row =
    method.oneOnly && planes > 1 ? table.atLeast(subject, worst, 0.01) : table.atMost(subject, worst, method.exactTo);
  row.cost = Cost::of(sample);
}

} // namespace solver_experiment

void runSolver(const Conditions& conditions, Table& table)
{
  using namespace solver_experiment;
  const int count = conditions.pick(12, 120, 2000);
  test::Random random(conditions.seed);
  constexpr int most = 20;
  for (int planes = 1; planes <= most; ++planes)
  {
    std::vector<Problem> problems;
    for (int i = 0; i < count; ++i)
    {
      problems.push_back(randomPit(planes, random));
    }
    for (const Method& method : solvers)
    {
      compare(method, problems, table);
    }
    conditions.progress(static_cast<double>(planes) / most);
  }
}

} // namespace palpate::lab
