// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/axisymmetric/BallOnLayer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

namespace palpate::oracle
{
namespace
{

using std::numbers::pi;

struct Points
{
  Eigen::VectorXd at;
  Eigen::VectorXd weights;
};

/// Gauss & Legendre's on (0, length), by the eigenvalues of Jacobi's matrix (Golub & Welsch 1969).
Points gaussPoints(int count, double length)
{
  Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(count, count);
  for (int i = 1; i < count; ++i)
  {
    jacobi(i, i - 1) = jacobi(i - 1, i) = i / std::sqrt(4.0 * i * i - 1.0);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi);
  return { (0.5 * length * (solver.eigenvalues().array() + 1.0)).matrix(),
    length * solver.eigenvectors().row(0).transpose().cwiseAbs2() };
}

/// 1 less how much the layer gives to a wave of pressure, in terms of a half space. `wave`: times the thickness.
double lackOf(double wave, double poisson)
{
  const double k = 3.0 - 4.0 * poisson;
  return 1.0 - (2.0 * k * std::sinh(2.0 * wave) - 4.0 * wave) /
                 (2.0 * k * std::cosh(2.0 * wave) + 4.0 * wave * wave + 1.0 + k * k);
}

/// Integral of lackOf(wave) cos(wave y) over all waves, at many y in thicknesses.
class LayerKernel
{
public:
  LayerKernel(double poisson, double most)
  {
    constexpr double lastWave = 25.0; // exp(-50) is left out
    constexpr int perPiece = 12;
    const int pieces = 20 + static_cast<int>(2.0 * most * lastWave / pi);
    const Points one = gaussPoints(perPiece, lastWave / pieces);
    for (int p = 0; p < pieces; ++p)
    {
      for (int i = 0; i < perPiece; ++i)
      {
        this->waves_.push_back(lastWave * p / pieces + one.at[i]);
        this->lacks_.push_back(one.weights[i] * lackOf(this->waves_.back(), poisson));
      }
    }
  }

  [[nodiscard]] double at(double y) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->waves_.size(); ++i)
    {
      sum += this->lacks_[i] * std::cos(this->waves_[i] * y);
    }
    return sum;
  }

private:
  std::vector<double> waves_;
  std::vector<double> lacks_;
};

/// 2 / pi times x / 2 ln((R + x) / (R - x)): Abel's transform of the sphere's gap.
double transformOfSphere(double x, double ball)
{
  return x / pi * std::log((ball + x) / (ball - x));
}

} // namespace

BallContact contactOfRadius(const Layer& layer, double ball_m, double contact_m)
{
  const double h = layer.thickness_m;
  const int count = 24 + static_cast<int>(5.0 * contact_m / h); // the kernel is as narrow as the layer is thick
  const Points points = gaussPoints(count, contact_m);
  const LayerKernel kernel(layer.poisson, 2.0 * contact_m / h);
  const auto coupled = [&](double x, int j)
  {
    const double t = points.at[j];
    return points.weights[j] / (pi * h) * (kernel.at((x + t) / h) + kernel.at((x - t) / h));
  };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(count, count);
  Eigen::MatrixXd right(count, 2); // for a depth of 1, and for the ball
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      matrix(i, j) -= coupled(points.at[i], j);
    }
    right.row(i) << 2.0 / pi, -transformOfSphere(points.at[i], ball_m);
  }
  const Eigen::MatrixXd found = matrix.partialPivLu().solve(right);
  // Pressure ends at 0 where the contact does, which tells its depth.
  Eigen::RowVector2d end(2.0 / pi, -transformOfSphere(contact_m, ball_m));
  for (int j = 0; j < count; ++j)
  {
    end += coupled(contact_m, j) * found.row(j);
  }
  const double depth_m = -end[1] / end[0];
  const double modulus = layer.young_Pa / (1.0 - layer.poisson * layer.poisson);
  return { contact_m, depth_m, pi * modulus * points.weights.dot(depth_m * found.col(0) + found.col(1)) };
}

BallContact contactOfDepth(const Layer& layer, double ball_m, double depth_m)
{
  // Depth goes nearly as the square of the radius, on any layer.
  BallContact contact = contactOfRadius(layer, ball_m, std::sqrt(ball_m * depth_m));
  for (int i = 0; i < 50 && std::abs(contact.depth_m - depth_m) > 1e-10 * depth_m; ++i)
  {
    const double next_m = contact.radius_m * std::sqrt(depth_m / contact.depth_m);
    contact = contactOfRadius(layer, ball_m, std::min(next_m, 0.999 * ball_m));
  }
  return contact;
}

BallContact onHalfSpace(double young_Pa, double poisson, double ball_m, double contact_m)
{
  const double log = std::log((ball_m + contact_m) / (ball_m - contact_m));
  const double modulus = young_Pa / (1.0 - poisson * poisson);
  return { contact_m, 0.5 * contact_m * log,
    0.5 * modulus * ((contact_m * contact_m + ball_m * ball_m) * log - 2.0 * contact_m * ball_m) };
}

} // namespace palpate::oracle
