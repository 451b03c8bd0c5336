// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace palpate::oracle
{

/// A solid of Hooke's material by ten-node tetrahedra (quadratic displacement, straight edges), as Zienkiewicz & Taylor
/// have it: four points of integration, a sparse LDL^T. Of its own: it shares no code with the product.
class QuadraticSolid
{
public:
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;
  struct Hooke
  {
    double young = 1.0;
    double poisson = 0.0;
  };

  /// Corners of tetrahedra in any order, and the material of each.
  QuadraticSolid(std::vector<Vector> corners, std::vector<std::array<int, 4>> tetrahedra, std::vector<Hooke> materials);

  /// Holds every node, halfway ones too, at places where this holds.
  void fix(const std::function<bool(const Vector&)>& where);
  /// A force an area on the triangles of the border whose corners all are where this holds.
  void pull(const std::function<bool(const Vector&)>& where, const Vector& traction);
  void solve();

  /// In the middle of a tetrahedron.
  [[nodiscard]] Matrix stressIn(int tetrahedron) const;
  /// Work of the load: twice the elastic energy.
  [[nodiscard]] double workOfLoad() const { return this->load_.dot(this->displacement_); }

private:
  using Nodes = std::array<int, 10>;
  /// Of the ten functions at a place within, and six times the volume.
  struct Shape
  {
    std::array<Vector, 10> gradients;
    double six = 0.0;
  };
  [[nodiscard]] Shape shapeAt(const Nodes& nodes, const Eigen::Vector4d& place) const;
  [[nodiscard]] int middleOf(int a, int b);
  /// Of a tetrahedron, three rows a node.
  [[nodiscard]] Eigen::Matrix<double, 30, 30> stiffnessOf(std::size_t tetrahedron) const;
  /// Adds the lower triangle of a tetrahedron's stiffness at the rows that `number` gives its nodes; -1: it is fixed.
  void assemble(
    std::size_t tetrahedron, const std::vector<int>& number, std::vector<Eigen::Triplet<double>>& entries) const;

  std::vector<Vector> places_;
  std::vector<Nodes> tetrahedra_;
  std::vector<Hooke> materials_;
  std::map<std::pair<int, int>, int> middles_;
  std::vector<bool> fixed_;
  Eigen::VectorXd load_;
  Eigen::VectorXd displacement_;
};

} // namespace palpate::oracle
