// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/body/SoftBody.h"
#include "haptics/compliance/snapshot/SpreadPatches.h"

namespace palpate
{

class KeptInverse;

/// Compliance between vertices of the surface of a body by one factor of its stiffness: for each vertex it is computed
/// once, to all others that are known, and kept until too many others came. Neighbourhoods overlap, so that a hand that
/// moves needs a few new vertices per snapshot, and one that works in one region needs none.
class ComplianceCache
{
public:
  /// 7 MB of compliance: a region twice as wide as a neighbourhood.
  static constexpr std::size_t mostKnown = 320;

  /// References are kept.
  ComplianceCache(const SoftBody& body, SpreadPatches& patches) : body_(body), patches_(patches) {}

  /// Computes the first unknown vertices of `wanted`, at most `most`, but all of them if it knows none. Returns those
  /// of `wanted` (no more than mostKnown) that are known then, in their order. `kept`: knows the patches of all that
  /// are wanted, so that they are read off it and none is left out; null: the body's factor answers.
  [[nodiscard]] std::vector<std::uint32_t> learn(
    const std::vector<std::uint32_t>& wanted, std::size_t most, const KeptInverse* kept = nullptr);
  /// To be called for another factor.
  void forget() { this->vertices_.clear(); }
  /// Three rows per vertex [u/N], for known vertices: symmetric.
  [[nodiscard]] Eigen::MatrixXd between(const std::vector<std::uint32_t>& vertices) const;

private:
  [[nodiscard]] bool knows(std::uint32_t vertex) const;
  [[nodiscard]] Eigen::Index rowOf(std::uint32_t vertex) const;
  [[nodiscard]] std::vector<std::uint32_t> unknownOf(const std::vector<std::uint32_t>& wanted) const;
  void makeRoom(const std::vector<std::uint32_t>& wanted, std::size_t more);
  void add(const std::vector<std::uint32_t>& unknown, const KeptInverse* kept);

  const SoftBody& body_;
  SpreadPatches& patches_;
  std::vector<std::uint32_t> vertices_; ///< the last wanted ones come first
  Eigen::MatrixXd blocks_;              ///< three rows each
};

} // namespace palpate
