// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "haptics/compliance/servo/ContactProblem.h"

namespace palpate
{
namespace
{

/// The active set's own problem: normal rows alone. Closed contacts are independent, have no gap and do not pull.
class NormalSet
{
public:
  explicit NormalSet(const ContactProblem& problem) noexcept : problem_(problem)
  {
    this->force_.fill(0.0);
    this->state_.fill(State::Open);
  }

  [[nodiscard]] double gap(int i) const noexcept { return this->gapAndRounding(i).gap; }

  /// The contact that is violated most; -1: none by more than rounding.
  [[nodiscard]] int worst() const noexcept
  {
    int worst = -1;
    double least = 0.0;
    for (int i = 0; i < this->problem_.count; ++i)
    {
      const auto [gap, rounding] = this->gapAndRounding(i);
      if (this->state_[i] == State::Open && gap < std::min(least, -rounding))
      {
        least = gap;
        worst = i;
      }
    }
    return worst;
  }

  /// Presses contact i until its gap closes; those that would pull let go on the way. Where its normal follows from
  /// those of the closed ones it takes the place of one of them. Returns how many steps that took.
  int close(int i) noexcept
  {
    const std::array<double, most> forces = this->force_;
    const std::array<int, most> closed = this->closed_;
    const int count = this->count_;
    for (int steps = 1;; ++steps)
    {
      const double free = this->sharesOf(i);
      const bool gives = free > dependentBelow * this->a(i, i);
      const double needed = gives ? -this->gap(i) / free : std::numeric_limits<double>::infinity();
      const auto [length, leaves] = this->longestStep(std::max(needed, 0.0));
      if (leaves < 0 && !gives)
      {
        // No force of it ends the overlap: the others contradict it. They stay as they were.
        this->goBack(forces, std::span(closed.data(), static_cast<std::size_t>(count)));
        this->state_[i] = State::Contradicts;
        return steps;
      }
      this->press(i, length);
      if (leaves < 0)
      {
        this->append(i);
        this->resolve();
        return steps;
      }
      this->release(leaves);
    }
  }

  [[nodiscard]] double force(int i) const noexcept { return this->force_[i]; }

private:
  static constexpr int most = ContactProblem::most;
  /// Share of a contact's own compliance that the closed ones leave free: less is rounding.
  static constexpr double dependentBelow = 1e-12;

  enum class State : unsigned char
  {
    Open,
    Closed,
    Contradicts,
  };
  struct Gap
  {
    double gap = 0.0;
    double rounding = 0.0;
  };
  struct Step
  {
    double length = 0.0;
    int leaves = -1; ///< place among the closed; none: the whole step goes
  };

  [[nodiscard]] double a(int i, int j) const noexcept { return this->problem_.compliance(3 * i, 3 * j); }

  [[nodiscard]] Gap gapAndRounding(int i) const noexcept
  {
    double sum = this->problem_.free[3 * i];
    double size = std::abs(sum);
    for (int j = 0; j < this->problem_.count; ++j)
    {
      const double part = this->a(i, j) * this->force_[j];
      sum += part;
      size += std::abs(part);
    }
    return { sum, 1e-14 * size };
  }

  /// By how much the closed ones' forces fall while i's grows by one, into shares_; returns what compliance they leave
  /// it.
  [[nodiscard]] double sharesOf(int i) noexcept
  {
    double free = this->a(i, i);
    for (int k = 0; k < this->count_; ++k)
    {
      double sum = this->a(this->closed_[k], i);
      for (int l = 0; l < k; ++l)
      {
        sum -= this->l_[k][l] * this->row_[l];
      }
      this->row_[k] = sum / this->l_[k][k];
      free -= this->row_[k] * this->row_[k];
    }
    this->shares_ = this->row_;
    this->solveBack(this->shares_);
    return free;
  }

  /// L^T x = x.
  void solveBack(std::array<double, most>& x) const noexcept
  {
    for (int k = this->count_ - 1; k >= 0; --k)
    {
      for (int l = k + 1; l < this->count_; ++l)
      {
        x[k] -= this->l_[l][k] * x[l];
      }
      x[k] /= this->l_[k][k];
    }
  }

  /// At most `length`: until the first force that falls on the way is gone.
  [[nodiscard]] Step longestStep(double length) const noexcept
  {
    Step step{ length };
    for (int k = 0; k < this->count_; ++k)
    {
      const double force = this->force_[this->closed_[k]];
      if (this->shares_[k] > std::numeric_limits<double>::epsilon() && force < step.length * this->shares_[k])
      {
        step = { force / this->shares_[k], k };
      }
    }
    return step;
  }

  void press(int i, double length) noexcept
  {
    this->force_[i] += length;
    for (int k = 0; k < this->count_; ++k)
    {
      double& force = this->force_[this->closed_[k]];
      force = std::max(force - length * this->shares_[k], 0.0);
    }
  }

  void release(int place) noexcept
  {
    this->force_[this->closed_[place]] = 0.0;
    this->state_[this->closed_[place]] = State::Open;
    const int left = this->count_ - 1;
    std::copy(this->closed_.begin() + place + 1, this->closed_.begin() + this->count_, this->closed_.begin() + place);
    for (this->count_ = place; this->count_ < left;)
    {
      const int next = this->closed_[this->count_];
      this->append(next);
    }
  }

  void goBack(const std::array<double, most>& forces, std::span<const int> closed) noexcept
  {
    this->force_ = forces;
    this->count_ = 0;
    for (const int i : closed)
    {
      this->append(i);
    }
  }

  /// Contact i as the last row of the factor of what is closed.
  void append(int i) noexcept
  {
    const double free = this->sharesOf(i);
    this->l_[this->count_] = this->row_;
    this->l_[this->count_][this->count_] = std::sqrt(std::max(free, dependentBelow * this->a(i, i)));
    this->closed_[this->count_++] = i;
    this->state_[i] = State::Closed;
  }

  /// Forces from the closed set alone: no error of earlier steps stays.
  void resolve() noexcept
  {
    std::array<double, most> x;
    for (int k = 0; k < this->count_; ++k)
    {
      double sum = -this->problem_.free[3 * this->closed_[k]];
      for (int l = 0; l < k; ++l)
      {
        sum -= this->l_[k][l] * x[l];
      }
      x[k] = sum / this->l_[k][k];
    }
    this->solveBack(x);
    for (int k = 0; k < this->count_; ++k)
    {
      this->force_[this->closed_[k]] = std::max(x[k], 0.0);
    }
  }

  const ContactProblem& problem_;
  std::array<double, most> force_;
  std::array<State, most> state_;
  std::array<int, most> closed_{};
  int count_ = 0;
  std::array<std::array<double, most>, most> l_; ///< Cholesky's factor of the closed rows
  std::array<double, most> row_{};
  std::array<double, most> shares_{};
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
  NormalSet set(problem);
  forces.steps = 0;
  // The energy held grows with each contact that closes: only rounding could turn in circles.
  const int cap = 20 + 4 * problem.count;
  for (int i = set.worst(); i >= 0 && forces.steps < cap; i = set.worst())
  {
    forces.steps += set.close(i);
  }
  forces.work = static_cast<std::uint32_t>(forces.steps * (1 + problem.count * problem.count / 3));
  forces.force_N.setZero(3 * problem.count);
  forces.residual_u = 0.0;
  for (int i = 0; i < problem.count; ++i)
  {
    forces.force_N[3 * i] = set.force(i);
    const double gap = set.gap(i);
    forces.residual_u = std::max(forces.residual_u, set.force(i) > 0.0 ? std::abs(gap) : -gap);
  }
}

} // namespace palpate
