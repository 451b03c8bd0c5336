// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace palpate
{

/// Rows whose forces have bounds: inside them a row does not move, at one it moves only the way that its force does not
/// hinder. Gap = free + compliance force; the dual active set of Goldfarb & Idnani (1983), exact but for rounding. Rows
/// that are held are independent, and inside their bounds.
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
  /// The rows that are held, in the order of the factor.
  [[nodiscard]] std::span<const int> held() const noexcept
  {
    return { this->closed_.data(), static_cast<std::size_t>(this->count_) };
  }

  /// Of each row the force that it has at its bound; of those that are held none.
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
  /// Whether the same rows are held, and all others at the same bounds.
  [[nodiscard]] bool isHeldAs(const Bounds& bounds) const noexcept { return this->bounds() == bounds; }

  /// Holds every row that has no bounds. One that follows from those before has nothing to add, now or later.
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

  /// The row that is violated most; -1: none by more than rounding.
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

  /// Presses or pulls row i until its gap closes or its force is at its bound; those that come to theirs let go on the
  /// way. Where it follows from the held ones it takes the place of one of them. Returns how many steps that took.
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
        // No force of it ends the overlap: the others contradict it. They stay as they were.
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

  /// (rows of the held ones)^-1 x, in the order of held().
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
  /// Share of a row's own compliance that the held ones leave free: less is rounding.
  static constexpr double dependentBelow = 1e-12;
  /// Share that a held row truly has in one that follows from the held ones: a smaller one is rounding, and nothing
  /// else would end the step.
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
    int leaves = -1; ///< place among the held; none: the whole step goes
  };

  [[nodiscard]] double a(int i, int j) const noexcept { return this->rows_.compliance(i, j); }

  /// Below 0: the force may change so as to end it.
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

  /// By how much the held ones' forces fall while i's grows by one, into shares_; returns what compliance they leave
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

  /// At most `length`: until the first force that goes to its bound on the way is there. Smaller shares do not count.
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

  /// Row i after its last step: held, or at its bound where it goes on to move.
  void settle(int i, bool holds) noexcept
  {
    if (holds)
    {
      this->append(i);
    }
    this->resolve();
  }

  /// That one at the bound it has come to.
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

  /// Row i as the last one of the factor of what is held.
  void append(int i) noexcept
  {
    const double free = this->sharesOf(i);
    this->l_[this->count_] = this->row_;
    this->l_[this->count_][this->count_] = std::sqrt(std::max(free, dependentBelow * this->a(i, i)));
    this->closed_[this->count_++] = i;
    this->state_[i] = State::Closed;
  }

  /// What row i has to make up for: its free gap, and what the rows at their bounds press it by.
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

  /// Forces from the held set alone: no error of earlier steps stays.
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
  std::array<std::array<double, most>, most> l_; ///< Cholesky's factor of the held rows
  std::array<double, most> row_{};
  std::array<double, most> shares_{};
};

} // namespace palpate
