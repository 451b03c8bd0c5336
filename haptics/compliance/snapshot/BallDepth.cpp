// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/snapshot/BallDepth.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{

/// Factor on the paraboloid's compliance with which a ball in a half space is as deep as by Hertz.
constexpr double ofHertz = 0.9978;
/// Largest width of a contact, in radii of the ball.
constexpr double mostOfBall = 0.95;
/// Number of contact widths, from a fiftieth of the widest on.
constexpr std::size_t contacts = 96;
constexpr double leastContact = 0.02;

/// Mean gap between a sphere and a patch of radius c of its own, with the paraboloid's weights, in radii:
/// the integral of 2 (1 - x / c^2) (1 - sqrt(1 - x)) / c^2 over x up to c^2. By a series where that cancels.
double gapOfSphere(double c)
{
  const double c2 = c * c;
  if (c2 < 0.01)
  {
    return c2 / 6.0 + c2 * c2 / 48.0 + c2 * c2 * c2 / 160.0;
  }
  const double rest = 1.0 - c2;
  const double root3 = rest * std::sqrt(rest);
  // Integrals of sqrt(1 - x) and of x sqrt(1 - x) from 0 to c^2.
  const double plain = 2.0 / 3.0 * (1.0 - root3);
  const double first = 4.0 / 15.0 - root3 * (2.0 / 3.0 - 0.4 * rest);
  return 1.0 - 2.0 / c2 * (plain - first / c2);
}

/// Monotone cubics (Fritsch & Carlson 1980) of the stiffening over the logarithm of the radius, level at both ends.
class Stiffening
{
public:
  void add(double logRadius, double value)
  {
    this->x_.push_back(logRadius);
    this->y_.push_back(value);
  }

  [[nodiscard]] double at(double logRadius) const
  {
    const auto above = std::upper_bound(this->x_.begin(), this->x_.end(), logRadius);
    if (above == this->x_.begin() || above == this->x_.end())
    {
      return above == this->x_.begin() ? this->y_.front() : this->y_.back();
    }
    const auto i = static_cast<std::size_t>(above - this->x_.begin()) - 1;
    const double h = this->x_[i + 1] - this->x_[i];
    const double u = (logRadius - this->x_[i]) / h;
    const double d = this->y_[i + 1] - this->y_[i];
    const double begins = h * this->rise(i);
    const double ends = h * this->rise(i + 1);
    return this->y_[i] + u * (begins + u * (3.0 * d - 2.0 * begins - ends + u * (begins + ends - 2.0 * d)));
  }

private:
  [[nodiscard]] double secant(std::size_t i) const
  {
    return (this->y_[i + 1] - this->y_[i]) / (this->x_[i + 1] - this->x_[i]);
  }
  [[nodiscard]] double rise(std::size_t i) const
  {
    if (i == 0 || i + 1 == this->x_.size() || this->secant(i - 1) * this->secant(i) <= 0.0)
    {
      return 0.0;
    }
    return 2.0 / (1.0 / this->secant(i - 1) + 1.0 / this->secant(i));
  }

  std::vector<double> x_;
  std::vector<double> y_;
};

} // namespace

BallDepth::BallDepth(
  const LayerCompliance& layer, double ball_u, double modulus, double edge_u, const std::vector<PatchRung>& rungs)
  : patch_(rungs.back().compliance)
{
  this->law_.hertz = std::cbrt(9.0 / (16.0 * modulus * modulus * ball_u));
  this->law_.patch = halfSpaceOfPatch / (modulus * rungs.back().radius_u);
  Stiffening stiffening;
  for (const PatchRung& rung : rungs)
  {
    const double found = layer.stiffeningOf(rung.radius_u, modulus * rung.compliance, edge_u);
    stiffening.add(std::log(rung.radius_u), found);
  }
  const auto complianceOf = [&](double a) { return ofHertz / modulus * layer.of(a, stiffening.at(std::log(a))); };
  const double widest_u = std::min(rungs.back().radius_u, mostOfBall * ball_u);
  this->root_.push_back(0.0);
  this->depth_u_.push_back(0.0);
  this->width_u_.push_back(0.0);
  for (std::size_t i = 0; i <= contacts; ++i)
  {
    const double a =
      widest_u * std::pow(leastContact, static_cast<double>(contacts - i) / static_cast<double>(contacts));
    constexpr double aside = 1e-3; // a central difference of smooth functions: 1e-6 of the slope
    const double falls = complianceOf(a * (1.0 - aside)) - complianceOf(a * (1.0 + aside));
    const double opens = ball_u * (gapOfSphere(a * (1.0 + aside) / ball_u) - gapOfSphere(a * (1.0 - aside) / ball_u));
    const double force_N = 2.0 * opens / falls;
    const double depth_u = complianceOf(a) * force_N + ball_u * gapOfSphere(a / ball_u);
    // Where the compliance does not fall with the radius, the contact grows at once: both stay as they were.
    if (falls > 0.0 && std::cbrt(force_N) > this->root_.back() && depth_u > this->depth_u_.back())
    {
      this->root_.push_back(std::cbrt(force_N));
      this->depth_u_.push_back(depth_u);
      this->width_u_.push_back(a);
    }
  }
}

double BallDepth::contactUnder(double force_N) const
{
  const double root = std::cbrt(force_N);
  const auto above = std::upper_bound(this->root_.begin() + 1, this->root_.end() - 1, root);
  const auto i = static_cast<std::size_t>(above - this->root_.begin());
  const double share = (root - this->root_[i - 1]) / (this->root_[i] - this->root_[i - 1]);
  return this->width_u_[i - 1] + share * (this->width_u_[i] - this->width_u_[i - 1]);
}

double BallDepth::beyondPatch(double root) const
{
  const auto above = std::upper_bound(this->root_.begin() + 1, this->root_.end() - 1, root);
  const auto i = static_cast<std::size_t>(above - this->root_.begin());
  // Between contacts the depth is interpolated over the square of the root, which is true for short steps.
  const double from = this->root_[i - 1] * this->root_[i - 1];
  const double to = this->root_[i] * this->root_[i];
  const double share = (root * root - from) / (to - from);
  return this->depth_u_[i - 1] + share * (this->depth_u_[i] - this->depth_u_[i - 1]) -
         this->patch_ * root * root * root;
}

SubgridSpring BallDepth::springOf(double step) const
{
  SubgridSpring spring = this->law_;
  spring.step = step;
  const double aside = 0.02 * step;
  for (std::size_t k = 1; k < SubgridSpring::knots; ++k)
  {
    const double root = step * static_cast<double>(k);
    spring.depth_u[k] = std::max(this->beyondPatch(root), spring.depth_u[k - 1]);
    spring.rise[k] = std::max((this->beyondPatch(root + aside) - this->beyondPatch(root - aside)) / (2.0 * aside), 0.0);
  }
  // A cubic rises where its ends do, with slopes of at most three times the secant; without limit at the first knot,
  // where it has to begin as t^2.
  for (std::size_t k = 1; k < SubgridSpring::knots; ++k)
  {
    const double before = (spring.depth_u[k] - spring.depth_u[k - 1]) / step;
    const double after = k + 1 < SubgridSpring::knots ? (spring.depth_u[k + 1] - spring.depth_u[k]) / step : before;
    spring.rise[k] = std::min(spring.rise[k], 3.0 * std::min(before, after));
  }
  return spring;
}

} // namespace palpate
