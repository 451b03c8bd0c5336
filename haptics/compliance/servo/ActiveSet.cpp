// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/compliance/servo/ContactProblem.h"

namespace palpate
{
namespace
{

/// The active set's own problem: normal rows alone.
class NormalSet
{
public:
  explicit NormalSet(const ContactProblem& problem) noexcept : problem_(problem)
  {
    this->force_.fill(0.0);
    this->state_.fill(State::Open);
  }

  [[nodiscard]] double gap(int i) const noexcept
  {
    double sum = this->problem_.free[3 * i];
    for (int j = 0; j < this->problem_.count; ++j)
    {
      sum += this->a(i, j) * this->force_[j];
    }
    return sum;
  }

  /// The contact that is violated most; -1: none by more than rounding.
  [[nodiscard]] int worst() const noexcept
  {
    int worst = -1;
    double least = 0.0;
    for (int i = 0; i < this->problem_.count; ++i)
    {
      const double rounding = 1e-14 * std::abs(this->problem_.free[3 * i]);
      if (const double gap = this->gap(i); this->state_[i] == State::Open && gap < std::min(least, -rounding))
      {
        least = gap;
        worst = i;
      }
    }
    return worst;
  }

  /// Takes a contact in, and lets go of those that would pull.
  void close(int i) noexcept
  {
    this->state_[i] = State::Closed;
    for (int round = 0; round <= this->problem_.count; ++round)
    {
      if (!this->solveClosed())
      {
        this->state_[i] = State::Dependent;
        this->force_[i] = 0.0;
        return;
      }
      const double share = this->shareWithoutPull();
      for (int c = 0; c < this->problem_.count; ++c)
      {
        this->force_[c] += this->state_[c] == State::Closed ? share * (this->next_[c] - this->force_[c]) : 0.0;
        if (this->state_[c] == State::Closed && share < 1.0 && this->next_[c] <= 0.0 && this->force_[c] <= this->tiny_)
        {
          this->force_[c] = 0.0;
          this->state_[c] = State::Open;
        }
      }
      if (share >= 1.0)
      {
        return;
      }
    }
  }

  [[nodiscard]] double force(int i) const noexcept { return this->force_[i]; }

private:
  enum class State : unsigned char
  {
    Open,
    Closed,
    Dependent, ///< its normal follows from those of others: they hold it too
  };

  [[nodiscard]] double a(int i, int j) const noexcept { return this->problem_.compliance(3 * i, 3 * j); }

  /// How far the forces may go to next_ until the first would pull; 1: none does.
  [[nodiscard]] double shareWithoutPull() noexcept
  {
    double share = 1.0;
    this->tiny_ = 0.0;
    for (int c = 0; c < this->problem_.count; ++c)
    {
      if (this->state_[c] == State::Closed && this->next_[c] <= 0.0)
      {
        share = std::min(share, this->force_[c] / (this->force_[c] - this->next_[c]));
      }
      this->tiny_ = std::max(this->tiny_, 1e-15 * this->force_[c]);
    }
    return share >= 0.0 ? share : 0.0; // 0/0: a contact without force that wants none
  }

  /// Forces that close the gaps of the closed ones, by Cholesky; false if they are not independent.
  [[nodiscard]] bool solveClosed() noexcept
  {
    int n = 0;
    for (int c = 0; c < this->problem_.count; ++c)
    {
      if (this->state_[c] == State::Closed)
      {
        this->closed_[n++] = c;
      }
    }
    for (int i = 0; i < n; ++i)
    {
      double right = -this->problem_.free[3 * this->closed_[i]];
      for (int j = 0; j <= i; ++j)
      {
        double sum = this->a(this->closed_[i], this->closed_[j]);
        for (int k = 0; k < j; ++k)
        {
          sum -= this->l_[i][k] * this->l_[j][k];
        }
        if (j < i)
        {
          this->l_[i][j] = sum / this->l_[j][j];
          right -= this->l_[i][j] * this->y_[j];
          continue;
        }
        if (sum <= 1e-12 * this->a(this->closed_[i], this->closed_[i]))
        {
          return false;
        }
        this->l_[i][i] = std::sqrt(sum);
        this->y_[i] = right / this->l_[i][i];
      }
    }
    for (int i = n - 1; i >= 0; --i)
    {
      double sum = this->y_[i];
      for (int k = i + 1; k < n; ++k)
      {
        sum -= this->l_[k][i] * this->next_[this->closed_[k]];
      }
      this->next_[this->closed_[i]] = sum / this->l_[i][i];
    }
    return true;
  }

  static constexpr int most = ContactProblem::most;
  const ContactProblem& problem_;
  std::array<double, most> force_;
  std::array<double, most> next_{};
  std::array<State, most> state_;
  std::array<int, most> closed_{};
  std::array<std::array<double, most>, most> l_;
  std::array<double, most> y_{};
  double tiny_ = 0.0;
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
  // Each round lowers the energy; twice the contacts is more than any of 1e5 random problems took.
  for (int i = set.worst(); i >= 0 && forces.steps < 4 * problem.count; i = set.worst())
  {
    set.close(i);
    ++forces.steps;
  }
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
