// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "haptics/compliance/body/SoftBody.h"

namespace palpate
{

/// The inverse of the stiffness between nodes of a body whose stiffness never changes (static condensation, Guyan
/// 1965): computed once, whatever answers from it does no work inside the body. One half of a symmetric matrix in
/// double precision, as many bytes as a whole one in single precision.
///
/// One thread condenses, others may ask meanwhile for what is there. The numbers of a node do not depend on who asked
/// before, nor when.
class KeptInverse
{
public:
  static constexpr std::size_t mostNodes = 1500; ///< 81 MB
  /// Nodes whose columns are solved for together: enough for BLAS, and few enough that an order to stop is soon obeyed.
  static constexpr std::size_t nodesAtOnce = 16;

  /// `nodes`: those that come first are condensed first; fixed ones, and those beyond mostNodes, are left out. The body
  /// is kept by reference. Throws std::bad_alloc.
  KeptInverse(const SoftBody& body, const std::vector<std::uint32_t>& nodes);

  /// The next nodes; false if there are no more. Throws std::bad_alloc.
  bool condenseNext();
  [[nodiscard]] std::size_t known() const { return this->known_.load(std::memory_order_acquire); }
  [[nodiscard]] std::size_t size() const { return this->nodes_.size(); }
  /// Whether it answers on all rows of `h` that move. Any thread.
  [[nodiscard]] bool knows(const SparseColumns& h) const;
  /// H K^-1 N^T [u/N], as SoftBody::compliance() has it, on rows that it knows. Any thread.
  [[nodiscard]] Eigen::MatrixXd compliance(const SparseColumns& h, const SparseColumns& n) const;

private:
  [[nodiscard]] std::vector<std::int32_t> placesOf(const SparseColumns& h) const;
  [[nodiscard]] SparseColumns among(const std::vector<std::int32_t>& places, const SparseColumns& h) const;
  [[nodiscard]] auto between(std::int32_t earlier, std::int32_t later) const;
  [[nodiscard]] Eigen::MatrixXd gather(
    const std::vector<std::int32_t>& rows, const std::vector<std::int32_t>& columns) const;

  static constexpr std::int32_t noPlace = -1;   ///< of a node that is held
  static constexpr std::int32_t elsewhere = -2; ///< of a node that moves and is not among those here

  const SoftBody& body_;
  std::vector<std::uint32_t> nodes_;
  std::vector<std::int32_t> placeOf_;    ///< of each node of the body
  std::vector<Eigen::MatrixXd> columns_; ///< of so many nodes at once: rows of all nodes up to these
  std::atomic<std::size_t> known_ = 0;   ///< of nodes_, from the first
};

} // namespace palpate
