// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/solve/SingleFactor.h"

#include <algorithm>

#include "haptics/compliance/solve/Blas.h"

namespace palpate
{

SingleFactor::SingleFactor(const SupernodalView& pattern, const std::vector<double>& values)
  : pattern_(&pattern), values_(values.begin(), values.end())
{
  for (int s = 0; s < pattern.count; ++s)
  {
    this->mostBelow_ = std::max(this->mostBelow_, pattern.all(s) - pattern.own(s));
  }
}

void SingleFactor::forward(Eigen::VectorXf& y) const
{
  const SupernodalView& p = *this->pattern_;
  Eigen::VectorXf taken(this->mostBelow_);
  for (int s = 0; s < p.count; ++s)
  {
    const int own = p.own(s), all = p.all(s);
    const float* const block = this->values_.data() + p.valueStart[s];
    float* const solved = y.data() + p.column[s];
    blas::solveVector(own, block, all, blas::Transposed::No, solved);
    blas::multiplyVector(all - own, own, block + own, all, blas::Transposed::No, solved, taken.data());
    for (int i = 0; i < all - own; ++i)
    {
      y[p.rowsBelow(s)[i]] -= taken[i];
    }
  }
}

void SingleFactor::backward(Eigen::VectorXf& y) const
{
  const SupernodalView& p = *this->pattern_;
  Eigen::VectorXf known(this->mostBelow_), taken(p.order);
  for (int s = p.count - 1; s >= 0; --s)
  {
    const int own = p.own(s), all = p.all(s);
    const float* const block = this->values_.data() + p.valueStart[s];
    for (int i = 0; i < all - own; ++i)
    {
      known[i] = y[p.rowsBelow(s)[i]];
    }
    if (all > own)
    {
      blas::multiplyVector(all - own, own, block + own, all, blas::Transposed::Yes, known.data(), taken.data());
      y.segment(p.column[s], own) -= taken.head(own);
    }
    blas::solveVector(own, block, all, blas::Transposed::Yes, y.data() + p.column[s]);
  }
}

Eigen::VectorXd SingleFactor::solve(const Eigen::VectorXd& b) const
{
  // Scaled to a size that neither overflows nor vanishes.
  const double size = b.lpNorm<Eigen::Infinity>();
  if (!(size > 0.0))
  {
    return Eigen::VectorXd::Zero(b.size());
  }
  Eigen::VectorXf y(b.size());
  for (Eigen::Index k = 0; k < b.size(); ++k)
  {
    y[k] = static_cast<float>(b[this->pattern_->matrixRow[k]] / size);
  }
  this->forward(y);
  this->backward(y);
  Eigen::VectorXd x(b.size());
  for (Eigen::Index k = 0; k < b.size(); ++k)
  {
    x[this->pattern_->matrixRow[k]] = size * static_cast<double>(y[k]);
  }
  return x;
}

} // namespace palpate
