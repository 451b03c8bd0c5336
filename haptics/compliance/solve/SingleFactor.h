// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/compliance/solve/Supernodes.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// A factor in single precision: a solve reads half as many bytes, and reading is its cost. Its solutions are
/// good for directions to search in, not for results.
class SingleFactor
{
public:
  SingleFactor() = default;
  /// The pattern is kept by reference.
  SingleFactor(const SupernodalView& pattern, const std::vector<double>& values);

  [[nodiscard]] bool ready() const { return this->pattern_ != nullptr; }
  /// An approximation of K^-1 b.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

private:
  void forward(Eigen::VectorXf& y) const;
  void backward(Eigen::VectorXf& y) const;

  const SupernodalView* pattern_ = nullptr;
  std::vector<float> values_;
  int mostBelow_ = 0; ///< most rows below any supernode
};

} // namespace palpate
