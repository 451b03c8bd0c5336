// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/ArmMeasures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "haptics/arm/ArmDynamics.h"

namespace palpate
{
namespace
{

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The translational Jacobian of the joints with motors.
PointJacobian drivenOf(const Arm& arm, const Posture& posture) noexcept
{
  const PointJacobian driven = posture.jacobian.topLeftCorner(3, arm.motors());
  return driven;
}

/// The condition number by eigenvalues of J J^T in closed form, a third of the work of a decomposition.
double conditionOfGram(const Mat3& gram, int directions) noexcept
{
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(gram, Eigen::EigenvaluesOnly);
  const double least = solver.eigenvalues()[3 - directions], most = solver.eigenvalues()[2];
  return most > 0.0 && least > 1e-15 * most ? std::sqrt(most / least) : unlimited;
}

void addForces(const Arm& arm, const Eigen::MatrixXd& J, ArmMeasures& measures)
{
  // In motor torques, so that a motor that moves two joints counts for both.
  const JointMatrix gears = arm.gears().topLeftCorner(arm.motors(), arm.motors());
  const Eigen::MatrixXd motorJ = J * gears;
  measures.leastForce_N = unlimited;
  for (int k = 0; k < arm.motors(); ++k)
  {
    const double most_Nm = arm.plan().joints[static_cast<std::size_t>(k)].maxTorque_Nm;
    measures.leastForce_N = std::min(measures.leastForce_N, most_Nm / motorJ.col(k).norm());
  }
}

void addMasses(const Arm& arm, const JointVector& q, const Eigen::MatrixXd& J, ArmMeasures& measures)
{
  const Eigen::MatrixXd inertia = inertiaOf(arm, q).topLeftCorner(arm.motors(), arm.motors());
  const Eigen::LDLT<Eigen::MatrixXd> solver(inertia);
  if (inertia.diagonal().minCoeff() > 0.0 && solver.isPositive())
  {
    const Eigen::MatrixXd mobility = J * solver.solve(J.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> masses(mobility, Eigen::EigenvaluesOnly);
    measures.leastMass_kg = 1.0 / masses.eigenvalues()[J.rows() - 1];
    measures.mostMass_kg = 1.0 / masses.eigenvalues()[0];
  }
}

} // namespace

double conditionOf(const Arm& arm, const Posture& posture) noexcept
{
  if (!posture.exists)
  {
    return unlimited;
  }
  const PointJacobian J = drivenOf(arm, posture);
  return conditionOfGram(J * J.transpose(), std::min(arm.directions(), arm.motors()));
}

double largestForce(const Arm& arm, const Posture& posture, const Vec3& n_D) noexcept
{
  const JointVector torque = arm.motorTorqueOf(arm.torqueOf(posture, { n_D, Vec3::Zero() }));
  double largest = posture.exists ? unlimited : 0.0;
  for (int k = 0; k < arm.motors(); ++k)
  {
    const double most = arm.plan().joints[static_cast<std::size_t>(k)].maxTorque_Nm;
    largest = torque[k] != 0.0 ? std::min(largest, most / std::fabs(torque[k])) : largest;
  }
  return std::min(largest, arm.plan().maxForce_N);
}

ArmMeasures measure(const Arm& arm, const JointVector& q)
{
  ArmMeasures measures;
  const Posture posture = arm.posture(q);
  measures.condition = unlimited;
  if (!posture.exists)
  {
    return measures;
  }
  const auto basis = arm.movedDirections();
  const Eigen::MatrixXd J = basis.transpose() * drivenOf(arm, posture);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J);
  const Eigen::Index directions = svd.singularValues().size();
  measures.singular.head(directions) = svd.singularValues();
  measures.manipulability = svd.singularValues().prod();
  const double least = svd.singularValues()[directions - 1];
  if (!(least > 1e-12 * svd.singularValues()[0]))
  {
    return measures;
  }
  measures.condition = svd.singularValues()[0] / least;
  addForces(arm, J, measures);
  addMasses(arm, q, J, measures);
  return measures;
}

double countStepOf(const Arm& arm, const JointVector& q) noexcept
{
  double step_m = 0.0;
  const ArmJacobian J = arm.jacobian(q);
  for (int k = 0; k < arm.joints(); ++k)
  {
    const double perTurn = arm.plan().joints[static_cast<std::size_t>(k)].countsPerTurn;
    const double count_rad = perTurn > 0.0 ? 2.0 * std::numbers::pi / perTurn : 0.0;
    step_m = std::max(step_m, count_rad * (J.topRows<3>() * arm.gears().col(k)).norm());
  }
  return step_m;
}

} // namespace palpate
