// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/body/SoftBody.h"
#include "haptics/compliance/snapshot/SpreadPatches.h"

namespace palpate
{

class KeptInverse;

/// Compliance between vertices of the surface of a body by one factor of its stiffness: of a vertex it is computed
/// once, for all the others that are known, and kept until too many others came. Neighbourhoods overlap, so a hand that
/// moves asks for a few new vertices a snapshot, and one that works in one region for none.
class ComplianceCache
{
public:
  /// 7 MB of compliance: a region twice as wide as a neighbourhood.
  static constexpr std::size_t mostKnown = 320;

  /// References are kept.
  ComplianceCache(const SoftBody& body, SpreadPatches& patches) : body_(body), patches_(patches) {}

  /// Gets to know the first of those that it does not know, at most so many, but all of them if it knows none. Those of
  /// `wanted` (no more than mostKnown) that it then knows, in their order. `kept`: knows the patches of all that are
  /// wanted, so that they are read off it and none is left out; null: the body's factor answers.
  [[nodiscard]] std::vector<std::uint32_t> learn(
    const std::vector<std::uint32_t>& wanted, std::size_t most, const KeptInverse* kept = nullptr);
  /// The factor is another one.
  void forget() { this->vertices_.clear(); }
  /// Three rows a vertex [u/N], of vertices that are known: symmetric.
  [[nodiscard]] Eigen::MatrixXd between(const std::vector<std::uint32_t>& vertices) const;

private:
  [[nodiscard]] bool knows(std::uint32_t vertex) const;
  [[nodiscard]] Eigen::Index rowOf(std::uint32_t vertex) const;
  [[nodiscard]] std::vector<std::uint32_t> unknownOf(const std::vector<std::uint32_t>& wanted) const;
  void makeRoom(const std::vector<std::uint32_t>& wanted, std::size_t more);
  void add(const std::vector<std::uint32_t>& unknown, const KeptInverse* kept);

  const SoftBody& body_;
  SpreadPatches& patches_;
  std::vector<std::uint32_t> vertices_; ///< asked for last, first
  Eigen::MatrixXd blocks_;              ///< three rows each
};

} // namespace palpate
