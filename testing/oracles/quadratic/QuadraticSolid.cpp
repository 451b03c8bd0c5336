// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/quadratic/QuadraticSolid.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "testing/oracles/sparse/SymmetricSolve.h"

namespace palpate::oracle
{
namespace
{

using Vector = QuadraticSolid::Vector;
using Matrix = QuadraticSolid::Matrix;
using Voigt = Eigen::Matrix<double, 6, 3>;

constexpr std::array<std::pair<int, int>, 6> edges{ { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } };

/// Strain (xx, yy, zz, xy, yz, zx, shear as an angle) of a node's displacement.
Voigt strainOf(const Vector& g)
{
  Voigt b = Voigt::Zero();
  for (int axis = 0; axis < 3; ++axis)
  {
    const int next = (axis + 1) % 3;
    b(axis, axis) = g[axis];
    b(3 + axis, axis) = g[next];
    b(3 + axis, next) = g[axis];
  }
  return b;
}

Eigen::Matrix<double, 6, 6> hooke(const QuadraticSolid::Hooke& m)
{
  Eigen::Matrix<double, 6, 6> compliance = Eigen::Matrix<double, 6, 6>::Zero();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      compliance(i, j) = (i == j ? 1.0 : -m.poisson) / m.young;
    }
    compliance(3 + i, 3 + i) = 2.0 * (1.0 + m.poisson) / m.young;
  }
  return compliance.inverse();
}

} // namespace

QuadraticSolid::QuadraticSolid(
  std::vector<Vector> corners, std::vector<std::array<int, 4>> tetrahedra, std::vector<Hooke> materials)
  : places_(std::move(corners)), materials_(std::move(materials))
{
  for (const auto& t : tetrahedra)
  {
    Nodes nodes{ t[0], t[1], t[2], t[3] };
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      nodes[4 + e] =
        this->middleOf(t[static_cast<std::size_t>(edges[e].first)], t[static_cast<std::size_t>(edges[e].second)]);
    }
    this->tetrahedra_.push_back(nodes);
  }
  this->fixed_.assign(this->places_.size(), false);
  this->load_ = this->displacement_ = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(this->places_.size()));
}

int QuadraticSolid::middleOf(int a, int b)
{
  const auto [found, isNew] = this->middles_.try_emplace(std::minmax(a, b), static_cast<int>(this->places_.size()));
  if (isNew)
  {
    const Vector middle =
      0.5 * (this->places_[static_cast<std::size_t>(a)] + this->places_[static_cast<std::size_t>(b)]);
    this->places_.push_back(middle);
  }
  return found->second;
}

QuadraticSolid::Shape QuadraticSolid::shapeAt(const Nodes& nodes, const Eigen::Vector4d& place) const
{
  Matrix sides;
  for (int i = 0; i < 3; ++i)
  {
    sides.col(i) = this->places_[static_cast<std::size_t>(nodes[static_cast<std::size_t>(i) + 1])] -
                   this->places_[static_cast<std::size_t>(nodes[0])];
  }
  const Matrix inverse = sides.inverse();
  Eigen::Matrix<double, 4, 3> linear;
  linear.bottomRows<3>() = inverse;
  linear.row(0) = -inverse.colwise().sum();
  Shape shape;
  shape.six = std::abs(sides.determinant());
  for (int a = 0; a < 4; ++a)
  {
    shape.gradients[static_cast<std::size_t>(a)] = (4.0 * place[a] - 1.0) * linear.row(a).transpose();
  }
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const auto [a, b] = edges[e];
    shape.gradients[4 + e] = 4.0 * (place[a] * linear.row(b) + place[b] * linear.row(a)).transpose();
  }
  return shape;
}

void QuadraticSolid::fix(const std::function<bool(const Vector&)>& where)
{
  for (std::size_t n = 0; n < this->places_.size(); ++n)
  {
    this->fixed_[n] = this->fixed_[n] || where(this->places_[n]);
  }
}

