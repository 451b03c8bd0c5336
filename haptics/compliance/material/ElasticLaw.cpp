// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/material/ElasticLaw.h"

#include <cmath>
#include <sstream>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "haptics/compliance/material/PrincipalStretches.h"

namespace palpate
{
namespace
{

/// A model in principal stretches: the Hessian of the energy in the stretches themselves; and for each pair (i, j), k
/// the third, the stiffness against their shear (flip) and against their rotation (twist).
struct PrincipalHessian
{
  Mat3 scaling;
  Vec3 flip;  ///< of the pair without k
  Vec3 twist; ///< of the pair without k
};

/// Moduli with which the stable neo-Hookean model has Hooke's stiffness at rest.
struct NeoHookeanModuli
{
  explicit NeoHookeanModuli(const ElasticModuli& m)
    : mu(4.0 / 3.0 * m.mu), lambda(m.lambda + 5.0 / 6.0 * m.mu), restVolume(1.0 + 0.75 * mu / lambda)
  {
  }
  double mu;
  double lambda;
  double restVolume; ///< volume at which the volume term alone is at rest, so that the sum is at rest at F = 1
};

Mat3 cofactor(const Mat3& f)
{
  Mat3 c;
  c.col(0) = f.col(1).cross(f.col(2));
  c.col(1) = f.col(2).cross(f.col(0));
  c.col(2) = f.col(0).cross(f.col(1));
  return c;
}

Mat3 rotationOf(const Mat3& f)
{
  const PrincipalStretches p = principalStretches(f);
  return p.u * p.v.transpose();
}

Mat3 hookeStress(const ElasticModuli& m, const Mat3& strain)
{
  return 2.0 * m.mu * strain + m.lambda * strain.trace() * Mat3::Identity();
}

Mat3 smallStrain(const Mat3& f)
{
  return 0.5 * (f + f.transpose()) - Mat3::Identity();
}

double hookeEnergy(const ElasticModuli& m, const Mat3& strain)
{
  const double trace = strain.trace();
  return m.mu * strain.squaredNorm() + 0.5 * m.lambda * trace * trace;
}

double neoHookeanEnergy(const ElasticModuli& moduli, const Mat3& f)
{
  const NeoHookeanModuli m(moduli);
  const double stretch = f.squaredNorm();
  const double volume = f.determinant() - m.restVolume;
  const double rest = 1.0 - m.restVolume;
  return 0.5 * m.mu * (stretch - 3.0 - std::log((stretch + 1.0) / 4.0)) +
         0.5 * m.lambda * (volume * volume - rest * rest);
}

Mat3 neoHookeanStress(const ElasticModuli& moduli, const Mat3& f)
{
  const NeoHookeanModuli m(moduli);
  const double stretch = f.squaredNorm();
  return m.mu * (1.0 - 1.0 / (stretch + 1.0)) * f + m.lambda * (f.determinant() - m.restVolume) * cofactor(f);
}

PrincipalHessian neoHookeanHessian(const ElasticModuli& moduli, const Vec3& s)
{
  const NeoHookeanModuli m(moduli);
  const double stretch = s.squaredNorm() + 1.0;
  const double shear = m.mu * (1.0 - 1.0 / stretch);
  const double pressure = m.lambda * (s.prod() - m.restVolume);
  const Vec3 area(s[1] * s[2], s[2] * s[0], s[0] * s[1]);
  PrincipalHessian h;
  h.scaling = m.lambda * area * area.transpose() + 2.0 * m.mu / (stretch * stretch) * s * s.transpose();
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    h.scaling(k, k) += shear;
    h.scaling(i, j) += pressure * s[k];
    h.scaling(j, i) += pressure * s[k];
    h.flip[k] = shear - pressure * s[k];
    h.twist[k] = shear + pressure * s[k];
  }
  return h;
}

PrincipalHessian coRotationalHessian(const ElasticModuli& m, const Vec3& s)
{
  PrincipalHessian h;
  h.scaling = Mat3::Constant(m.lambda) + 2.0 * m.mu * Mat3::Identity();
  h.flip = Vec3::Constant(2.0 * m.mu);
  const double pressure = 2.0 * m.lambda * (s.sum() - 3.0) - 4.0 * m.mu;
  for (int k = 0; k < 3; ++k)
  {
    // Two stretches that cancel have no rotation of their own: the stiffness is then infinite or is clamped to 0.
    const double both = std::max(s[(k + 1) % 3] + s[(k + 2) % 3], 1e-9);
    h.twist[k] = 2.0 * m.mu + pressure / both;
  }
  return h;
}

Mat3 withoutNegative(const Mat3& symmetric)
{
  if (Eigen::LLT<Mat3>(symmetric).info() == Eigen::Success)
  {
    return symmetric;
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(symmetric);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() * solver.eigenvectors().transpose();
}

StressDerivative derivativeOf(const PrincipalHessian& h)
{
  StressDerivative d;
  d.stretch = withoutNegative(h.scaling);
  d.straight.diagonal() = d.stretch.diagonal();
  d.crossed.setZero();
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const double flip = std::max(h.flip[k], 0.0);
    const double twist = std::max(h.twist[k], 0.0);
    d.straight(i, j) = d.straight(j, i) = 0.5 * (flip + twist);
    d.crossed(i, j) = d.crossed(j, i) = 0.5 * (flip - twist);
  }
  return d;
}

PrincipalHessian hookeHessian(const ElasticModuli& m)
{
  return { Mat3::Constant(m.lambda) + 2.0 * m.mu * Mat3::Identity(), Vec3::Constant(2.0 * m.mu), Vec3::Zero() };
}

std::string saying(const char* before, double value, const char* after)
{
  std::ostringstream words;
  words << before << value << after;
  return words.str();
}

} // namespace

