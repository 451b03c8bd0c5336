// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "haptics/compliance/servo/DenseSolve.h"
#include "haptics/mechanism/solve/BoundedConstraints.h"
#include "haptics/mechanism/solve/ConstraintProblem.h"
#include "haptics/mechanism/solve/EndlessWay.h"

namespace palpate
{
namespace
{

/// Share of a row's own size, of a force and of a balance, that is rounding.
constexpr double rounding = 1e-13;
/// A residual of the friction solver beyond this many times its rounding is not met.
constexpr double metWithin = 1e4;

/// Damping of the steps towards balance, as a share of the stiffness of a body with the scale of the compliances.
constexpr double dampedFirst = 1e-2;
constexpr double dampedLess = 0.3;  ///< by every step at least, so that nothing is crept towards
constexpr double dampedMore = 10.0; ///< where a step has led further away
constexpr double dampedMost = 0.1;  ///< then it is gone on from all the same
constexpr double turnedMost = 0.5;  ///< share of the balance that a step follows by which it may turn round
constexpr double dampedLeast = 1e-12;
/// Share of a force that nobody feels; and share of the balance that a step leaves where it gains nothing.
constexpr double unfelt = 1e-7, gainsNothing = 0.5;
/// From the end of the problem before it is one step or two to balance: with more, the frictional contacts have
/// changed.
constexpr int mostStepsOn = 4;
constexpr int mostSteps = 1 << 20; ///< the budget ends it before
/// From that step on it is asked whether there is a place of rest, ever more seldom.
constexpr int firstAsked = 3, askedAgain = 2;

/// Multiply-adds to the unit of ContactPlan::workBudget.
constexpr int multiplyAddsPerWork = 27;

std::uint32_t workOf(int multiplyAdds) noexcept
{
  return 1 + static_cast<std::uint32_t>(multiplyAdds / multiplyAddsPerWork);
}

/// The iteration between rows, cones and degrees of freedom.
class ConstraintSolve
{
public:
  ConstraintSolve(
    const ConstraintProblem& problem, ConstraintScratch& room, ConstraintForces& forces, std::uint32_t budget) noexcept
    : p_(problem), room_(room), f_(forces), budget_(budget), rows_{ problem, room }
  {
  }

  void run(ConstraintStart start) noexcept
  {
    this->prepare();
    if (start == ConstraintStart::Before && this->f_.way_u.size() == this->p_.ways && this->f_.damping > 0.0)
    {
      this->damped_ = this->f_.damping;
      if (this->findBalance(mostStepsOn))
      {
        return this->finish(!this->conesAreMet());
      }
    }
    this->f_.way_u.setZero(this->p_.ways);
    this->damped_ = dampedFirst;
    if (this->findBalance(mostSteps))
    {
      return this->finish(!this->conesAreMet());
    }
    this->yield();
    this->finish(true);
  }

private:
  [[nodiscard]] bool findBalance(int most) noexcept
  {
    std::optional<ActiveConstraints> held;
    this->askedAt_ = firstAsked;
    for (this->steps_ = 0; this->solveAt(held);)
    {
      const ConstraintProblem::Way open = this->balance();
      if (this->isWithin(rounding, open) || this->rests(open))
      {
        return true;
      }
      if (this->steps_ == most || this->f_.work >= this->budget_)
      {
        return false;
      }
      this->stepWays(*held, open);
      if (most == mostSteps && this->findsNoRest())
      {
        return false;
      }
    }
    return false;
  }

  /// Rows and cones where the bodies are now; false if they could not be ended.
  [[nodiscard]] bool solveAt(std::optional<ActiveConstraints>& held) noexcept
  {
    held.emplace(this->rows_);
    if (!this->solveRows(*held))
    {
      return false;
    }
    for (bool met = this->p_.cones == 0 || this->solveCones(*held); !met;)
    {
      if (this->f_.work >= this->budget_)
      {
        return false;
      }
      const ActiveConstraints::Bounds before = held->bounds();
      held.emplace(this->rows_);
      if (!this->solveRows(*held))
      {
        return false;
      }
      // With the same active set as before the cones get the response that they were solved with.
      met = (held->isHeldAs(before) && this->conesAreMet()) || this->solveCones(*held);
    }
    return true;
  }

  void prepare() noexcept
  {
    // In balance this adds nothing: the term only keeps displacements that no row resists finite.
    this->room_.stiffened = this->p_.compliance;
    if (this->p_.ways > 0)
    {
      this->room_.stiffened += this->p_.yield_u_per_N * this->p_.along.lazyProduct(this->p_.along.transpose());
    }
    this->f_.force_N.conservativeResizeLike(ConstraintProblem::Numbers::Zero(this->p_.count));
    this->f_.force_N.head(this->p_.bounded()).setZero();
    this->f_.work = 0;
  }

