// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include "haptics/compliance/snapshot/BallDepth.h"
#include "haptics/compliance/snapshot/ComplianceCache.h"
#include "haptics/compliance/snapshot/ComplianceSnapshot.h"
#include "haptics/compliance/snapshot/SoftSurface.h"

namespace palpate
{

/// The state of the servo at the tick of a snapshot.
struct SnapshotRequest
{
  std::uint64_t tick = 0;
  Vec3 ball_W = Vec3::Zero(); ///< in the free surface of the previous snapshot [u]
  Vec3 velocity_u_per_s = Vec3::Zero();
  double radius_u = 0.0;             ///< of the ball; 0: a point, without the spring below the patch
  double tip_u = 0.0;                ///< radius of a point contact; 0: as wide as a patch
  double period_s = 0.04;            ///< from snapshot to snapshot
  std::vector<SurfacePoint> forceAt; ///< where the tool presses, or may: these points have compliance in any case
  std::vector<SurfacePoint> watched; ///< so have these, where anything else may press
  std::vector<Vec3> force_N;         ///< and the forces there, on the body
  std::vector<PressedPart> parts;    ///< in place of the patches of these vertices, at different vertices each
};

/// Vertices within reach of a point along the edges of the surface, nearest first, at most `most`.
[[nodiscard]] std::vector<std::uint32_t> nearVerticesOf(const SoftSurface& surface, const std::vector<Vec3>& places_W,
  const Vec3& center_W, double reach_u, std::size_t most);

/// Makes snapshots of one body, one after the other. Used by a worker.
class SnapshotMaker
{
public:
  /// Vertices of a snapshot: a neighbourhood of 30 mm on edges of 6 mm; further points have the compliance of the
  /// nearest node inside.
  static constexpr std::size_t usualVertices = 96;
  /// The radius of patches is the ball's, halved at most so often.
  static constexpr int mostHalvings = 3;
  /// Most widths of patches with cached data: those of one ball, and the mesh's own.
  static constexpr std::size_t mostWidths = mostHalvings + 2;

  /// References are kept. `naturalPeriod_s`: of the body (NaturalPeriod.h); 0: without mass.
  SnapshotMaker(SoftBody& body, const SoftSurface& surface, double naturalPeriod_s = 0.0)
    : body_(body), surface_(surface), naturalPeriod_s_(naturalPeriod_s),
      untouched_W_(surface.placesOf(body.atRest(), body.atRest()))
  {
  }

  /// Brings the body towards equilibrium under the tool's forces by so many Newton steps, and makes the snapshot for
  /// the servo. Null if a factorisation failed.
  [[nodiscard]] std::shared_ptr<const ComplianceSnapshot> make(const SnapshotRequest& request, int newtonSteps = 3);
  /// From now on a body whose stiffness never changes answers from this where it knows the nodes that are pressed, else
  /// by the factor; in either case its equilibrium is not computed: see load_N(). Null: no inverse, and it is computed.
  void answerBy(std::shared_ptr<const KeptInverse> kept);
  /// True if the last snapshot was answered from the kept inverse.
  [[nodiscard]] bool answeredByKept() const { return this->byKept_; }
  /// True if the body is in equilibrium under the load of the last snapshot, as far as Newton steps led.
  [[nodiscard]] bool isSettled() const { return !this->kept_; }
  /// The load of the last snapshot on the nodes of the body [N].
  [[nodiscard]] const Eigen::VectorXd& load_N() const { return this->load_N_; }
  /// The number of widths of patches with cached data: no more than mostWidths.
  [[nodiscard]] std::size_t widths() const { return this->spreads_.size(); }

private:
  /// Cached compliance of a body under contacts of one width.
  struct Spread
  {
    Spread(const SoftBody& body, const SoftSurface& surface, double spread_u)
      : patches(surface, spread_u), known(body, this->patches)
    {
    }

    SpreadPatches patches;
    ComplianceCache known;                                 ///< of one factor
    std::size_t factoring = 0;                             ///< number of that factorisation
    std::map<std::uint32_t, std::vector<PatchRung>> rungs; ///< patches within each vertex's patch, likewise
    std::map<std::uint32_t, BallDepth> depths;             ///< depth of a ball there, likewise
    double ball_u = 0.0;                                   ///< its radius
  };

  [[nodiscard]] double contactAhead_u(const SnapshotRequest& request) const;
  void pressWith(double radius_u, double tip_u);
  [[nodiscard]] Spread& spreadFor(const SnapshotRequest& request);
  [[nodiscard]] Eigen::VectorXd loadOf(const SnapshotRequest& request, Spread& spread) const;
  [[nodiscard]] const PressedPart* partAt(const SnapshotRequest& request, std::uint32_t vertex) const;
  [[nodiscard]] SparseColumns columnsOf(
    const SnapshotRequest& request, Spread& spread, std::span<const std::uint32_t> vertices) const;
  void choose(const SnapshotRequest& request, ComplianceSnapshot& snapshot) const;
  void addCompliance(Spread& spread, ComplianceSnapshot& snapshot);
  void addParts(const SnapshotRequest& request, Spread& spread, ComplianceSnapshot& snapshot) const;
  [[nodiscard]] SoftBodyState stateOf(const ComplianceSnapshot& snapshot) const;
  void learnRungs(Spread& spread, const ComplianceSnapshot& snapshot) const;
  [[nodiscard]] BallDepth depthAt(
    const ComplianceSnapshot& snapshot, std::size_t place, double ball_u, const std::vector<PatchRung>& within) const;
  [[nodiscard]] double edgeThatLacks_u(std::uint32_t vertex) const;
  void addTips(const SnapshotRequest& request, ComplianceSnapshot& snapshot);
  void prepareSurface(const ComplianceSnapshot& snapshot);
  void addSprings(const SnapshotRequest& request, Spread& spread, ComplianceSnapshot& snapshot);

  SoftBody& body_;
  const SoftSurface& surface_;
  double naturalPeriod_s_;
  std::shared_ptr<const KeptInverse> kept_; ///< null: none
  bool byKept_ = false;                     ///< whether the last snapshot is from it
  Eigen::VectorXd load_N_;                  ///< of the last snapshot
  std::vector<Vec3> untouched_W_;           ///< the surface under the permanent loads
  std::vector<Vec3> normals_W_;             ///< of its vertices, to either side; empty: not computed yet
  std::optional<LayerCompliance> layer_;    ///< of its material, likewise
  std::optional<BallDepth> under_;          ///< at the ball of the last snapshot
  double radius_u_ = 0.0;                   ///< of the ball for which the spreads are
  double tip_u_ = 0.0;                      ///< of the tip for which they are
  std::map<double, Spread> spreads_;        ///< by the least radius of a patch; 0: the mesh's own width
  int level_ = mostHalvings;                ///< halvings of the ball's radius for that
  std::uint32_t version_ = 0;
};

} // namespace palpate
