// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/finite/NeoHookeanSolid.h"

#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "testing/oracles/sparse/SymmetricSolve.h"

namespace palpate::oracle
{
namespace
{

Eigen::Matrix3d cross(const Eigen::Vector3d& v)
{
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// Derivative of det F by F.
Eigen::Matrix3d volumeSlope(const Eigen::Matrix3d& f)
{
  Eigen::Matrix3d g;
  g << Eigen::Vector3d(f.col(1)).cross(Eigen::Vector3d(f.col(2))),
    Eigen::Vector3d(f.col(2)).cross(Eigen::Vector3d(f.col(0))),
    Eigen::Vector3d(f.col(0)).cross(Eigen::Vector3d(f.col(1)));
  return g;
}

} // namespace

NeoHookeanSolid::NeoHookeanSolid(
  std::vector<Vector> places, std::vector<std::array<int, 4>> tetrahedra, double young_Pa, double poisson)
  : number_(3 * places.size(), 0)
{
  // The model's own moduli for Lame's mu and lambda at rest (the paper's section 3.4).
  const double lameMu = young_Pa / (2.0 * (1.0 + poisson));
  const double lameLambda = young_Pa * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  this->mu_ = 4.0 / 3.0 * lameMu;
  this->lambda_ = lameLambda + 5.0 / 6.0 * lameMu;
  this->alpha_ = 1.0 + 0.75 * this->mu_ / this->lambda_;
  for (const auto& nodes : tetrahedra)
  {
    Eigen::Matrix4d corners;
    for (int a = 0; a < 4; ++a)
    {
      corners.row(a) << 1.0, places[static_cast<std::size_t>(nodes[static_cast<std::size_t>(a)])].transpose();
    }
    // The functions' coefficients are the inverse's columns.
    const Eigen::Matrix4d inverse = corners.inverse();
    this->tetrahedra_.push_back({ nodes, inverse.bottomRows<3>().transpose(), std::abs(corners.determinant()) / 6.0 });
  }
  this->fix([](int) { return false; });
}

void NeoHookeanSolid::fix(const std::function<bool(int)>& node)
{
  this->free_ = 0;
  for (std::size_t i = 0; i < this->number_.size(); ++i)
  {
    this->number_[i] = node(static_cast<int>(i / 3)) ? -1 : this->free_++;
  }
}

double NeoHookeanSolid::energyDensity(const Matrix& f) const
{
  const double more = f.squaredNorm() + 1.0;
  const double volume = f.determinant() - this->alpha_;
  return 0.5 * this->mu_ * (more - 4.0 - std::log(0.25 * more)) + 0.5 * this->lambda_ * volume * volume;
}

double NeoHookeanSolid::energyUnder(const Eigen::VectorXd& load_N, const Eigen::VectorXd& u) const
{
  double energy = -load_N.dot(u);
  for (const Tetrahedron& t : this->tetrahedra_)
  {
    energy += t.volume * this->energyDensity(this->deformationOf(t, u));
  }
  return energy;
}

NeoHookeanSolid::Matrix NeoHookeanSolid::stressAt(const Matrix& f) const
{
  return this->mu_ * (1.0 - 1.0 / (f.squaredNorm() + 1.0)) * f +
         this->lambda_ * (f.determinant() - this->alpha_) * volumeSlope(f);
}

NeoHookeanSolid::Derivative NeoHookeanSolid::stressDerivative(const Matrix& f) const
{
  using Nine = Eigen::Matrix<double, 9, 1>;
  const double more = f.squaredNorm() + 1.0;
  const Matrix slope = volumeSlope(f);
  const Nine along = Eigen::Map<const Nine>(f.data());
  const Nine volume = Eigen::Map<const Nine>(slope.data());
  Derivative h = this->mu_ * (1.0 - 1.0 / more) * Derivative::Identity() +
                 2.0 * this->mu_ / (more * more) * along * along.transpose() +
                 this->lambda_ * volume * volume.transpose();
  const double pressure = this->lambda_ * (f.determinant() - this->alpha_);
  for (int i = 0; i < 3; ++i)
  {
    // d (f_j x f_k) = - f_k x df_j + f_j x df_k, j and k after i.
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    h.block<3, 3>(3 * i, 3 * j) -= pressure * cross(f.col(k));
    h.block<3, 3>(3 * i, 3 * k) += pressure * cross(f.col(j));
  }
  return h;
}

NeoHookeanSolid::Matrix NeoHookeanSolid::deformationOf(const Tetrahedron& t, const Eigen::VectorXd& u) const
{
  Matrix f = Matrix::Identity();
  for (int a = 0; a < 4; ++a)
  {
    f += u.segment<3>(3 * t.nodes[static_cast<std::size_t>(a)]) * t.gradients.row(a);
  }
  return f;
}

Eigen::VectorXd NeoHookeanSolid::innerForces(
  const Eigen::VectorXd& u, std::vector<Eigen::Triplet<double>>* entries) const
{
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(this->free_);
  for (const Tetrahedron& t : this->tetrahedra_)
  {
    const Matrix f = this->deformationOf(t, u);
    const Eigen::Matrix<double, 3, 4> nodal = t.volume * this->stressAt(f) * t.gradients.transpose();
    Eigen::Matrix<double, 9, 12> by = Eigen::Matrix<double, 9, 12>::Zero(); // F by the nodes' displacements
    for (int a = 0; a < 4; ++a)
    {
      for (int j = 0; j < 3; ++j)
      {
        by.block<3, 3>(3 * j, 3 * a) = t.gradients(a, j) * Matrix::Identity();
      }
    }
    const Eigen::Matrix<double, 12, 12> stiffness =
      entries != nullptr ? Eigen::Matrix<double, 12, 12>(t.volume * by.transpose() * this->stressDerivative(f) * by)
                         : Eigen::Matrix<double, 12, 12>::Zero();
    const auto numberOf = [&](int i)
    { return this->number_[static_cast<std::size_t>(3 * t.nodes[static_cast<std::size_t>(i / 3)] + i % 3)]; };
    for (int i = 0; i < 12; ++i)
    {
      const int row = numberOf(i);
      if (row < 0)
      {
        continue;
      }
      forces[row] += nodal(i % 3, i / 3);
      for (int j = 0; entries != nullptr && j < 12; ++j)
      {
        const int column = numberOf(j);
        if (column >= 0)
        {
          entries->emplace_back(row, column, stiffness(i, j));
        }
      }
    }
  }
  return forces;
}

Eigen::VectorXd NeoHookeanSolid::ofFree(const Eigen::VectorXd& all) const
{
  Eigen::VectorXd free(this->free_);
  for (std::size_t i = 0; i < this->number_.size(); ++i)
  {
    if (this->number_[i] >= 0)
    {
      free[this->number_[i]] = all[static_cast<Eigen::Index>(i)];
    }
  }
  return free;
}

void NeoHookeanSolid::addFree(const Eigen::VectorXd& step, double length, Eigen::VectorXd& u) const
{
  for (std::size_t i = 0; i < this->number_.size(); ++i)
  {
    if (this->number_[i] >= 0)
    {
      u[static_cast<Eigen::Index>(i)] += length * step[this->number_[i]];
    }
  }
}

void NeoHookeanSolid::settle(const Eigen::VectorXd& load_N, Eigen::VectorXd& u) const
{
  constexpr int mostSteps = 60;
  const Eigen::VectorXd load = this->ofFree(load_N);
  for (int i = 0; i < mostSteps; ++i)
  {
    std::vector<Eigen::Triplet<double>> entries;
    const Eigen::VectorXd open = load - this->innerForces(u, &entries);
    if (open.norm() <= 1e-8 * load.norm()) // rounding alone leaves 4e-10 of a small load at a Poisson ratio of .49
    {
      return;
    }
    Eigen::SparseMatrix<double> stiffness(this->free_, this->free_);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd step = solveSymmetric(stiffness, open);
    // As far as it lowers the energy; near the end that is rounding, and the whole step is right.
    const double before = this->energyUnder(load_N, u);
    double slack = 0.0;
    for (const Tetrahedron& t : this->tetrahedra_)
    {
      slack += 1e-15 * t.volume * this->lambda_; // each tetrahedron's energy is rounded so
    }
    double length = 1.0;
    for (; length > 1e-4; length *= 0.5)
    {
      Eigen::VectorXd tried = u;
      this->addFree(step, length, tried);
      if (this->energyUnder(load_N, tried) < before + slack)
      {
        break;
      }
    }
    this->addFree(step, length, u);
  }
  throw std::runtime_error("no equilibrium found");
}

Eigen::VectorXd NeoHookeanSolid::displacementUnder(const Eigen::VectorXd& load_N, int steps) const
{
  Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(this->number_.size()));
  for (int i = 1; i <= steps; ++i)
  {
    this->settle(static_cast<double>(i) / steps * load_N, u);
  }
  return u;
}

} // namespace palpate::oracle
