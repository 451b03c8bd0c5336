// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/compliance/servo/ContactProblem.h"
#include "haptics/compliance/servo/DenseSolve.h"

namespace palpate
{
namespace
{

using Vec2 = Eigen::Vector2d;

constexpr int newtonUpTo = 20; // contacts: sweeps are cheaper from there on

/// The solver's steps on one problem.
class FrictionSteps
{
public:
  FrictionSteps(const ContactProblem& problem, FrictionRoom& room) noexcept : p_(problem), room_(room) {}

  /// One sweep of projected Gauss-Seidel.
  void sweep(ContactProblem::Numbers& f) const noexcept
  {
    for (int c = 0; c < this->p_.count; ++c)
    {
      if (this->normalCompliance(c) <= 0.0)
      {
        continue;
      }
      f[3 * c] = std::max(0.0, f[3 * c] - this->displacement(c, f)[0] / this->normalCompliance(c));
      const Vec3 d = this->displacement(c, f);
      const Vec2 across = f.segment<2>(3 * c + 1) - d.tail<2>() / this->acrossCompliance(c);
      f.segment<2>(3 * c + 1) = inCone(across, this->p_.friction * f[3 * c]);
    }
  }

  /// By how much the laws are not met, in units of displacement; fills room.residual.
  [[nodiscard]] double residual(const ContactProblem::Numbers& f) const noexcept
  {
    this->room_.residual.resize(f.size());
    for (int c = 0; c < this->p_.count; ++c)
    {
      const Vec3 z = this->aim(c, f);
      Vec3 r = f.segment<3>(3 * c);
      r[0] -= std::max(z[0], 0.0);
      r.tail<2>() -= inCone(z.tail<2>(), this->p_.friction * std::max(z[0], 0.0));
      r[0] *= this->normalCompliance(c);
      r.tail<2>() *= this->acrossCompliance(c);
      this->room_.residual.segment<3>(3 * c) = r;
    }
    return this->room_.residual.size() > 0 ? this->room_.residual.lpNorm<Eigen::Infinity>() : 0.0;
  }

  /// One Newton step with a line search; false if it does not help. room.residual is that of f.
  [[nodiscard]] bool newton(ContactProblem::Numbers& f, double& residual) const noexcept
  {
    this->room_.jacobian.resize(f.size(), f.size());
    for (int c = 0; c < this->p_.count; ++c)
    {
      this->linearise(c, f);
    }
    this->room_.step = -this->room_.residual;
    if (!solveInPlace(this->room_.jacobian, this->room_.step))
    {
      return false;
    }
    for (double length = 1.0; length > 1e-3; length *= 0.5)
    {
      this->room_.trial = f + length * this->room_.step;
      if (const double now = this->residual(this->room_.trial); now < residual)
      {
        f = this->room_.trial;
        residual = now;
        return true;
      }
    }
    return false;
  }

  void project(ContactProblem::Numbers& f) const noexcept
  {
    for (int c = 0; c < this->p_.count; ++c)
    {
      f[3 * c] = std::max(f[3 * c], 0.0);
      f.segment<2>(3 * c + 1) = inCone(f.segment<2>(3 * c + 1), this->p_.friction * f[3 * c]);
    }
  }

private:
  [[nodiscard]] static Vec2 inCone(const Vec2& across, double most) noexcept
  {
    const double length = across.norm();
    return length > most ? Vec2(across * (most / length)) : across;
  }
  [[nodiscard]] double normalCompliance(int c) const noexcept { return this->p_.compliance(3 * c, 3 * c); }
  [[nodiscard]] double acrossCompliance(int c) const noexcept
  {
    return 0.5 * (this->p_.compliance(3 * c + 1, 3 * c + 1) + this->p_.compliance(3 * c + 2, 3 * c + 2));
  }
  [[nodiscard]] Vec3 displacement(int c, const ContactProblem::Numbers& f) const noexcept
  {
    Vec3 d = this->p_.free.segment<3>(3 * c);
    for (int j = 0; j < this->p_.count; ++j)
    {
      d += this->p_.compliance.block<3, 3>(3 * c, 3 * j) * f.segment<3>(3 * j);
    }
    return d;
  }
  /// The force that the laws would make of the displacement.
  [[nodiscard]] Vec3 aim(int c, const ContactProblem::Numbers& f) const noexcept
  {
    const Vec3 d = this->displacement(c, f);
    const Vec3 per(1.0 / this->normalCompliance(c), 1.0 / this->acrossCompliance(c), 1.0 / this->acrossCompliance(c));
    return f.segment<3>(3 * c) - per.cwiseProduct(d);
  }

  /// Rows of the derivative of residual() for one contact.
  void linearise(int c, const ContactProblem::Numbers& f) const noexcept
  {
    const Vec3 z = this->aim(c, f);
    const double wn = this->normalCompliance(c);
    const double wt = this->acrossCompliance(c);
    auto rows = this->room_.jacobian.middleRows<3>(3 * c);
    rows.setZero();
    if (z[0] <= 0.0)
    {
      rows.block<3, 3>(0, 3 * c) = Vec3(wn, wt, wt).asDiagonal();
      return;
    }
    const auto w = this->p_.compliance.middleRows<3>(3 * c);
    rows.row(0) = w.row(0);
    const double most = this->p_.friction * z[0];
    const double length = z.tail<2>().norm();
    if (length <= most)
    {
      rows.bottomRows<2>() = w.bottomRows<2>();
      return;
    }
    // wt (f_t - mu z_n e): e = z_t / |z_t|, dz_n = df_n - w_n df / wn, dz_t = df_t - w_t df / wt.
    const Vec2 e = z.tail<2>() / length;
    const Eigen::Matrix2d bend = most / length * (Eigen::Matrix2d::Identity() - e * e.transpose());
    for (int k = 0; k < 2; ++k)
    {
      rows.row(1 + k) = wt * this->p_.friction * e[k] / wn * w.row(0) + bend(k, 0) * w.row(1) + bend(k, 1) * w.row(2);
    }
    rows.block<2, 1>(1, 3 * c) -= wt * this->p_.friction * e;
    rows.block<2, 2>(1, 3 * c + 1) += wt * (Eigen::Matrix2d::Identity() - bend);
  }

  const ContactProblem& p_;
  FrictionRoom& room_;
};

} // namespace

void solveFriction(const ContactProblem& problem, FrictionRoom& room, ContactForces& forces) noexcept
{
  const FrictionSteps steps(problem, room);
  ContactProblem::Numbers& f = forces.force_N;
  // What rounding leaves of the largest number in the problem.
  const double enough = problem.count > 0 ? 1e-15 * problem.free.lpNorm<Eigen::Infinity>() : 0.0;
  const bool newton = problem.count <= newtonUpTo;
  double least = std::numeric_limits<double>::infinity();
  forces.steps = 0;
  room.best = f;
  for (int round = 0; round < (newton ? 6 : 1) && least > enough; ++round)
  {
    for (int i = 0; i < (newton ? (round == 0 ? 4 : 40) : 150); ++i)
    {
      steps.sweep(f);
    }
    double residual = steps.residual(f);
    for (int i = 0; newton && i < 20 && residual > enough && steps.newton(f, residual); ++i)
    {
      ++forces.steps;
    }
    steps.project(f);
    if (residual = steps.residual(f); residual < least)
    {
      least = residual;
      room.best = f;
    }
  }
  f = room.best;
  forces.residual_u = least;
}

} // namespace palpate
