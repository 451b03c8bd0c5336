// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/compliance/element/StrainPoints.h"

namespace palpate
{

/// The lower half of a symmetric matrix, column by column, rows ascending.
struct SparseLower
{
  std::vector<int> start; ///< of each column in rows and values, and the end
  std::vector<int> rows;
  std::vector<double> values;

  [[nodiscard]] int order() const { return static_cast<int>(this->start.size()) - 1; }
  /// The whole matrix times x.
  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& x) const;
};

/// Slots of the blocks of every strain point in the stiffness of the free nodes: found once, while the numbers change.
class StiffnessPattern
{
public:
  static constexpr std::int32_t fixedNode = -1;

  /// `numbers`: of each node among the free ones, or fixedNode.
  StiffnessPattern(const StrainPoints& body, std::vector<std::int32_t> numbers);

  [[nodiscard]] int order() const { return static_cast<int>(this->columnStart_.size()) - 1; }
  [[nodiscard]] const std::vector<std::int32_t>& numbers() const { return this->numbers_; }
  /// A zero matrix of this pattern.
  [[nodiscard]] SparseLower zeros() const;
  /// Adds volume times g_a : dP/dF : g_b of every pair of nodes of a point.
  void add(SparseLower& k, const StrainPoints& body, std::size_t point, const StressDerivative& stiffness) const;

private:
  void findSlots(const StrainPoints& body, const std::vector<std::vector<std::int32_t>>& below);
  void addBlock(SparseLower& k, std::int32_t slot, std::int32_t row, std::int32_t column, const Mat3& block) const;

  std::vector<std::int32_t> numbers_;
  std::vector<int> columnStart_;
  std::vector<int> rows_;
  std::vector<std::size_t> firstSlot_; ///< of each point
  std::vector<std::int32_t> slots_;    ///< for each pair a >= b of a point: its block below the diagonal
};

} // namespace palpate
