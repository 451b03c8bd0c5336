// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/body/SoftBody.h"
#include "haptics/compliance/snapshot/SpreadPatches.h"

namespace palpate
{

/// Compliance between vertices of the surface of a body whose stiffness never changes: of a vertex it is computed once,
/// for all the others that are known, and kept until too many others came. Neighbourhoods overlap, so a hand that moves
/// asks for a few new vertices a snapshot, and one that works in one region for none.
class ComplianceCache
{
public:
  /// 7 MB of compliance: a region twice as wide as a neighbourhood.
  static constexpr std::size_t mostKnown = 320;

  /// References are kept.
  ComplianceCache(const SoftBody& body, SpreadPatches& patches) : body_(body), patches_(patches) {}

  /// Gets to know the first of those that it does not know, at most so many, but all of them if it knows none. Those of
  /// `wanted` (no more than mostKnown) that it then knows, in their order.
  [[nodiscard]] std::vector<std::uint32_t> learn(const std::vector<std::uint32_t>& wanted, std::size_t most);
  /// Three rows a vertex [u/N], of vertices that are known: symmetric.
  [[nodiscard]] Eigen::MatrixXd between(const std::vector<std::uint32_t>& vertices) const;

private:
  [[nodiscard]] bool knows(std::uint32_t vertex) const;
  [[nodiscard]] Eigen::Index rowOf(std::uint32_t vertex) const;
  void add(const std::vector<std::uint32_t>& unknown);

  const SoftBody& body_;
  SpreadPatches& patches_;
  std::vector<std::uint32_t> vertices_; ///< asked for last, first
  Eigen::MatrixXd blocks_;              ///< three rows each
};

} // namespace palpate
