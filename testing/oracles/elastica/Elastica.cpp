// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/elastica/Elastica.h"

#include <cmath>
#include <numbers>

namespace palpate::test
{
namespace
{

/// Where a function that rises is 0, between two numbers.
template<class F>
double rootOf(const F& f, double low, double high)
{
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace

CantileverTip cantileverTip(double load)
{
  const auto clampOf = [](double k) { return std::asin(1.0 / (k * std::numbers::sqrt2)); };
  const double k = rootOf(
    [&](double modulus)
    {
      const double root = std::comp_ellint_1(modulus) - std::ellint_1(modulus, clampOf(modulus));
      return root * root - load;
    },
    0.5 * std::numbers::sqrt2 * (1.0 + 1e-15), 1.0 - 1e-15);
  const double sine = 2.0 * k * k - 1.0;
  CantileverTip tip;
  tip.across = 1.0 - 2.0 * (std::comp_ellint_2(k) - std::ellint_2(k, clampOf(k))) / std::sqrt(load);
  tip.shorter = 1.0 - std::sqrt(2.0 * sine / load);
  tip.angle_rad = std::asin(sine);
  return tip;
}

double columnForce(double shortening)
{
  const double k = rootOf([&](double modulus)
    { return 2.0 - 2.0 * std::comp_ellint_2(modulus) / std::comp_ellint_1(modulus) - shortening; },
    0.0, 1.0 - 1e-12);
  const double root = 2.0 * std::comp_ellint_1(k) / std::numbers::pi;
  return root * root;
}

} // namespace palpate::test