Outcome<ElasticModuli> moduliOf(double young_Pa, double poisson, double unit_m)
{
  if (!(young_Pa > 0.0) || !(young_Pa < 1e12))
  {
    return { {}, saying("Young's modulus is ", young_Pa, " Pa: use a value above 0 and below 1e12 Pa") };
  }
  if (!(poisson >= 0.0) || !(poisson < 0.5))
  {
    return { {}, saying("Poisson's ratio is ", poisson,
                   ": use a value from 0 to below 0.5 (0.49 for a nearly incompressible material)") };
  }
  if (!(unit_m > 0.0) || !std::isfinite(unit_m * unit_m * 1e12) || !(unit_m * unit_m > 0.0))
  {
    return { {},
      saying("A unit of the scene is ", unit_m, " m: use a value above 0 (0.001 for a scene in millimetres)") };
  }
  const double young = young_Pa * unit_m * unit_m;
  return { { young / (2.0 * (1.0 + poisson)), young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)) }, {} };
}

std::string refuseModulus(double young_Pa)
{
  constexpr double least_Pa = 10.0;
  constexpr double most_Pa = 1e12;
  return young_Pa >= least_Pa && young_Pa < most_Pa
           ? ""
           : saying("Young's modulus is ", young_Pa,
               " Pa: use a value from 10 Pa to below 1e12 Pa; soft tissue has 1e3 to 1e6 Pa");
}

double energyDensity(ElasticModel model, const ElasticModuli& moduli, const Mat3& f)
{
  switch (model)
  {
    case ElasticModel::NeoHookean:
      return neoHookeanEnergy(moduli, f);
    case ElasticModel::CoRotational:
      return hookeEnergy(moduli, (principalStretches(f).s - Vec3::Ones()).asDiagonal());
    default:
      return hookeEnergy(moduli, smallStrain(f));
  }
}

Mat3 stressOf(ElasticModel model, const ElasticModuli& moduli, const Mat3& f)
{
  switch (model)
  {
    case ElasticModel::NeoHookean:
      return neoHookeanStress(moduli, f);
    case ElasticModel::CoRotational:
    {
      const Mat3 r = rotationOf(f);
      return r * hookeStress(moduli, r.transpose() * f - Mat3::Identity());
    }
    default:
      return hookeStress(moduli, smallStrain(f));
  }
}

StressDerivative stressDerivative(ElasticModel model, const ElasticModuli& moduli, const Mat3& f)
{
  if (model == ElasticModel::Linear)
  {
    return derivativeOf(hookeHessian(moduli));
  }
  const PrincipalStretches p = principalStretches(f);
  StressDerivative d =
    derivativeOf(model == ElasticModel::NeoHookean ? neoHookeanHessian(moduli, p.s) : coRotationalHessian(moduli, p.s));
  d.u = p.u;
  d.v = p.v;
  return d;
}

} // namespace palpate
