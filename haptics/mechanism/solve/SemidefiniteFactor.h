// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "haptics/core/Types.h"

namespace palpate
{

/// P^T L L^T P of a symmetric positive semidefinite matrix, the largest pivot first, so that its rank is seen.
/// Real-time safe: of fixed capacity.
template<int Most>
class SemidefiniteFactor
{
public:
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Most, Most>;
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Most, 1>;

  /// Pivots up to `rounding` are none.
  void factor(const Square& matrix, double rounding) noexcept
  {
    this->l_ = matrix;
    const int n = static_cast<int>(matrix.rows());
    for (int i = 0; i < n; ++i)
    {
      this->order_[i] = i;
    }
    for (this->rank_ = 0; this->rank_ < n; ++this->rank_)
    {
      const int k = this->rank_;
      Eigen::Index best = 0;
      if (this->l_.diagonal().tail(n - k).maxCoeff(&best) <= rounding)
      {
        return;
      }
      this->exchange(k, k + static_cast<int>(best));
      this->l_(k, k) = std::sqrt(this->l_(k, k));
      this->l_.col(k).tail(n - k - 1) /= this->l_(k, k);
      for (int j = k + 1; j < n; ++j)
      {
        this->l_.col(j).tail(n - j) -= this->l_(j, k) * this->l_.col(k).tail(n - j);
      }
    }
  }

  [[nodiscard]] int rank() const noexcept { return this->rank_; }
  /// Which rows were taken, in that order: the first rank() are independent.
  [[nodiscard]] int row(int place) const noexcept { return this->order_[place]; }

  /// x with matrix x = b for b in the range; components without a pivot stay 0.
  [[nodiscard]] Numbers solve(const Numbers& b) const noexcept
  {
    std::array<double, Most> y{};
    for (int k = 0; k < this->rank_; ++k)
    {
      y[k] = b[this->order_[k]];
      for (int l = 0; l < k; ++l)
      {
        y[k] -= this->l_(k, l) * y[l];
      }
      y[k] /= this->l_(k, k);
    }
    Numbers x = Numbers::Zero(b.size());
    for (int k = this->rank_ - 1; k >= 0; --k)
    {
      for (int l = k + 1; l < this->rank_; ++l)
      {
        y[k] -= this->l_(l, k) * y[l];
      }
      y[k] /= this->l_(k, k);
      x[this->order_[k]] = y[k];
    }
    return x;
  }

private:
  /// Rows and columns a and b of the lower triangle, a <= b.
  void exchange(int a, int b) noexcept
  {
    if (a == b)
    {
      return;
    }
    std::swap(this->order_[a], this->order_[b]);
    this->l_.template triangularView<Eigen::StrictlyUpper>() = this->l_.transpose();
    this->l_.row(a).swap(this->l_.row(b));
    this->l_.col(a).swap(this->l_.col(b));
  }

  Square l_;
  std::array<int, Most> order_{};
  int rank_ = 0;
};

} // namespace palpate