  void spend(int multiplyAdds) noexcept { this->f_.work += workOf(multiplyAdds); }

  /// Bounded rows under the present cones and displacements; false if they could not be ended.
  [[nodiscard]] bool solveRows(ActiveConstraints& held) noexcept
  {
    const int n = this->p_.count;
    const int cones = 3 * this->p_.cones;
    ConstraintProblem::Way way = this->f_.way_u + this->p_.yield_u_per_N * this->p_.load;
    way -= this->p_.yield_u_per_N * this->p_.turns.lazyProduct(this->f_.way_u);
    this->room_.pressed = this->p_.free;
    this->room_.pressed += this->p_.along.lazyProduct(way);
    this->room_.pressed += this->room_.stiffened.rightCols(cones).lazyProduct(this->f_.force_N.tail(cones));
    held.holdUnbounded();
    this->spend(n * n * (n + this->p_.ways) / 4);
    int i = held.worst();
    for (int left = 20 + 6 * n; i >= 0 && left > 0 && this->f_.work < this->budget_; i = held.worst())
    {
      const int steps = held.close(i);
      left -= steps;
      this->spend(steps * 4 * n * n);
    }
    for (int k = 0; k < this->p_.bounded(); ++k)
    {
      this->f_.force_N[k] = held.force(k);
    }
    return i < 0;
  }

  [[nodiscard]] ConstraintProblem::Way balance() const noexcept
  {
    ConstraintProblem::Way sum = this->p_.load;
    sum += this->p_.along.transpose().lazyProduct(this->f_.force_N);
    sum -= this->p_.turns.lazyProduct(this->f_.way_u);
    return sum;
  }

  /// Where everything hangs loose forces fade without end: below a newton's rounding they are none.
  [[nodiscard]] bool isWithin(double share, const ConstraintProblem::Way& open) const noexcept
  {
    const double most = this->p_.count > 0 ? this->f_.force_N.lpNorm<Eigen::Infinity>() : 0.0;
    return this->p_.ways == 0 ||
           open.lpNorm<Eigen::Infinity>() <= share * (1.0 + most + this->p_.load.lpNorm<Eigen::Infinity>());
  }

  /// Nothing resists the turn of a ball about the normal of its one contact: steps against the drag would go on without
  /// end for a force that nobody feels.
  [[nodiscard]] bool rests(const ConstraintProblem::Way& open) const noexcept
  {
    return this->steps_ > 0 && open.norm() > gainsNothing * this->off_N_ && this->isWithin(unfelt, open);
  }

  [[nodiscard]] bool conesAreMet() const noexcept
  {
    const ContactForces& found = this->room_.contactForces;
    return this->p_.cones == 0 || found.residual_u <= metWithin * found.tolerance_u;
  }

  /// Newton's step on the balance, damped as by a drag that fades (pseudo-transient continuation). One that has led
  /// further away is taken again with more drag, until that is much.
  void stepWays(const ActiveConstraints& held, const ConstraintProblem::Way& open) noexcept
  {
    const double off_N = open.norm();
    if (this->steps_ == 0)
    {
      this->firstForce_N_ = this->f_.force_N;
      this->length_u_ = 0.0;
    }
    else if (this->wasTooFar(open))
    {
      this->f_.way_u -= this->step_u_;
      this->damped_ *= dampedMore;
      return this->goAlong();
    }
    else
    {
      const double less = off_N / this->off_N_;
      this->damped_ = std::max(this->damped_ * std::min(dampedLess, less * less), dampedLeast);
    }
    this->open_N_ = open;
    this->off_N_ = off_N;
    this->resistWays(held);
    this->goAlong();
  }

  /// Asked seldom, and where steps get longer: a body that comes to rest goes ever shorter ones.
  [[nodiscard]] bool findsNoRest() noexcept
  {
    const double before_u = std::exchange(this->length_u_, this->step_u_.norm());
    if (this->steps_ < this->askedAt_ || this->length_u_ <= before_u)
    {
      return false;
    }
    this->askedAt_ *= askedAgain;
    return isEndless(this->p_, this->step_u_, this->f_.work);
  }

  /// Past a place of rest, where slip is reversed, balance may be as far off as before.
  [[nodiscard]] bool wasTooFar(const ConstraintProblem::Way& open) const noexcept
  {
    const bool turnedRound = open.dot(this->step_u_) < -turnedMost * this->open_N_.dot(this->step_u_);
    return turnedRound || (open.norm() > this->off_N_ && this->damped_ < dampedMost);
  }

