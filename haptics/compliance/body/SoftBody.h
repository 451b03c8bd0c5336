// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "haptics/compliance/element/StrainPoints.h"
#include "haptics/compliance/solve/SparseFactor.h"

namespace palpate
{

/// When the stiffness of a model that changes with strain is factored anew.
enum class Factoring : std::uint8_t
{
  EachStep,
  WhenOld, ///< when the last factor takes more than eight iterations to solve by
};

/// The input of a soft body.
struct SoftBodyInput
{
  TetraMesh mesh;
  std::vector<bool> fixed;      ///< of each vertex
  std::vector<double> young_Pa; ///< of each tetrahedron, or one for all
  std::vector<Vec3> load_N;     ///< permanent load on each vertex, its weight say; empty: none
  double poisson = 0.4;
  double unit_m = 1.0;               ///< metres per unit of the scene
  double density_kg_per_m3 = 1000.0; ///< as water; only determines how fast the body can follow a hand
  ElementKind element = ElementKind::EdgeSmoothed;
  ElasticModel model = ElasticModel::NeoHookean;
  std::size_t mostBytes = std::size_t{ 2 } << 30; ///< of SoftBody::bytes(); checked before the factor is computed
};

/// Distance of a state from equilibrium, and the size of its strain.
struct SoftBodyState
{
  double residual_N = 0.0;   ///< largest force on a free node that is not balanced
  double energy_Nu = 0.0;    ///< elastic energy, and energy of the permanent loads; 0 at rest without loads
  double mostGradient = 0.0; ///< largest |F - 1|: up to .1 small strain is true to 1 %, from .5 on it is qualitative
};

/// A body of tetrahedra in quasi-static equilibrium under the loads on its nodes. Deterministic; not for the servo.
class SoftBody
{
public:
  /// From the points of checked tetrahedra; refactor() has to follow. makeSoftBody() does both.
  SoftBody(StrainPoints points, ElasticModel model, const std::vector<bool>& fixed);

  [[nodiscard]] const StrainPoints& points() const { return this->points_; }
  /// Three numbers per node [u]; 0 at fixed nodes.
  [[nodiscard]] const Eigen::VectorXd& displacement() const { return this->displacement_; }
  /// The displacement under the permanent loads alone.
  [[nodiscard]] const Eigen::VectorXd& atRest() const { return this->atRest_; }
  [[nodiscard]] bool isHeld(std::size_t node) const { return this->pattern_.numbers()[node] < 0; }
  [[nodiscard]] std::size_t factorBytes() const { return this->factor_.bytes(); }
  /// Of the factor; of the same in single precision, where steps go on with an old one; and of the halves in which the
  /// stiffness of a large body is added up.
  [[nodiscard]] std::size_t bytes() const;

  /// Factors the stiffness of the present state. False if it is not positive definite.
  [[nodiscard]] bool refactor();
  /// Newton steps towards the equilibrium under `load_N` (three numbers per node), each as long as it lowers the
  /// energy: up to `steps`, or until the residual is rounding. False if a factorisation failed: the state stays as it
  /// was. Steps by an old factor are solved to a thousandth, the first of several to three hundredths; compliance() and
  /// linearAnswer() then use that factor. No other step begins after a request to stop.
  [[nodiscard]] bool settle(const Eigen::VectorXd& load_N, int steps, const std::stop_token& stop = {});
  /// Finds the equilibrium under new permanent loads, in addition to all other loads, three numbers per node [N]. False
  /// if there is none, or a stop was requested.
  [[nodiscard]] bool bear(const Eigen::VectorXd& always_N, const std::stop_token& stop = {});
  /// Forces of the body's strain on its nodes, three numbers per node [N].
  [[nodiscard]] Eigen::VectorXd innerForces() const { return this->forcesAt(this->displacement_); }
  [[nodiscard]] SoftBodyState stateUnder(const Eigen::VectorXd& load_N) const;
  /// True if the stiffness depends on strain. With Hooke's law one solve by the only factor is exact.
  [[nodiscard]] bool stiffnessChanges() const { return this->model_ != ElasticModel::Linear; }
  /// By default in each step up to 2,000 nodes, and when old above.
  void factorsBe(Factoring factoring) { this->factoring_ = factoring; }
  /// Number of factorisations so far.
  [[nodiscard]] std::size_t factorings() const { return this->factorings_; }
  void place(const Eigen::VectorXd& displacement) { this->displacement_ = displacement; }