void QuadraticSolid::pull(const std::function<bool(const Vector&)>& where, const Vector& traction)
{
  std::map<std::set<int>, int> seen;
  for (const Nodes& nodes : this->tetrahedra_)
  {
    for (std::size_t without = 0; without < 4; ++without)
    {
      std::set<int> face(nodes.begin(), nodes.begin() + 4);
      face.erase(nodes[without]);
      ++seen[face];
    }
  }
  for (const auto& [face, times] : seen)
  {
    const std::vector<int> c(face.begin(), face.end());
    const auto at = [&](int i) -> const Vector&
    { return this->places_[static_cast<std::size_t>(c[static_cast<std::size_t>(i)])]; };
    if (times != 1 || !where(at(0)) || !where(at(1)) || !where(at(2)))
    {
      continue;
    }
    const double area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
    for (const auto& [a, b] : { std::pair(c[0], c[1]), std::pair(c[0], c[2]), std::pair(c[1], c[2]) })
    {
      this->load_.segment<3>(3 * this->middles_.at({ a, b })) += area / 3.0 * traction; // corners have none of it
    }
  }
}

Eigen::Matrix<double, 30, 30> QuadraticSolid::stiffnessOf(std::size_t tetrahedron) const
{
  const double far = (5.0 + 3.0 * std::sqrt(5.0)) / 20.0;
  const double near = (5.0 - std::sqrt(5.0)) / 20.0;
  const Eigen::Matrix<double, 6, 6> d = hooke(this->materials_[tetrahedron]);
  Eigen::Matrix<double, 30, 30> k = Eigen::Matrix<double, 30, 30>::Zero();
  for (int point = 0; point < 4; ++point)
  {
    Eigen::Vector4d place = Eigen::Vector4d::Constant(near);
    place[point] = far;
    const Shape shape = this->shapeAt(this->tetrahedra_[tetrahedron], place);
    Eigen::Matrix<double, 6, 30> b;
    for (int a = 0; a < 10; ++a)
    {
      b.middleCols<3>(3 * a) = strainOf(shape.gradients[static_cast<std::size_t>(a)]);
    }
    k += shape.six / 24.0 * b.transpose() * d * b;
  }
  return k;
}

void QuadraticSolid::assemble(
  std::size_t tetrahedron, const std::vector<int>& number, std::vector<Eigen::Triplet<double>>& entries) const
{
  const Nodes& nodes = this->tetrahedra_[tetrahedron];
  const Eigen::Matrix<double, 30, 30> k = this->stiffnessOf(tetrahedron);
  for (int i = 0; i < 30; ++i)
  {
    for (int j = 0; j < 30; ++j)
    {
      const int row = number[static_cast<std::size_t>(nodes[static_cast<std::size_t>(i / 3)])];
      const int column = number[static_cast<std::size_t>(nodes[static_cast<std::size_t>(j / 3)])];
      if (row >= 0 && column >= 0 && row + i % 3 >= column + j % 3)
      {
        entries.emplace_back(row + i % 3, column + j % 3, k(i, j));
      }
    }
  }
}

void QuadraticSolid::solve()
{
  std::vector<int> number;
  int free = 0;
  for (const bool held : this->fixed_)
  {
    number.push_back(held ? -1 : 3 * free++);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t t = 0; t < this->tetrahedra_.size(); ++t)
  {
    this->assemble(t, number, entries);
  }
  Eigen::SparseMatrix<double> stiffness(3 * free, 3 * free);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd load(3 * free);
  for (std::size_t n = 0; n < number.size(); ++n)
  {
    if (number[n] >= 0)
    {
      load.segment<3>(number[n]) = this->load_.segment<3>(3 * static_cast<Eigen::Index>(n));
    }
  }
  const Eigen::VectorXd moved = solveSymmetric(stiffness, load);
  for (std::size_t n = 0; n < number.size(); ++n)
  {
    if (number[n] >= 0)
    {
      this->displacement_.segment<3>(3 * static_cast<Eigen::Index>(n)) = moved.segment<3>(number[n]);
    }
  }
}

QuadraticSolid::Matrix QuadraticSolid::stressIn(int tetrahedron) const
{
  const Nodes& nodes = this->tetrahedra_[static_cast<std::size_t>(tetrahedron)];
  const Shape shape = this->shapeAt(nodes, Eigen::Vector4d::Constant(0.25));
  Eigen::Matrix<double, 6, 1> strain = Eigen::Matrix<double, 6, 1>::Zero();
  for (std::size_t a = 0; a < 10; ++a)
  {
    strain += strainOf(shape.gradients[a]) * this->displacement_.segment<3>(3 * nodes[a]);
  }
  const Eigen::Matrix<double, 6, 1> s = hooke(this->materials_[static_cast<std::size_t>(tetrahedron)]) * strain;
  Matrix stress;
  stress << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return stress;
}

} // namespace palpate::oracle
