// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "haptics/compliance/servo/BoundedRows.h"
#include "haptics/mechanism/solve/LawProblem.h"

namespace palpate
{
namespace
{

constexpr int mostTurns = 60;
/// A step that has turned what it follows round by more than this share of it was too long.
constexpr double turnedRound = 0.5;
/// By how much further a body goes, step by step, that nothing resists.
constexpr double further = 4.0;
constexpr double furthest = 1e3;
/// Share of a row's own size, of a force and of a balance, that is rounding.
constexpr double rounding = 1e-13;
/// Of a way that the held rows resist, by what the compliance to compare with would: less is rounding.
constexpr double unresisted = 1e-11;

/// All rows that have bounds; what cones and free ways add to their gaps is known.
struct BoundedLaws
{
  static constexpr int most = LawProblem::most;

  const LawProblem& problem;
  const LawRoom& room;

  [[nodiscard]] int count() const noexcept { return this->problem.bounded(); }
  [[nodiscard]] double compliance(int i, int j) const noexcept { return this->room.stiffened(i, j); }
  [[nodiscard]] double free(int i) const noexcept { return this->room.pressed[i]; }
  [[nodiscard]] double lowest(int i) const noexcept { return this->problem.lowest[i]; }
  [[nodiscard]] double highest(int i) const noexcept { return this->problem.highest[i]; }
};
using HeldLaws = BoundedRows<BoundedLaws>;

/// The turns between rows, free ways and cones.
class LawSolve
{
public:
  LawSolve(const LawProblem& problem, LawRoom& room, LawForces& forces) noexcept
    : p_(problem), room_(room), f_(forces), rows_{ problem, room }
  {
  }

  void run() noexcept
  {
    this->begin();
    for (int turn = 0; turn < mostTurns; ++turn)
    {
      HeldLaws held(this->rows_);
      this->solveRows(held);
      const double unbalanced = this->unbalanced();
      if (unbalanced > this->enough_N())
      {
        this->stepWays(held);
      }
      else if (this->p_.cones == 0 || this->solveCones(held))
      {
        return this->finish(false);
      }
      else
      {
        this->length_ = 0.0;
      }
    }
    this->finish(true);
  }

private:
  void begin() noexcept
  {
    // On the balance this adds nothing: it only keeps what resists no way from being without end.
    this->room_.stiffened = this->p_.compliance;
    if (this->p_.ways > 0)
    {
      this->room_.stiffened += this->p_.yield_u_per_N * this->p_.along.lazyProduct(this->p_.along.transpose());
    }
    this->f_.way_u.setZero(this->p_.ways);
    this->f_.force_N.conservativeResizeLike(LawProblem::Numbers::Zero(this->p_.count));
    this->f_.force_N.head(this->p_.bounded()).setZero();
    this->f_.steps = 0;
  }

  /// Bounded rows under the present cones and ways.
  void solveRows(HeldLaws& held) noexcept
  {
    const int cones = 3 * this->p_.cones;
    const LawProblem::Way way = this->f_.way_u + this->p_.yield_u_per_N * this->p_.load;
    this->room_.pressed = this->p_.free;
    this->room_.pressed += this->p_.along.lazyProduct(way);
    this->room_.pressed += this->room_.stiffened.rightCols(cones).lazyProduct(this->f_.force_N.tail(cones));
    held.holdUnbounded();
    const int cap = this->f_.steps + 20 + 6 * this->p_.count;
    for (int i = held.worst(); i >= 0 && this->f_.steps < cap; i = held.worst())
    {
      this->f_.steps += held.close(i);
    }
    for (int i = 0; i < this->p_.bounded(); ++i)
    {
      this->f_.force_N[i] = held.force(i);
    }
  }

  [[nodiscard]] LawProblem::Way balance() const noexcept
  {
    LawProblem::Way sum = this->p_.load;
    sum += this->p_.along.transpose().lazyProduct(this->f_.force_N);
    return sum;
  }

