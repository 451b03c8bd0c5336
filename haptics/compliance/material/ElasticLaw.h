// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "haptics/core/Outcome.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// Constitutive models. F is the deformation gradient, 1 at rest.
enum class ElasticModel : std::uint8_t
{
  Linear,       ///< Hooke's law of small strains; a rotation strains it
  CoRotational, ///< Hooke's law in the rotated frame; softens under compression
  NeoHookean,   ///< stable neo-Hookean (Smith, de Goes & Kim 2018): finite for every F, its Hessian at rest is Hooke's
};

/// Lame's moduli [N/u^2]: pascal where a unit of the scene is a metre.
struct ElasticModuli
{
  double mu = 0.0;
  double lambda = 0.0;
};

/// From Young's modulus [Pa] and Poisson's ratio, `unit_m`: metres per unit of the scene. Refuses values of no solid: a
/// modulus that is not above 0 or from 1e12 Pa on (diamond), a ratio below 0 or from .5 on; and a unit that is no
/// length.
[[nodiscard]] Outcome<ElasticModuli> moduliOf(double young_Pa, double poisson, double unit_m);

/// Empty, or why no body may have this modulus [Pa]: from 10 Pa, below which no solid holds together, to below 1e12 Pa
/// (diamond). A modulus typed in another unit is outside.
[[nodiscard]] std::string refuseModulus(double young_Pa);

/// Energy per volume [N/u^2], 0 at rest.
[[nodiscard]] double energyDensity(ElasticModel model, const ElasticModuli& moduli, const Mat3& f);

/// First Piola-Kirchhoff stress P = d energy / dF [N/u^2].
[[nodiscard]] Mat3 stressOf(ElasticModel model, const ElasticModuli& moduli, const Mat3& f);

/// dP/dF [N/u^2] in the frames of the principal stretches, where few of its 81 numbers are not 0. Negative eigenvalues
/// are set to 0, so that a Newton step descends: by the signed singular values (Smith, de Goes & Kim 2019, "Analytic
/// eigensystems").
struct StressDerivative
{
  Mat3 u = Mat3::Identity(); ///< F = u s v^T
  Mat3 v = Mat3::Identity();
  Mat3 stretch;  ///< of stress i by stretch k
  Mat3 straight; ///< of component ij by component ij of F; the diagonal is that of `stretch`
  Mat3 crossed;  ///< of component ij by component ji

  /// Sum over j, l of a_j (dP_ij / dF_kl) b_l, for two gradients that v^T has rotated.
  [[nodiscard]] Mat3 between(const Vec3& a, const Vec3& b) const
  {
    Mat3 inFrame = this->stretch.cwiseProduct(a * b.transpose()) + this->crossed.cwiseProduct(b * a.transpose());
    inFrame.diagonal() = this->straight * a.cwiseProduct(b);
    return this->u * inFrame * this->u.transpose();
  }
};

[[nodiscard]] StressDerivative stressDerivative(ElasticModel model, const ElasticModuli& moduli, const Mat3& f);

} // namespace palpate