  void goAlong() noexcept
  {
    const double drag_N_per_u = this->damped_ / this->p_.yield_u_per_N;
    this->room_.friction.jacobian = this->room_.resists;
    this->room_.friction.jacobian.diagonal().array() += drag_N_per_u;
    this->room_.friction.part = this->open_N_;
    this->spend(this->p_.ways * this->p_.ways * this->p_.ways / 3);
    const bool regular = solveInPlace(this->room_.friction.jacobian, this->room_.friction.part);
    this->step_u_ = regular ? ConstraintProblem::Way(this->room_.friction.part)
                            : ConstraintProblem::Way(this->open_N_ / drag_N_per_u);
    this->f_.way_u += this->step_u_;
    ++this->steps_;
  }

  /// Resistance of the constraints in each degree of freedom: the active rows, then the cones with the compliance that
  /// these leave.
  void resistWays(const ActiveConstraints& held) noexcept
  {
    const auto rows = held.held();
    const int n = static_cast<int>(rows.size());
    const int ways = this->p_.ways;
    this->room_.resists.setZero(ways, ways);
    std::array<double, ConstraintProblem::most> x;
    for (int w = 0; w < ways; ++w)
    {
      for (int k = 0; k < n; ++k)
      {
        x[k] = this->p_.along(rows[k], w);
      }
      held.solveHeld(x);
      for (int k = 0; k < n; ++k)
      {
        this->room_.resists.col(w) += x[k] * this->p_.along.row(rows[k]).transpose();
      }
    }
    if (this->p_.cones > 0)
    {
      this->resistByCones();
    }
    // The effect of turns on forces goes through the yield as every other force does.
    this->room_.held = this->p_.turns;
    this->room_.held -= this->p_.yield_u_per_N * this->room_.resists.lazyProduct(this->p_.turns);
    this->room_.resists += this->room_.held;
    this->spend(ways * (n * (n + ways) + ways * ways));
  }

  void resistByCones() noexcept
  {
    const int cones = 3 * this->p_.cones;
    ConstraintProblem::Ways& displaced = this->room_.displaced;
    displaced.resize(cones, this->p_.ways);
    this->room_.answer.resize(cones, this->p_.ways);
    for (int i = 0; i < cones; ++i)
    {
      displaced.row(i) = this->unit(i) * this->room_.conesWays.row(i);
    }
    (void)answerFriction(
      this->room_.contacts, this->room_.friction, this->room_.contactForces, displaced, this->room_.answer);
    for (int w = 0; w < this->p_.ways; ++w)
    {
      for (int i = 0; i < cones; ++i)
      {
        this->room_.resists.col(w) -=
          this->unit(i) * this->room_.answer(i, w) * this->room_.conesWays.row(i).transpose();
      }
    }
    this->spend(cones * cones * (cones / 3 + 2) + 2 * cones * this->p_.ways * (cones + this->p_.ways));
  }

  /// How the cones' rows move under forces on themselves and with the degrees of freedom, all other constraints kept as
  /// they are.
  void reduceToCones(const ActiveConstraints& held) noexcept
  {
    const auto rows = held.held();
    const int n = static_cast<int>(rows.size());
    const int first = this->p_.bounded();
    const int cones = this->p_.count - first;
    this->room_.conesAnswer = this->room_.stiffened.bottomRightCorner(cones, cones);
    this->room_.conesWays = this->p_.along.bottomRows(cones);
    std::array<double, ConstraintProblem::most> x;
    for (int c = 0; c < cones; ++c)
    {
      for (int k = 0; k < n; ++k)
      {
        x[k] = this->room_.stiffened(rows[k], first + c);
      }
      held.solveHeld(x);
      for (int k = 0; k < n; ++k)
      {
        this->room_.conesAnswer.col(c) -= x[k] * this->room_.stiffened.col(rows[k]).tail(cones);
        this->room_.conesWays.row(c) -= x[k] * this->p_.along.row(rows[k]);
      }
    }
    this->spend(cones * n * (n + cones + this->p_.ways));
  }