  [[nodiscard]] double unbalanced() const noexcept
  {
    return this->p_.ways > 0 ? this->balance().lpNorm<Eigen::Infinity>() : 0.0;
  }

  [[nodiscard]] double enough_N() const noexcept
  {
    const double most = this->p_.count > 0 ? this->f_.force_N.lpNorm<Eigen::Infinity>() : 0.0;
    return this->p_.ways > 0 ? rounding * (most + this->p_.load.lpNorm<Eigen::Infinity>()) : 0.0;
  }

  /// What the held rows answer to each free way, and how they resist it.
  void answerWays(const HeldLaws& held) noexcept
  {
    const auto rows = held.held();
    const int n = static_cast<int>(rows.size());
    this->room_.waysAnswer.resize(n, this->p_.ways);
    SemidefiniteFactor<LawProblem::mostWays>::Square resists(this->p_.ways, this->p_.ways);
    std::array<double, LawProblem::most> x;
    for (int w = 0; w < this->p_.ways; ++w)
    {
      for (int k = 0; k < n; ++k)
      {
        x[k] = this->p_.along(rows[k], w);
      }
      held.solveHeld(x);
      for (int k = 0; k < n; ++k)
      {
        this->room_.waysAnswer(k, w) = x[k];
      }
      for (int v = 0; v < this->p_.ways; ++v)
      {
        resists(v, w) = 0.0;
        for (int k = 0; k < n; ++k)
        {
          resists(v, w) += this->p_.along(rows[k], v) * x[k];
        }
      }
    }
    this->room_.balance.factor(resists, unresisted / this->p_.yield_u_per_N);
  }

  /// Newton's step on the balance, which is the slope of a concave function of the ways, by pieces a quadratic one.
  /// Where rows let go or take hold on the way it may lead too far: then less of it.
  void stepWays(const HeldLaws& held) noexcept
  {
    const LawProblem::Way open = this->balance();
    if (this->length_ > 0.0 && open.dot(this->step_u_) < -turnedRound * this->slope_)
    {
      const double slope = open.dot(this->step_u_);
      const double less = this->length_ * std::clamp(this->slope_ / (this->slope_ - slope), 0.1, 0.9);
      this->f_.way_u += (less - this->length_) * this->step_u_;
      this->length_ = less;
      return;
    }
    this->answerWays(held);
    this->step_u_ = this->room_.balance.solve(open);
    this->reach_ =
      this->room_.balance.rank() < this->p_.ways ? std::min(further * this->reach_, furthest) : 1.0 / further;
    for (int k = this->room_.balance.rank(); k < this->p_.ways; ++k)
    {
      const int w = this->room_.balance.row(k);
      this->step_u_[w] += this->reach_ * this->p_.yield_u_per_N * open[w];
    }
    this->slope_ = open.dot(this->step_u_);
    this->length_ = 1.0;
    this->f_.way_u += this->step_u_;
  }

  /// How the cones' rows move under forces on themselves, all other laws held as they are, into contacts.compliance.
  void reduceToCones(const HeldLaws& held) noexcept
  {
    const auto rows = held.held();
    const int n = static_cast<int>(rows.size());
    const int first = this->p_.bounded();
    const int cones = this->p_.count - first;
    this->room_.conesAnswer = this->room_.stiffened.bottomRightCorner(cones, cones);
    this->room_.conesWays = this->p_.along.bottomRows(cones);
    std::array<double, LawProblem::most> x;
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
    for (int c = 0; c<cones&& this->p_.ways> 0; ++c)
    {
      const LawProblem::Way way = this->room_.balance.solve(this->room_.conesWays.row(c).transpose());
      this->room_.conesAnswer.col(c) += this->room_.conesWays.lazyProduct(way);
    }
  }

