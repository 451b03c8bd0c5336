// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "haptics/compliance/body/SoftBody.h"

namespace palpate
{

/// The inverse of the stiffness between nodes of a body whose stiffness never changes (static condensation, Guyan
/// 1965): computed once, so that an answer needs no work inside the body. One half of a symmetric matrix in
/// double precision, as many bytes as a whole one in single precision.
///
/// One thread condenses, others may query the condensed part meanwhile. The numbers of a node do not depend on earlier
/// queries, nor on their time.
class KeptInverse
{
public:
  static constexpr std::size_t mostNodes = 1500; ///< 81 MB
  /// Nodes whose columns are solved for together: enough for BLAS, and few enough that an order to stop acts soon.
  static constexpr std::size_t nodesAtOnce = 16;

  /// `nodes`: earlier ones are condensed first; fixed ones, and those beyond mostNodes, are left out. The body
  /// is kept by reference. Throws std::bad_alloc.
  KeptInverse(const SoftBody& body, const std::vector<std::uint32_t>& nodes);

  /// Condenses the next nodes; false if there are no more. Throws std::bad_alloc.
  bool condenseNext();
  [[nodiscard]] std::size_t known() const { return this->known_.load(std::memory_order_acquire); }
  [[nodiscard]] std::size_t size() const { return this->nodes_.size(); }
  /// True if all rows of `h` that move are condensed. Any thread.
  [[nodiscard]] bool knows(const SparseColumns& h) const;
  /// H K^-1 N^T [u/N], as of SoftBody::compliance(), for rows that are condensed. Any thread.
  [[nodiscard]] Eigen::MatrixXd compliance(const SparseColumns& h, const SparseColumns& n) const;

private:
  [[nodiscard]] std::vector<std::int32_t> placesOf(const SparseColumns& h) const;
  [[nodiscard]] SparseColumns among(const std::vector<std::int32_t>& places, const SparseColumns& h) const;
  [[nodiscard]] auto between(std::int32_t earlier, std::int32_t later) const;
  [[nodiscard]] Eigen::MatrixXd gather(
    const std::vector<std::int32_t>& rows, const std::vector<std::int32_t>& columns) const;

  static constexpr std::int32_t noPlace = -1;   ///< of a fixed node
  static constexpr std::int32_t elsewhere = -2; ///< of a free node that is not among those here

  const SoftBody& body_;
  std::vector<std::uint32_t> nodes_;
  std::vector<std::int32_t> placeOf_;    ///< of each node of the body
  std::vector<Eigen::MatrixXd> columns_; ///< of each group of nodes: rows of all nodes up to these
  std::atomic<std::size_t> known_ = 0;   ///< of nodes_, from the first
};

} // namespace palpate
