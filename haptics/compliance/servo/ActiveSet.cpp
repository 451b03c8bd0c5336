// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/compliance/servo/BoundedRows.h"
#include "haptics/compliance/servo/ContactProblem.h"

namespace palpate
{
namespace
{

/// The normal rows of contacts alone: contacts do not pull.
struct NormalRows
{
  static constexpr int most = ContactProblem::most;

  const ContactProblem& problem;
  std::array<double, most> free_u{}; ///< gaps without normal forces

  [[nodiscard]] int count() const noexcept { return this->problem.count; }
  [[nodiscard]] double compliance(int i, int j) const noexcept { return this->problem.compliance(3 * i, 3 * j); }
  [[nodiscard]] double free(int i) const noexcept { return this->free_u[i]; }
  [[nodiscard]] static double lowest(int /*i*/) noexcept { return 0.0; }
  [[nodiscard]] static double highest(int /*i*/) noexcept { return std::numeric_limits<double>::infinity(); }
};

} // namespace

void ContactProblem::resize(int contacts) noexcept
{
  this->count = contacts;
  this->compliance.resize(3 * contacts, 3 * contacts);
  this->free.resize(3 * contacts);
}

void solveGaps(const ContactProblem& problem, ContactForces& forces) noexcept
{
  forces.force_N.setZero(3 * problem.count);
  closeGaps(problem, forces);
}

void closeGaps(const ContactProblem& problem, ContactForces& forces) noexcept
{
  NormalRows rows{ problem };
  for (int i = 0; i < problem.count; ++i)
  {
    rows.free_u[i] = problem.free[3 * i];
    for (int j = 0; j < problem.count; ++j)
    {
      rows.free_u[i] += problem.compliance.block<1, 2>(3 * i, 3 * j + 1) * forces.force_N.segment<2>(3 * j + 1);
    }
  }
  BoundedRows<NormalRows> set(rows);
  forces.steps = 0;
  // The stored energy grows with each contact that closes: only rounding could cause a cycle.
  const int cap = 20 + 4 * problem.count;
  for (int i = set.worst(); i >= 0 && forces.steps < cap; i = set.worst())
  {
    forces.steps += set.close(i);
  }
  forces.work = static_cast<std::uint32_t>(forces.steps * (1 + problem.count * problem.count / 3));
  forces.residual_u = 0.0;
  forces.tolerance_u = 1e-14 * (problem.count > 0 ? problem.free.lpNorm<Eigen::Infinity>() : 0.0);
  for (int i = 0; i < problem.count; ++i)
  {
    forces.force_N[3 * i] = set.force(i);
    const double gap = set.gap(i);
    forces.residual_u = std::max(forces.residual_u, set.force(i) > 0.0 ? std::abs(gap) : -gap);
  }
}

} // namespace palpate
