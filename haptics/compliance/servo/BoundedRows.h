// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace palpate
{

/// Rows whose forces have bounds: a row with a force inside its bounds does not move, a row at a bound moves only in
/// the direction that its force does not hinder. Gap = free + compliance force; the dual active-set method of Goldfarb
/// & Idnani (1983), exact except for rounding. Active rows are independent, and inside their bounds.
///
/// Rows: count(), compliance(i, j), free(i), lowest(i), highest(i), and `most`, how many there may be. Forces begin at
/// 0, which the bounds allow. Real-time safe.
template<class Rows>
class BoundedRows
{
public:
  static constexpr int most = Rows::most;

  explicit BoundedRows(const Rows& rows) noexcept : rows_(rows)
  {
    this->force_.fill(0.0);
    this->state_.fill(State::Open);
  }

  [[nodiscard]] double gap(int i) const noexcept { return this->gapAndRounding(i).gap; }
  [[nodiscard]] double force(int i) const noexcept { return this->force_[i]; }
  /// The active rows, in the order of the factor.
  [[nodiscard]] std::span<const int> held() const noexcept
  {
    return { this->closed_.data(), static_cast<std::size_t>(this->count_) };
  }

  /// The force of each row at its bound; 0 for active rows.
  using Bounds = std::array<double, most>;
  [[nodiscard]] Bounds bounds() const noexcept
  {
    Bounds bounds = this->force_;
    for (const int i : this->held())
    {
      bounds[i] = std::numeric_limits<double>::infinity();
    }
    return bounds;
  }
  /// Whether the same rows are active, and all others at the same bounds.
  [[nodiscard]] bool isHeldAs(const Bounds& bounds) const noexcept { return this->bounds() == bounds; }

  /// Activates every row without bounds. A row that depends on earlier rows is redundant, now and later.
  void holdUnbounded() noexcept
  {
    for (int i = 0; i < this->rows_.count(); ++i)
    {
      const bool bounded = std::isfinite(this->rows_.lowest(i)) || std::isfinite(this->rows_.highest(i));
      if (bounded)
      {
        continue;
      }
      if (this->sharesOf(i) > dependentBelow * this->a(i, i))
      {
        this->append(i);
      }
      else
      {
        this->state_[i] = State::Contradicts;
      }
    }
    this->resolve();
  }

  /// The most violated row; -1: no violation above rounding.
  [[nodiscard]] int worst() const noexcept
  {
    int worst = -1;
    double least = 0.0;
    for (int i = 0; i < this->rows_.count(); ++i)
    {
      const auto [gap, rounding] = this->gapAndRounding(i);
      const double missed = this->missedBy(i, gap);
      if (this->state_[i] == State::Open && missed < std::min(least, -rounding))
      {
        least = missed;
        worst = i;
      }
    }
    return worst;
  }

  /// Increases the force of row i until its gap closes or its force reaches its bound; rows that reach their bounds on
  /// the way become inactive. A row that depends on the active rows replaces one of them. Returns the number of steps.
  int close(int i) noexcept
  {
    const std::array<double, most> forces = this->force_;
    const std::array<int, most> closed = this->closed_;
    const int count = this->count_;
    const double way = this->gap(i) > 0.0 ? -1.0 : 1.0;
    for (int steps = 1;; ++steps)
    {
      const double free = this->sharesOf(i);
      const bool gives = free > dependentBelow * this->a(i, i);
      const double needed = gives ? -way * this->gap(i) / free : std::numeric_limits<double>::infinity();
      const double own = this->roomOf(i, way);
      const auto [length, leaves] = this->longestStep(
        way, gives ? std::numeric_limits<double>::epsilon() : dependentShare, std::min(std::max(needed, 0.0), own));
      if (leaves < 0 && std::isinf(length))
      {
        // No force of this row ends the overlap, because the other rows conflict with it. They stay unchanged.
        this->goBack(forces, std::span(closed.data(), static_cast<std::size_t>(count)));
        this->state_[i] = State::Contradicts;
        return steps;
      }
      this->press(i, way, length);
      if (leaves < 0)
      {
        this->settle(i, length < own);
        return steps;
      }
      this->release(leaves, way);
    }
  }

  /// (matrix of the active rows)^-1 x, in the order of held().
  void solveHeld(std::array<double, most>& x) const noexcept
  {
    for (int k = 0; k < this->count_; ++k)
    {
      for (int l = 0; l < k; ++l)
      {
        x[k] -= this->l_[k][l] * x[l];
      }
      x[k] /= this->l_[k][k];
    }
    this->solveBack(x);
  }

private:
  /// Share of a row's own compliance in its Schur complement; a smaller share is rounding.
  static constexpr double dependentBelow = 1e-12;
  /// Smallest true share of an active row in a dependent row: a smaller share is rounding, and without this limit the
  /// step would not end.
  static constexpr double dependentShare = 1e-9;

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
    int leaves = -1; ///< index among the active rows; none: the whole step is taken
  };

  [[nodiscard]] double a(int i, int j) const noexcept { return this->rows_.compliance(i, j); }

  /// Negative: the force can still change to close the gap.
  [[nodiscard]] double missedBy(int i, double gap) const noexcept
  {
    if (gap < 0.0)
    {
      return this->force_[i] < this->rows_.highest(i) ? gap : 0.0;
    }
    return this->force_[i] > this->rows_.lowest(i) ? -gap : 0.0;
  }

  [[nodiscard]] double roomOf(int i, double way) const noexcept
  {
    return way > 0.0 ? this->rows_.highest(i) - this->force_[i] : this->force_[i] - this->rows_.lowest(i);
  }

  [[nodiscard]] Gap gapAndRounding(int i) const noexcept
  {
    double sum = this->rows_.free(i);
    double size = std::abs(sum);
    for (int j = 0; j < this->rows_.count(); ++j)
    {
      const double part = this->a(i, j) * this->force_[j];
      sum += part;
      size += std::abs(part);
    }
    return { sum, 1e-14 * size };
  }

  /// Sensitivity of the active forces to row i, stored in shares_. Returns the Schur complement (free compliance) of
  /// row i.
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

  /// At most `length`: the step until the first force reaches its bound. Smaller shares do not count.
  [[nodiscard]] Step longestStep(double way, double leastShare, double length) const noexcept
  {
    Step step{ length };
    for (int k = 0; k < this->count_; ++k)
    {
      const double falls = way * this->shares_[k];
      const double room = this->roomOf(this->closed_[k], -falls);
      if (std::abs(falls) > leastShare && room < step.length * std::abs(falls))
      {
        step = { room / std::abs(falls), k };
      }
    }
    return step;
  }

  [[nodiscard]] double bounded(int i, double force) const noexcept
  {
    return std::min(std::max(force, this->rows_.lowest(i)), this->rows_.highest(i));
  }

  void press(int i, double way, double length) noexcept
  {
    this->force_[i] = this->bounded(i, this->force_[i] + way * length);
    for (int k = 0; k < this->count_; ++k)
    {
      const int held = this->closed_[k];
      this->force_[held] = this->bounded(held, this->force_[held] - way * length * this->shares_[k]);
    }
  }

  /// Row i after its last step: active, or at its bound and moving.
  void settle(int i, bool holds) noexcept
  {
    if (holds)
    {
      this->append(i);
    }
    this->resolve();
  }

  /// Deactivates a row at the bound that its force reached.
  void release(int place, double way) noexcept
  {
    const int i = this->closed_[place];
    this->force_[i] = way * this->shares_[place] > 0.0 ? this->rows_.lowest(i) : this->rows_.highest(i);
    this->state_[i] = State::Open;
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

  /// Appends row i to the factor of the active rows.
  void append(int i) noexcept
  {
    const double free = this->sharesOf(i);
    this->l_[this->count_] = this->row_;
    this->l_[this->count_][this->count_] = std::sqrt(std::max(free, dependentBelow * this->a(i, i)));
    this->closed_[this->count_++] = i;
    this->state_[i] = State::Closed;
  }

  /// The right-hand side of row i: its free gap, and the displacement by rows at their bounds.
  [[nodiscard]] double openGap(int i) const noexcept
  {
    double sum = this->rows_.free(i);
    for (int j = 0; j < this->rows_.count(); ++j)
    {
      if (this->state_[j] != State::Closed && this->force_[j] != 0.0)
      {
        sum += this->a(i, j) * this->force_[j];
      }
    }
    return sum;
  }

  /// Forces from the active set alone, without the errors of earlier steps.
  void resolve() noexcept
  {
    std::array<double, most> x;
    for (int k = 0; k < this->count_; ++k)
    {
      x[k] = -this->openGap(this->closed_[k]);
    }
    this->solveHeld(x);
    for (int k = 0; k < this->count_; ++k)
    {
      this->force_[this->closed_[k]] = this->bounded(this->closed_[k], x[k]);
    }
  }

  const Rows& rows_;
  std::array<double, most> force_;
  std::array<State, most> state_;
  std::array<int, most> closed_{};
  int count_ = 0;
  std::array<std::array<double, most>, most> l_; ///< Cholesky factor of the active rows
  std::array<double, most> row_{};
  std::array<double, most> shares_{};
};

} // namespace palpate
