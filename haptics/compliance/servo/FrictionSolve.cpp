// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/compliance/servo/FrictionSteps.h"

namespace palpate
{
namespace
{

constexpr int newtonUpTo = 20;  // contacts: sweeps are cheaper from there on
constexpr int sweepsAlone = 60; // for forty contacts of any kind these leave an error below a hundred thousandth
constexpr int firstSweeps = 4;  // from the forces before, which mostly are near
constexpr int sweepsAgain = 40; // where those did not converge, and twice as many in each round that follows
constexpr int usualRounds = 6;
constexpr int leftOutUpTo = 6;     // contacts: more of them seldom nearly coincide
constexpr double rounding = 1e-14; // of the largest number in the problem

constexpr int inARowSteps = 20;  // of Newton for contacts in a row
constexpr int inARowSweeps = 20; // where those did not converge
constexpr int memory = 6;        // residuals of the last steps, up to which the next one may go
/// Of their compliance, in each round: where one share fails another helps.
constexpr std::array inARowShares{ 0.1, 0.1, 1.0, 1.0, 0.01, 0.1 };

/// Costs in units of ContactPlan::workBudget: a product with the compliance takes some n^2 / 3 of them.
std::uint32_t workOfSweep(int contacts) noexcept
{
  return 1 + static_cast<std::uint32_t>(contacts * contacts) / 3;
}
std::uint32_t workOfNewton(int contacts, int pressed) noexcept
{
  return 2 * workOfSweep(contacts) + static_cast<std::uint32_t>(pressed * pressed * pressed) / 3;
}

/// The forces with which a round begins, and its sweeps.
struct Round
{
  ContactProblem::Numbers* from = nullptr;
  int sweeps = 0;
  int without = -1;   ///< a contact that is left open
  double share = 1.0; ///< of contacts in a row
};

/// Bounds of the search in a problem.
struct Search
{
  int count = 0; ///< contacts
  std::uint32_t budget = 0;
  bool inARow = false;
  [[nodiscard]] int newtonSteps() const noexcept
  {
    constexpr int usualSteps = 20;
    return this->inARow ? inARowSteps : this->count <= newtonUpTo ? usualSteps : 0;
  }
  [[nodiscard]] int rounds() const noexcept
  {
    return this->inARow                 ? static_cast<int>(inARowShares.size())
           : this->count > newtonUpTo   ? 1
           : this->count <= leftOutUpTo ? usualRounds + this->count
                                        : usualRounds;
  }
};

/// Residuals of the last Newton steps.
class Recent
{
public:
  explicit Recent(int count) noexcept : count_(count) {}
  void take(double residual) noexcept { this->all_[this->taken_++ % this->count_] = residual; }
  [[nodiscard]] double largest() const noexcept
  {
    return *std::max_element(this->all_.begin(), this->all_.begin() + std::min(this->taken_, this->count_));
  }

private:
  std::array<double, memory> all_{};
  int count_;
  int taken_ = 0;
};

/// Sweeps, then Newton steps from there for as long as they help. Stops early when the budget is used up. The forces
/// are those of the least residual among the Newton steps.
double solveRound(
  FrictionSteps& steps, const Search& search, const Round& round, FrictionScratch& room, ContactForces& forces) noexcept
{
  steps.aimBy(round.share);
  steps.move(*round.from);
  for (int i = 0; i < round.sweeps && forces.work < search.budget; ++i)
  {
    steps.sweep(*round.from, round.without);
    forces.work += workOfSweep(search.count);
  }
  ContactProblem::Numbers& f = forces.force_N;
  f = *round.from;
  double residual = steps.residual(f), least = residual;
  room.least = f;
  Recent recent(search.inARow ? memory : 1);
  for (int i = 0; i < search.newtonSteps() && least > forces.tolerance_u && forces.work < search.budget; ++i)
  {
    recent.take(residual);
    const bool helps = steps.newton(f, residual, recent.largest());
    forces.work += workOfNewton(search.count, steps.pressed());
    forces.work += search.inARow ? static_cast<std::uint32_t>(steps.tried()) * workOfSweep(search.count) : 0;
    ++forces.steps;
    if (!helps)
    {
      break;
    }
    if (residual < least)
    {
      least = residual;
      room.least = f;
    }
  }
  f = room.least;
  steps.project(f);
  return steps.residual(f);
}

/// The first round begins with the present forces. Forces of another load are far off where contacts nearly coincide:
/// then zero is nearer. Of nearly coincident contacts mostly one is open, and Newton's steps do not find which: each
/// is left out in turn. Then sweeps alone go on.
Round nextRound(int number, int count, FrictionScratch& room, const ContactForces& forces) noexcept
{
  const int leftOut = count <= leftOutUpTo ? count : 0;
  if (number == 0)
  {
    room.swept = forces.force_N;
    return { &room.swept, count <= newtonUpTo ? firstSweeps : sweepsAlone };
  }
  if (number == 1)
  {
    room.swept.setZero();
    return { &room.swept, sweepsAgain };
  }
  if (number < 2 + leftOut)
  {
    room.start.setZero(room.swept.size());
    return { &room.start, sweepsAgain, number - 2 };
  }
  return { &room.swept, sweepsAgain << (number - 1 - leftOut) };
}

/// Contacts in a row begin with the exact normal forces under the present tangential ones, then without those; so they
/// do again with another share, and then with sweeps from the best forces.
Round nextRoundInARow(int number, const ContactProblem& problem, FrictionScratch& room, std::uint32_t& work) noexcept
{
  constexpr int fromNormal = 4;
  const double share = inARowShares[static_cast<std::size_t>(number)];
  if (number >= fromNormal)
  {
    room.swept = room.best;
    return { &room.swept, inARowSweeps, -1, share };
  }
  ContactForces& normal = room.normal;
  normal.force_N = room.start;
  if (number % 2 == 1)
  {
    normal.force_N.setZero();
  }
  closeGaps(problem, normal);
  work += normal.work;
  room.swept = normal.force_N;
  return { &room.swept, 0, -1, share };
}

} // namespace

void solveFriction(const ContactProblem& problem, FrictionScratch& room, ContactForces& forces, std::uint32_t budget,
  const FrictionSearch& how) noexcept
{
  FrictionSteps steps(problem, room, how.inARow);
  const Search search{ problem.count, budget, how.inARow };
  forces.tolerance_u = problem.count > 0 ? rounding * problem.free.lpNorm<Eigen::Infinity>() : 0.0;
  forces.tolerance_u = std::max(forces.tolerance_u, how.enough_u);
  forces.residual_u = std::numeric_limits<double>::infinity();
  forces.steps = 0;
  forces.work = 0;
  room.best = room.start = forces.force_N;
  for (int number = 0; number < search.rounds() && forces.residual_u > forces.tolerance_u; ++number)
  {
    const Round round = search.inARow ? nextRoundInARow(number, problem, room, forces.work)
                                      : nextRound(number, problem.count, room, forces);
    if (const double now = solveRound(steps, search, round, room, forces); now < forces.residual_u)
    {
      forces.residual_u = now;
      room.best = forces.force_N;
    }
  }
  forces.force_N = room.best;
}

bool answerFriction(const ContactProblem& problem, FrictionScratch& room, const ContactForces& forces,
  const Eigen::Ref<const Eigen::MatrixXd>& displaced, Eigen::Ref<Eigen::MatrixXd> answer_N) noexcept
{
  return FrictionSteps(problem, room).answer(forces.force_N, displaced, answer_N);
}

} // namespace palpate
