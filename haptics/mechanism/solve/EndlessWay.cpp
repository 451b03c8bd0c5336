// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/solve/EndlessWay.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

/// Of the load: forces that wedge a body with more are not counted on.
constexpr double strongest = 1e5;
/// By so much of it a contact is opened more than its friction asks, so that the search ends.
constexpr double beyond = 1e-3;
constexpr int mostSweeps = 40;
/// Of the guess: a displacement that is projected to less of it ends at none, or is far from the guess.
constexpr double leastLeft = 1e-2;
constexpr int perWork = 27; ///< multiply-adds to the unit of ContactPlan::workBudget

/// A displacement of the free bodies, projected until no constraint without bounds resists it.
class WaySearch
{
public:
  WaySearch(const ConstraintProblem& problem, const ConstraintProblem::Way& guess) noexcept : p_(problem), way_(guess)
  {
    this->aside_.setZero(problem.ways, problem.count);
  }

  [[nodiscard]] bool run() noexcept
  {
    const double size = this->way_.norm();
    if (!(size > 0.0) || !std::isfinite(size))
    {
      return false;
    }
    this->way_ /= size;
    bool found = this->isCertificate();
    for (; !found && this->sweeps_<mostSweeps&& this->way_.norm()> leastLeft; ++this->sweeps_)
    {
      this->sweep();
      found = this->isCertificate();
    }
    return found;
  }

  [[nodiscard]] int sweeps() const noexcept { return this->sweeps_; }

private:
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, ConstraintProblem::mostWays>;

  [[nodiscard]] double alongOf(int row) const noexcept { return this->p_.along.row(row).dot(this->way_); }

  [[nodiscard]] double frictionOf(int cone) const noexcept { return this->p_.friction[static_cast<std::size_t>(cone)]; }

  /// Each resisted row in turn: its last correction of the displacement is taken back, then comes the nearest
  /// displacement that the row does not resist (Dykstra's projections, which end at the one that is nearest to the
  /// first).
  void sweep() noexcept
  {
    for (int i = 0; i < this->p_.bounded(); ++i)
    {
      this->way_ -= this->aside_.col(i);
      const double goes = this->alongOf(i);
      const bool resists = goes < 0.0 ? std::isinf(this->p_.highest[i]) : std::isinf(this->p_.lowest[i]);
      const Row row = this->p_.along.row(i);
      this->leadAside(i, row, resists ? goes : 0.0);
    }
    for (int c = 0; c < this->p_.cones; ++c)
    {
      this->openCone(this->p_.bounded() + 3 * c, (1.0 + beyond) * this->frictionOf(c));
    }
  }

  void openCone(int first, double friction) noexcept
  {
    this->way_ -= this->aside_.col(first);
    const double x = this->alongOf(first + 1), y = this->alongOf(first + 2);
    const double across = std::sqrt(x * x + y * y);
    Row row = this->p_.along.row(first);
    if (across > 0.0)
    {
      row -= friction / across * (x * this->p_.along.row(first + 1) + y * this->p_.along.row(first + 2));
    }
    this->leadAside(first, row, std::min(0.0, this->alongOf(first) - friction * across));
  }

  void leadAside(int i, const Row& row, double goes) noexcept
  {
    const double square = row.squaredNorm();
    this->aside_.col(i) = (square > 0.0 ? -goes / square : 0.0) * row.transpose();
    this->way_ += this->aside_.col(i);
  }

  /// Work of the load against the most that forces take up.
  [[nodiscard]] bool isCertificate() const noexcept
  {
    const double drives = this->p_.load.dot(this->way_);
    if (!(drives > 0.0))
    {
      return false;
    }
    const double most_N = strongest * this->p_.load.norm();
    double resists = most_N * this->p_.yield_u_per_N * this->p_.turns.lazyProduct(this->way_).eval().norm();
    for (int i = 0; i < this->p_.bounded(); ++i)
    {
      const double goes = this->alongOf(i);
      const double bound = goes < 0.0 ? this->p_.highest[i] : -this->p_.lowest[i];
      resists += std::abs(goes) * std::min(bound, most_N);
    }
    for (int c = 0; c < this->p_.cones; ++c)
    {
      const int first = this->p_.bounded() + 3 * c;
      const double x = this->alongOf(first + 1), y = this->alongOf(first + 2);
      resists += most_N * std::max(0.0, this->frictionOf(c) * std::sqrt(x * x + y * y) - this->alongOf(first));
    }
    return drives > (1.0 + 1e-9) * resists;
  }

  const ConstraintProblem& p_;
  ConstraintProblem::Way way_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, ConstraintProblem::mostWays, ConstraintProblem::most>
    aside_; ///< by row
  int sweeps_ = 0;
};

} // namespace

bool isEndless(const ConstraintProblem& problem, const ConstraintProblem::Way& guess, std::uint32_t& work) noexcept
{
  if (problem.load.isZero(0.0)) // without a load the bodies rest where they are
  {
    return false;
  }
  WaySearch search(problem, guess);
  const bool endless = search.run();
  work += 1 + static_cast<std::uint32_t>((1 + search.sweeps()) * 5 * problem.count * problem.ways / perWork);
  return endless;
}

} // namespace palpate
