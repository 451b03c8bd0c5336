// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/force/SampledWall.h"

#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "haptics/force/LinearPlant.h"

namespace palpate
{
namespace
{

/// The loop's matrix for a stiffness is base + K perStiffness. State: x, v, x one tick ago, ..., x d + 1 ticks ago.
class ClosedLoop
{
public:
  explicit ClosedLoop(const SampledWall& wall)
  {
    const LinearPlant plant(wall.mass_kg, wall.damping_Ns_per_m, wall.handStiffness_N_per_m, wall.period_s);
    const int size = wall.delay_ticks + 3;
    this->base_ = Eigen::MatrixXd::Zero(size, size);
    this->base_.topLeftCorner<2, 2>() = plant.free();
    this->base_(2, 0) = 1.0;
    for (int k = 3; k < size; ++k)
    {
      this->base_(k, k - 1) = 1.0;
    }
    const int delayed = wall.delay_ticks == 0 ? 0 : wall.delay_ticks + 1, before = wall.delay_ticks + 2;
    Eigen::RowVectorXd damper = Eigen::RowVectorXd::Zero(size); // backward difference times a period
    damper(delayed) = 1.0;
    damper(before) = -1.0;
    Eigen::RowVectorXd spring = wall.leadPeriods * damper;
    spring(delayed) += 1.0;
    this->base_.topRows<2>() -= plant.held() * (wall.virtualDamping_Ns_per_m / wall.period_s) * damper;
    this->perStiffness_ = Eigen::MatrixXd::Zero(size, size);
    this->perStiffness_.topRows<2>() = -plant.held() * spring;
  }

  [[nodiscard]] double radius(double stiffness_N_per_m) const
  {
    const Eigen::MatrixXd loop = this->base_ + stiffness_N_per_m * this->perStiffness_;
    return Eigen::EigenSolver<Eigen::MatrixXd>(loop, false).eigenvalues().cwiseAbs().maxCoeff();
  }

  [[nodiscard]] bool isStable(double stiffness_N_per_m) const
  {
    constexpr double rounding = 1e-12;
    return this->radius(stiffness_N_per_m) < 1.0 + rounding;
  }

private:
  Eigen::MatrixXd base_, perStiffness_;
};

} // namespace

double spectralRadius(const SampledWall& wall, double stiffness_N_per_m)
{
  return ClosedLoop(wall).radius(stiffness_N_per_m);
}

double criticalStiffness(const SampledWall& wall)
{
  constexpr double least = 1e-3, most = 1e8, factor = 1.02;
  const ClosedLoop loop(wall);
  double low = least;
  while (low < most && !loop.isStable(low))
  {
    low *= factor;
  }
  if (low >= most)
  {
    return 0.0;
  }
  double high = low * factor;
  while (high < most && loop.isStable(high))
  {
    low = high;
    high *= factor;
  }
  if (high >= most)
  {
    return std::numeric_limits<double>::infinity();
  }
  for (int halving = 0; halving < 60; ++halving)
  {
    const double middle = 0.5 * (low + high);
    (loop.isStable(middle) ? low : high) = middle;
  }
  return low;
}

} // namespace palpate