  /// Coulomb's constraints with the compliance that the other rows leave; true if they are met already.
  [[nodiscard]] bool solveCones(const ActiveConstraints& held) noexcept
  {
    this->reduceToCones(held);
    const int cones = 3 * this->p_.cones;
    const ConstraintProblem::Numbers before = this->f_.force_N.tail(cones);
    ConstraintProblem::Numbers free = this->movedOf().tail(cones);
    if (this->p_.ways > 0)
    {
      free += this->p_.yield_u_per_N * this->p_.along.bottomRows(cones).lazyProduct(this->balance());
    }
    free -= this->room_.conesAnswer.lazyProduct(before);
    this->solveContacts(free, before);
    const double change = (this->f_.force_N.tail(cones) - before).lpNorm<Eigen::Infinity>();
    return change <= rounding * before.lpNorm<Eigen::Infinity>();
  }

  /// With displacements across counted in units of each friction, all cones are one.
  [[nodiscard]] double unit(int i) const noexcept
  {
    return i % 3 == 0 ? 1.0 : this->p_.friction[static_cast<std::size_t>(i / 3)];
  }

  void solveContacts(const ConstraintProblem::Numbers& free, const ConstraintProblem::Numbers& before) noexcept
  {
    ContactProblem& contacts = this->room_.contacts;
    contacts.resize(this->p_.cones);
    contacts.friction = 1.0;
    const int n = 3 * this->p_.cones;
    this->room_.contactForces.force_N.resize(n);
    for (int i = 0; i < n; ++i)
    {
      contacts.free[i] = this->unit(i) * free[i];
      this->room_.contactForces.force_N[i] = before[i] / this->unit(i);
      for (int j = 0; j < n; ++j)
      {
        // Symmetric to the last bit, as the solver expects.
        const double both = 0.5 * (this->room_.conesAnswer(i, j) + this->room_.conesAnswer(j, i));
        contacts.compliance(i, j) = this->unit(i) * both * this->unit(j);
      }
    }
    const std::uint32_t left = this->budget_ - std::min(this->budget_, this->f_.work);
    solveFriction(contacts, this->room_.friction, this->room_.contactForces, left);
    this->f_.work += this->room_.contactForces.work;
    for (int i = 0; i < n; ++i)
    {
      this->f_.force_N[this->p_.bounded() + i] = this->unit(i) * this->room_.contactForces.force_N[i];
    }
  }

  [[nodiscard]] ConstraintProblem::Numbers movedOf() const noexcept
  {
    ConstraintProblem::Numbers moved = this->p_.free;
    moved += this->p_.compliance.lazyProduct(this->f_.force_N);
    moved += this->p_.along.lazyProduct(this->f_.way_u);
    return moved;
  }

  /// Where no balance was found bodies go against a drag: a first step, from which the next tick goes on. So a body
  /// that nothing stops slides, and no further in a tick than its load makes it.
  void yield() noexcept
  {
    if (this->steps_ > 0)
    {
      this->f_.force_N = this->firstForce_N_;
      this->f_.way_u.setZero();
    }
  }

  void finish(bool capped) noexcept
  {
    this->f_.capped = capped;
    this->f_.damping = this->steps_ > 0 ? this->damped_ : 0.0;
    const ConstraintProblem::Way open = this->balance();
    this->f_.unbalanced_N = this->p_.ways > 0 ? open.lpNorm<Eigen::Infinity>() : 0.0;
    this->f_.way_u += this->p_.yield_u_per_N * open; // as `stiffened` has it
    this->f_.moved_u = this->movedOf();
    this->f_.residual_u = this->p_.cones > 0 ? this->room_.contactForces.residual_u : 0.0;
    for (int i = 0; i < this->p_.bounded(); ++i)
    {
      const double moved = this->f_.moved_u[i];
      const bool hinders =
        moved < 0.0 ? this->f_.force_N[i] < this->p_.highest[i] : this->f_.force_N[i] > this->p_.lowest[i];
      this->f_.residual_u = std::max(this->f_.residual_u, hinders ? std::abs(moved) : 0.0);
    }
  }

  const ConstraintProblem& p_;
  ConstraintScratch& room_;
  ConstraintForces& f_;
  std::uint32_t budget_;
  BoundedConstraints rows_;
  double damped_ = 0.0; ///< how much the last step was, or the first one is
  double off_N_ = 0.0;  ///< balance where that began
  int steps_ = 0;
  int askedAt_ = 0;       ///< by which step it is asked next whether there is a place of rest
  double length_u_ = 0.0; ///< of the last step
  ConstraintProblem::Way open_N_;
  ConstraintProblem::Way step_u_;
  ConstraintProblem::Numbers firstForce_N_; ///< where the bodies are where they were
};

} // namespace

void solveConstraints(const ConstraintProblem& problem, ConstraintScratch& room, ConstraintForces& forces,
  std::uint32_t budget, ConstraintStart start) noexcept
{
  ConstraintSolve(problem, room, forces, budget).run(start);
}

} // namespace palpate
