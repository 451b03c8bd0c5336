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
  Vec3 ball_W = Vec3::Zero(); ///< in the free surface of the snapshot before [u]
  Vec3 velocity_u_per_s = Vec3::Zero();
  double radius_u = 0.0;             ///< of the ball; 0: a point, without the spring below the patch
  double tip_u = 0.0;                ///< radius of a point contact; 0: as wide as a patch
  double period_s = 0.04;            ///< from snapshot to snapshot
  std::vector<SurfacePoint> forceAt; ///< where the tool presses, or may: the snapshot answers there in any case
  std::vector<Vec3> force_N;         ///< and how, on the body
};

/// Vertices within reach of a place along the edges of the surface, nearest first, at most so many.
[[nodiscard]] std::vector<std::uint32_t> nearVerticesOf(const SoftSurface& surface, const std::vector<Vec3>& places_W,
  const Vec3& center_W, double reach_u, std::size_t most);

/// Makes snapshots of one body, one after the other. A worker's.
class SnapshotMaker
{
public:
  /// Of a snapshot: a neighbourhood of 30 mm on edges of 6 mm; further points have the compliance of the nearest node
  /// inside.
  static constexpr std::size_t usualVertices = 96;
  /// Patches are the ball's radius halved so often at most.
  static constexpr int mostHalvings = 3;
  /// Widths of patches that something is kept of at once: those of one ball, and the one that edges ask for.
  static constexpr std::size_t mostWidths = mostHalvings + 2;

  /// References are kept. `naturalPeriod_s`: the body's (NaturalPeriod.h); 0: it has no mass.
  SnapshotMaker(SoftBody& body, const SoftSurface& surface, double naturalPeriod_s = 0.0)
    : body_(body), surface_(surface), naturalPeriod_s_(naturalPeriod_s),
      untouched_W_(surface.placesOf(body.atRest(), body.atRest()))
  {
  }

  /// Brings the body to its rest under the tool's force by so many Newton steps, and extracts the snapshot for the
  /// servo. Null if a factor failed.
  [[nodiscard]] std::shared_ptr<const ComplianceSnapshot> make(const SnapshotRequest& request, int newtonSteps = 3);
  /// From now on a body whose stiffness never changes answers from this where it knows the nodes that are pressed, else
  /// by the factor; in either case without being brought to its rest: see load_N(). Null: nothing is kept, and it is.
  void answerBy(std::shared_ptr<const KeptInverse> kept);
  /// Whether the last snapshot was such an answer of what is kept.
  [[nodiscard]] bool answeredByKept() const { return this->byKept_; }
  /// Whether the body is at its rest under the load of the last snapshot, as far as Newton steps led.
  [[nodiscard]] bool isSettled() const { return !this->kept_; }
  /// The load of the last snapshot on the nodes of the body [N].
  [[nodiscard]] const Eigen::VectorXd& load_N() const { return this->load_N_; }
  /// How many widths of patches something is kept of: no more than mostWidths.
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
    std::size_t factoring = 0;                             ///< which one
    std::map<std::uint32_t, std::vector<PatchRung>> rungs; ///< within each vertex's patch, likewise
    std::map<std::uint32_t, BallDepth> depths;             ///< of a ball there, likewise
    double ball_u = 0.0;                                   ///< its radius
  };

  [[nodiscard]] double contactAhead_u(const SnapshotRequest& request) const;
  void pressWith(double radius_u, double tip_u);
  [[nodiscard]] Spread& spreadFor(const SnapshotRequest& request);
  [[nodiscard]] Eigen::VectorXd loadOf(const SnapshotRequest& request, Spread& spread) const;
  void choose(const SnapshotRequest& request, ComplianceSnapshot& snapshot) const;
  void addCompliance(Spread& spread, ComplianceSnapshot& snapshot);
  [[nodiscard]] SoftBodyState stateOf(const ComplianceSnapshot& snapshot) const;
  void learnRungs(Spread& spread, const ComplianceSnapshot& snapshot) const;
  [[nodiscard]] BallDepth depthAt(
    const ComplianceSnapshot& snapshot, std::size_t place, double ball_u, const std::vector<PatchRung>& within) const;
  [[nodiscard]] double edgeThatLacks_u(std::uint32_t vertex) const;
  void addTips(double tip_u, ComplianceSnapshot& snapshot);
  void prepareSurface(const ComplianceSnapshot& snapshot);
  void addSprings(const SnapshotRequest& request, Spread& spread, ComplianceSnapshot& snapshot);

  SoftBody& body_;
  const SoftSurface& surface_;
  double naturalPeriod_s_;
  std::shared_ptr<const KeptInverse> kept_; ///< null: nothing is kept
  bool byKept_ = false;                     ///< the last snapshot
  Eigen::VectorXd load_N_;                  ///< of the last snapshot
  std::vector<Vec3> untouched_W_;           ///< the surface under the permanent loads
  std::vector<Vec3> normals_W_;             ///< of its vertices, to either side; empty: not asked for yet
  std::optional<LayerCompliance> layer_;    ///< of its material, likewise
  std::optional<BallDepth> under_;          ///< where the ball was in the last snapshot
  double radius_u_ = 0.0;                   ///< of the ball that spreads are for
  double tip_u_ = 0.0;                      ///< of the tip that they are for
  std::map<double, Spread> spreads_;        ///< by the least radius of a patch; 0: as edges ask for
  int level_ = mostHalvings;                ///< how often the ball's radius is halved to that
  std::uint32_t version_ = 0;
};

} // namespace palpate
