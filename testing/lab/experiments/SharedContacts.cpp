// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 38 and 42: contacts that share compliance: the residual of a solver, and its cost in a tick.
#include <algorithm>
#include <memory>

#include "testing/lab/Experiments.h"
#include "testing/support/CostSample.h"
#include "testing/support/RandomContacts.h"

namespace palpate::lab
{
namespace shared_contacts_experiment
{

/// Two contacts 1 mm deep with [[1, .6], [.6, 1]] mm/N: .625 N each; each by itself 1 N.
void judgeTwo(Table& table)
{
  const auto problem = std::make_unique<ContactProblem>();
  const auto force = [&problem](double shared)
  {
    problem->resize(2);
    problem->compliance.setZero();
    problem->free.setZero();
    problem->compliance(0, 0) = problem->compliance(3, 3) = 1.0;
    problem->compliance(0, 3) = problem->compliance(3, 0) = shared;
    problem->free[0] = problem->free[3] = -1.0;
    ContactForces forces;
    solveGaps(*problem, forces);
    return forces.force_N[0];
  };
  table.within({ "two spots", "shared compliance", "force", "N" }, force(0.6), 0.625, 1e-9);
  table.atLeast({ "two spots", "each by itself", "too much force by" }, force(0.0) / 0.625 - 1.0, 0.5);
}

} // namespace shared_contacts_experiment

void runContacts(const Conditions& conditions, Table& table)
{
  using namespace shared_contacts_experiment;
  judgeTwo(table);
  const auto problem = std::make_unique<ContactProblem>();
  const auto room = std::make_unique<FrictionScratch>();
  test::Random random(conditions.seed);
  for (const int n : { 1, 2, 3, 5, 10, 20, 28, 40 })
  {
    const int trials = conditions.pick(20, 60, 1000);
    test::CostSample cost(static_cast<std::size_t>(trials));
    double open = 0.0;
    for (int trial = 0; trial < trials; ++trial)
    {
      test::makeRandomContacts(random, n, *problem);
      ContactForces forces;
      forces.force_N.setZero(3 * n);
      cost.time([&] { solveFriction(*problem, *room, forces); });
      open = std::max(open, forces.residual_u);
    }
    const std::string name = caseName({ { "contacts", static_cast<double>(n) } });
    table.atMost({ name, "Gauss-Seidel, then Newton", "laws missed by, over the depth" }, open, n <= 10 ? 1e-12 : 1e-5)
      .cost = Cost::of(cost);
  }
}

} // namespace palpate::lab