  /// Coulomb's laws in what the others leave them; true if they are met already.
  [[nodiscard]] bool solveCones(const HeldLaws& held) noexcept
  {
    if (this->p_.ways > 0)
    {
      this->answerWays(held);
    }
    this->reduceToCones(held);
    const int cones = 3 * this->p_.cones;
    const LawProblem::Numbers before = this->f_.force_N.tail(cones);
    LawProblem::Numbers free = this->movedOf().tail(cones);
    free -= this->room_.conesAnswer.lazyProduct(before);
    this->solveContacts(free, before);
    const double change = (this->f_.force_N.tail(cones) - before).lpNorm<Eigen::Infinity>();
    return change <= rounding * before.lpNorm<Eigen::Infinity>();
  }

  /// With ways across counted in units of each friction, all cones are one.
  void solveContacts(const LawProblem::Numbers& free, const LawProblem::Numbers& before) noexcept
  {
    ContactProblem& contacts = this->room_.contacts;
    contacts.resize(this->p_.cones);
    contacts.friction = 1.0;
    const int n = 3 * this->p_.cones;
    const auto unit = [this](int i) { return i % 3 == 0 ? 1.0 : this->p_.friction[static_cast<std::size_t>(i / 3)]; };
    this->room_.contactForces.force_N.resize(n);
    for (int i = 0; i < n; ++i)
    {
      contacts.free[i] = unit(i) * free[i];
      this->room_.contactForces.force_N[i] = before[i] / unit(i);
      for (int j = 0; j < n; ++j)
      {
        // Symmetric to the last bit, as the solver expects.
        const double both = 0.5 * (this->room_.conesAnswer(i, j) + this->room_.conesAnswer(j, i));
        contacts.compliance(i, j) = unit(i) * both * unit(j);
      }
    }
    solveFriction(contacts, this->room_.friction, this->room_.contactForces);
    this->f_.steps += this->room_.contactForces.steps;
    for (int i = 0; i < n; ++i)
    {
      this->f_.force_N[this->p_.bounded() + i] = unit(i) * this->room_.contactForces.force_N[i];
    }
  }

  [[nodiscard]] LawProblem::Numbers movedOf() const noexcept
  {
    LawProblem::Numbers moved = this->p_.free;
    moved += this->p_.compliance.lazyProduct(this->f_.force_N);
    moved += this->p_.along.lazyProduct(this->f_.way_u);
    return moved;
  }

  void finish(bool capped) noexcept
  {
    this->f_.capped = capped;
    this->f_.moved_u = this->movedOf();
    this->f_.unbalanced_N = this->unbalanced();
    this->f_.residual_u = this->p_.cones > 0 ? this->room_.contactForces.residual_u : 0.0;
    for (int i = 0; i < this->p_.bounded(); ++i)
    {
      const double moved = this->f_.moved_u[i];
      const bool hinders =
        moved < 0.0 ? this->f_.force_N[i] < this->p_.highest[i] : this->f_.force_N[i] > this->p_.lowest[i];
      this->f_.residual_u = std::max(this->f_.residual_u, hinders ? std::abs(moved) : 0.0);
    }
  }

  const LawProblem& p_;
  LawRoom& room_;
  LawForces& f_;
  BoundedLaws rows_;
  LawProblem::Way step_u_;
  double slope_ = 0.0;  ///< of what step_u_ follows, where it began
  double length_ = 0.0; ///< of it; 0: there has been none
  double reach_ = 0.25;
};

} // namespace

void LawProblem::resize(int rows, int freeWays) noexcept
{
  this->count = rows;
  this->ways = freeWays;
  this->compliance.resize(rows, rows);
  this->free.resize(rows);
  this->lowest.resize(rows);
  this->highest.resize(rows);
  this->along.resize(rows, freeWays);
  this->load.resize(freeWays);
}

void solveLaws(const LawProblem& problem, LawRoom& room, LawForces& forces) noexcept
{
  LawSolve(problem, room, forces).run();
}

} // namespace palpate
