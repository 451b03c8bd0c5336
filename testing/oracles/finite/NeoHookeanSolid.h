// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace palpate::oracle
{

/// A solid of stable neo-Hookean material (Smith, de Goes & Kim 2018, eq. 14) by four-node tetrahedra, in equilibrium
/// under dead loads at finite strain: the whole Newton iteration on the exact Hessian, the load put on in steps. Of its
/// own: it shares no code with the product.
class NeoHookeanSolid
{
public:
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;

  /// Corners of tetrahedra in an order that makes their volumes positive.
  NeoHookeanSolid(
    std::vector<Vector> places, std::vector<std::array<int, 4>> tetrahedra, double young_Pa, double poisson);

  /// Holds every node where this is true.
  void fix(const std::function<bool(int)>& node);
  /// The displacement under a load, three numbers a node [N], reached from rest in so many equal steps. Throws where
  /// Newton's iteration does not end with a residual of 1e-8 of the load.
  [[nodiscard]] Eigen::VectorXd displacementUnder(const Eigen::VectorXd& load_N, int steps) const;

private:
  struct Tetrahedron
  {
    std::array<int, 4> nodes;
    Eigen::Matrix<double, 4, 3> gradients; ///< of the four functions, a row each
    double volume = 0.0;
  };
  using Derivative = Eigen::Matrix<double, 9, 9>;

  [[nodiscard]] double energyDensity(const Matrix& f) const;
  /// Of the strain, less the work of the load.
  [[nodiscard]] double energyUnder(const Eigen::VectorXd& load_N, const Eigen::VectorXd& u) const;
  [[nodiscard]] Matrix stressAt(const Matrix& f) const;
  /// Of the stress by F, both column by column.
  [[nodiscard]] Derivative stressDerivative(const Matrix& f) const;
  [[nodiscard]] Matrix deformationOf(const Tetrahedron& t, const Eigen::VectorXd& u) const;
  /// Forces of the strain on the free nodes, and with entries their derivative by the nodes' displacements.
  [[nodiscard]] Eigen::VectorXd innerForces(
    const Eigen::VectorXd& u, std::vector<Eigen::Triplet<double>>* entries) const;
  [[nodiscard]] Eigen::VectorXd ofFree(const Eigen::VectorXd& all) const;
  void addFree(const Eigen::VectorXd& step, double length, Eigen::VectorXd& u) const;
  void settle(const Eigen::VectorXd& load_N, Eigen::VectorXd& u) const;

  std::vector<Tetrahedron> tetrahedra_;
  std::vector<int> number_; ///< of each of three numbers a node among the free ones; -1: fixed
  int free_ = 0;
  double mu_ = 0.0, lambda_ = 0.0, alpha_ = 1.0;
};

} // namespace palpate::oracle
