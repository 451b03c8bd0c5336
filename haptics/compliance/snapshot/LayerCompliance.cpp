// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/snapshot/LayerCompliance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace palpate
{
namespace
{

constexpr double leastRadius = 0.02; ///< in thicknesses: below, a layer takes the same off the compliance of any patch
constexpr double mostRadius = 100.0;
constexpr std::size_t steps = 170;
const double logStep = std::log(mostRadius / leastRadius) / static_cast<double>(steps);

/// 8 J_2(s) / s^2, the Hankel transform of the paraboloid: by the integral of the Bessel function, which the
/// trapezoidal rule computes to rounding.
double transformOfPatch(double s)
{
  constexpr int points = 96;
  if (s < 1e-2)
  {
    return 1.0 - s * s / 12.0;
  }
  double sum = 0.0;
  for (int i = 0; i < points; ++i)
  {
    const double angle = std::numbers::pi * (i + 0.5) / points;
    sum += std::cos(2.0 * angle - s * std::sin(angle));
  }
  return 8.0 * sum / points / (s * s);
}

/// 1 less the compliance of a layer, bonded to a rigid base, under a wave of pressure, in terms of a half
/// space (Burmister 1945). `wave`: wave number times the thickness.
double lackOfWave(double wave, double poisson)
{
  const double k = 3.0 - 4.0 * poisson;
  const double e2 = std::exp(-2.0 * wave);
  const double sinh = 0.5 * (1.0 - e2 * e2); // both times exp(-2 wave)
  const double cosh = 0.5 * (1.0 + e2 * e2);
  return 1.0 - (2.0 * k * sinh - 4.0 * wave * e2) / (2.0 * k * cosh + (4.0 * wave * wave + 1.0 + k * k) * e2);
}

/// Share by which the compliance of a patch of tetrahedra with smoothed edges is too small on a half space: on edges of
/// half a patch 2.0 %, of a fifth .2 % (measured against Burmister's layer, and alike for all layers but for rounding).
double lackOfMesh(double edgesOfPatch)
{
  return 0.1 * std::pow(edgesOfPatch, 2.3);
}

/// Catmull and Rom's cubics, linear beyond both ends.
double between(const std::vector<double>& values, double place)
{
  const double last = static_cast<double>(values.size() - 1);
  const double x = std::clamp(place, 0.0, last - 1e-9);
  const auto i = static_cast<std::size_t>(x);
  const double u = x - static_cast<double>(i);
  const double rise0 = i > 0 ? 0.5 * (values[i + 1] - values[i - 1]) : values[1] - values[0];
  const double rise1 = i + 2 < values.size() ? 0.5 * (values[i + 2] - values[i]) : values[i + 1] - values[i];
  const double d = values[i + 1] - values[i];
  return values[i] + u * (rise0 + u * (3.0 * d - 2.0 * rise0 - rise1 + u * (rise0 + rise1 - 2.0 * d)));
}

} // namespace

LayerCompliance::LayerCompliance(double poisson) : lack_(steps + 1, 0.0)
{
  // The patch's transform falls as s^-2.5, its square as s^-5: the truncation error is less than a millionth. Over the
  // root of s, so that the longest waves, the only ones that a thick layer lacks, are sampled closely.
  constexpr double mostWave = 60.0;
  constexpr int waves = 1200;
  const double width = std::sqrt(mostWave) / waves;
  for (int w = 0; w < waves; ++w)
  {
    const double root = width * (w + 0.5);
    const double s = root * root;
    const double q = transformOfPatch(s);
    for (std::size_t i = 0; i <= steps; ++i)
    {
      const double radius = leastRadius * std::exp(logStep * static_cast<double>(i));
      this->lack_[i] += 2.0 * root * width * q * q * lackOfWave(s / radius, poisson) / (std::numbers::pi * radius);
    }
  }
}

double LayerCompliance::lackAt(double radiusInLayers) const
{
  return between(this->lack_, std::log(radiusInLayers / leastRadius) / logStep);
}

double LayerCompliance::of(double radius_u, double stiffening) const
{
  if (stiffening <= 0.0)
  {
    return halfSpaceOfPatch / radius_u - this->lack_.front() * stiffening;
  }
  const double radius = std::clamp(radius_u * stiffening, 1e-9, mostRadius);
  return std::max(halfSpaceOfPatch / radius_u - stiffening * this->lackAt(std::max(radius, leastRadius)), 0.0);
}

double LayerCompliance::stiffeningOf(double radius_u, double found, double edge_u) const
{
  const double compliance = found + halfSpaceOfPatch / radius_u * lackOfMesh(edge_u / radius_u);
  const double lacks = halfSpaceOfPatch / radius_u - compliance;
  if (lacks <= 0.0)
  {
    return lacks / this->lack_.front();
  }
  double low = 0.0;
  double high = mostRadius / radius_u;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (this->of(radius_u, middle) > compliance ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace palpate