  /// H K^-1 H^T [u/N] by the last factor; `h`: its rows, on the numbers 3 node + axis.
  [[nodiscard]] Eigen::MatrixXd compliance(const SparseColumns& h) const;
  /// The diagonal of that matrix.
  [[nodiscard]] Eigen::VectorXd ownCompliance(const SparseColumns& h) const;
  /// H K^-1 N^T for a few rows N, whose nodes are among those of H.
  [[nodiscard]] Eigen::MatrixXd compliance(const SparseColumns& h, const SparseColumns& n) const;
  /// Displacement by the last factor: K^-1 load, three numbers per node [u].
  [[nodiscard]] Eigen::VectorXd linearAnswer(const Eigen::VectorXd& load_N) const;
  /// The equilibrium under a load, for a constant stiffness; the state does not change.
  [[nodiscard]] Eigen::VectorXd restUnder(const Eigen::VectorXd& load_N) const
  {
    return this->linearAnswer(load_N + this->always_N_);
  }

private:
  /// Nodal forces of the strain at a point with deformation gradient `f` [N].
  void addForces(const StrainPoint& p, const Mat3& f, Eigen::VectorXd& ofNodes) const;
  [[nodiscard]] Eigen::VectorXd forcesAt(const Eigen::VectorXd& displacement) const;
  [[nodiscard]] double energyAt(const Eigen::VectorXd& displacement) const;
  [[nodiscard]] SparseColumns ofFree(const SparseColumns& h) const;
  [[nodiscard]] Eigen::VectorXd gather(const Eigen::VectorXd& ofNodes) const;
  [[nodiscard]] Eigen::VectorXd scatter(const Eigen::VectorXd& ofFree) const;
  void assemble();
  /// Adds the stiffness of the points from `begin` to `end`.
  void addPoints(std::size_t begin, std::size_t end, SparseLower& k) const;
  [[nodiscard]] bool factorAssembled();
  /// The Newton step for the open forces with the stiffness of this state, by an old factor to that share; nothing
  /// if the factorisation failed.
  [[nodiscard]] std::optional<Eigen::VectorXd> newtonStep(const Eigen::VectorXd& open, double share);
  /// A line search from a state with that elastic energy; returns the energy after it.
  [[nodiscard]] double stepDown(
    const Eigen::VectorXd& load_N, const Eigen::VectorXd& step, double slope, double before);

  StrainPoints points_;
  ElasticModel model_;
  StiffnessPattern pattern_;
  SparseLower stiffness_;
  SparseLower otherHalf_; ///< of half of the points, during assembly
  SparseFactor factor_;
  Factoring factoring_;
  std::size_t factorings_ = 0;
  Eigen::VectorXd displacement_;
  Eigen::VectorXd always_N_;     ///< permanent loads
  Eigen::VectorXd atRest_;       ///< displacement under these loads alone
  double energyAtRest_Nu_ = 0.0; ///< energy under these loads alone
};

/// A body, or the reason why there is none.
struct SoftBodyResult
{
  std::unique_ptr<SoftBody> body;
  CheckedTetras checked;
  std::string refusal;
};

/// Checks all of the input, factors once, and brings the body to equilibrium under its loads, which may take 50 factors
/// more. Refuses an invalid body with a message. After a request to stop it ends with the factorisation that is under
/// way, refused.
[[nodiscard]] SoftBodyResult makeSoftBody(const SoftBodyInput& input, const std::stop_token& stop = {});

} // namespace palpate
