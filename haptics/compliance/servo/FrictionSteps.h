// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/compliance/servo/ContactProblem.h"
#include "haptics/compliance/servo/DenseSolve.h"

namespace palpate
{

/// The solver's steps on one problem. room.moved is kept at free + compliance force.
class FrictionSteps
{
  using Vec2 = Eigen::Vector2d;

public:
  FrictionSteps(const ContactProblem& problem, FrictionScratch& room, bool inARow = false) noexcept
    : p_(problem), room_(room), inARow_(inARow)
  {
  }

  /// One sweep of projected Gauss-Seidel over all contacts but `without`; room.moved belongs to f before and after.
  void sweep(ContactProblem::Numbers& f, int without) const noexcept
  {
    for (int c = 0; c < this->p_.count; ++c)
    {
      const double normal = this->normalCompliance(c);
      if (normal <= 0.0 || c == without)
      {
        continue;
      }
      const auto columns = this->p_.compliance.middleCols<3>(3 * c);
      const Vec3 before = f.segment<3>(3 * c);
      Vec3 after = before;
      after[0] = std::max(0.0, before[0] - this->room_.moved[3 * c] / normal);
      const Vec2 moved = this->room_.moved.segment<2>(3 * c + 1) +
                         (after[0] - before[0]) * columns.middleRows<3>(3 * c).col(0).tail<2>();
      after.tail<2>() = inCone(before.tail<2>() - moved / this->acrossCompliance(c), this->p_.friction * after[0]);
      if (after != before)
      {
        f.segment<3>(3 * c) = after;
        this->room_.moved += columns.lazyProduct(after - before);
      }
    }
  }

  /// Computes room.moved anew, without accumulated rounding.
  void move(const ContactProblem::Numbers& f) const noexcept
  {
    this->room_.moved = this->p_.free;
    for (int c = 0; c < this->p_.count; ++c)
    {
      if (const Vec3 force = f.segment<3>(3 * c); force != Vec3::Zero())
      {
        this->room_.moved += this->p_.compliance.middleCols<3>(3 * c).lazyProduct(force);
      }
    }
  }

  /// Residual of the laws in units of displacement; fills room.moved and room.residual.
  [[nodiscard]] double residual(const ContactProblem::Numbers& f) const noexcept
  {
    this->move(f);
    this->room_.residual.resize(f.size());
    for (int c = 0; c < this->p_.count; ++c)
    {
      const Vec3 z = this->aim(c, f);
      Vec3 r = f.segment<3>(3 * c);
      r[0] -= std::max(z[0], 0.0);
      r.tail<2>() -= inCone(z.tail<2>(), this->p_.friction * std::max(z[0], 0.0));
      r[0] *= this->normalAim(c);
      r.tail<2>() *= this->acrossAim(c);
      this->room_.residual.segment<3>(3 * c) = r;
    }
    return this->room_.residual.size() > 0 ? this->room_.residual.lpNorm<Eigen::Infinity>() : 0.0;
  }

  /// One Newton step: the longest part of it, by halves, whose residual is below `most`. Without one it is not taken
  /// and the answer is false; but where `most` is above the present residual the best part is. room.moved and
  /// room.residual belong to f.
  [[nodiscard]] bool newton(ContactProblem::Numbers& f, double& residual, double most) noexcept
  {
    this->findPressed(f);
    this->linearise(f);
    if (!solveInPlace(this->room_.jacobian, this->room_.part))
    {
      return false;
    }
    this->room_.step = -f; // for contacts that open
    for (int a = 0; a < this->pressed_; ++a)
    {
      this->room_.step.segment<3>(3 * this->list_[a]) = this->room_.part.segment<3>(3 * a);
    }
    this->tried_ = 0;
    double best = 0.0, least = std::numeric_limits<double>::infinity();
    for (double length = 1.0; length > 1e-3 && !(least < most); length *= 0.5, ++this->tried_)
    {
      this->room_.trial = f + length * this->room_.step;
      if (const double now = this->residual(this->room_.trial); now < least)
      {
        least = now;
        best = length;
      }
    }
    if (!(least < most) && !(most > residual && best > 0.0))
    {
      return false;
    }
    this->room_.trial = f + best * this->room_.step;
    f = this->room_.trial;
    residual = least < most ? least : this->residual(f);
    return true;
  }

  /// Derivative of forces f, which meet the laws, by small displacements, a column each, while each contact stays open,
  /// stuck or slipping.
  [[nodiscard]] bool answer(const ContactProblem::Numbers& f, const Eigen::Ref<const Eigen::MatrixXd>& displaced,
    Eigen::Ref<Eigen::MatrixXd> answer) noexcept
  {
    (void)this->residual(f);
    this->findPressed(f);
    this->linearise(f);
    for (int a = 0; a < this->pressed_; ++a)
    {
      const int c = this->list_[a];
      const Mat3 ofMoved = this->lawAt(c, f).ofMoved;
      for (Eigen::Index w = 0; w < displaced.cols(); ++w)
      {
        answer.col(w).segment<3>(3 * a) = -(ofMoved * displaced.col(w).segment<3>(3 * c));
      }
    }
    auto part = answer.topRows(3 * this->pressed_);
    const bool regular = solveInPlace(this->room_.jacobian, part);
    for (int c = this->p_.count - 1, a = this->pressed_ - 1; c >= 0; --c) // each to its own rows, from the last on
    {
      const bool presses = regular && a >= 0 && this->list_[a] == c;
      for (Eigen::Index w = 0; w < answer.cols(); ++w)
      {
        const Vec3 own = presses ? Vec3(answer.col(w).segment<3>(3 * a)) : Vec3(Vec3::Zero());
        answer.col(w).segment<3>(3 * c) = own;
      }
      a -= presses ? 1 : 0;
    }
    return regular;
  }

  void project(ContactProblem::Numbers& f) const noexcept
  {
    for (int c = 0; c < this->p_.count; ++c)
    {
      f[3 * c] = std::max(f[3 * c], 0.0);
      f.segment<2>(3 * c + 1) = inCone(f.segment<2>(3 * c + 1), this->p_.friction * f[3 * c]);
    }
  }

  void aimBy(double share) noexcept { this->share_ = share; }
  [[nodiscard]] int pressed() const noexcept { return this->pressed_; }
  /// Parts of the last step whose residual was looked at.
  [[nodiscard]] int tried() const noexcept { return this->tried_; }

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
  /// Compliances by which forces follow displacements in aim(). For contacts in a row they are much smaller than the
  /// contact's own, by which Newton steps take many more contacts to press than do.
  [[nodiscard]] double normalAim(int c) const noexcept
  {
    return this->inARow_ ? this->share_ * this->normalCompliance(c) : this->normalCompliance(c);
  }
  [[nodiscard]] double acrossAim(int c) const noexcept
  {
    return this->inARow_ ? this->share_ * this->p_.compliance.diagonal().segment<2>(3 * c + 1).minCoeff()
                         : this->acrossCompliance(c);
  }
  /// The force before its projection onto the laws: the present force less the displacement over the compliance.
  [[nodiscard]] Vec3 aim(int c, const ContactProblem::Numbers& f) const noexcept
  {
    const Vec3 per(1.0 / this->normalAim(c), 1.0 / this->acrossAim(c), 1.0 / this->acrossAim(c));
    return f.segment<3>(3 * c) - per.cwiseProduct(this->room_.moved.segment<3>(3 * c));
  }

  /// Finds the contacts that the laws press: the others open, so that their step is known.
  void findPressed(const ContactProblem::Numbers& f) noexcept
  {
    this->pressed_ = 0;
    for (int c = 0; c < this->p_.count; ++c)
    {
      if (this->aim(c, f)[0] > 0.0)
      {
        this->list_[this->pressed_++] = c;
      }
    }
  }

  /// Derivative of residual() by the forces of the pressed contacts, and the right-hand side for their step.
  void linearise(const ContactProblem::Numbers& f) const noexcept
  {
    this->room_.jacobian.resize(3 * this->pressed_, 3 * this->pressed_);
    this->room_.part.resize(3 * this->pressed_);
    for (int a = 0; a < this->pressed_; ++a)
    {
      const int c = this->list_[a];
      const Law law = this->lawAt(c, f);
      Vec3 right = -this->room_.residual.segment<3>(3 * c);
      for (int d = 0, b = 0; d < this->p_.count; ++d)
      {
        Mat3 block = law.ofMoved * this->p_.compliance.block<3, 3>(3 * c, 3 * d);
        if (d == c)
        {
          block += law.ofForce;
        }
        if (b < this->pressed_ && this->list_[b] == d)
        {
          this->room_.jacobian.block<3, 3>(3 * a, 3 * b++) = block;
        }
        else
        {
          right += block * f.segment<3>(3 * d);
        }
      }
      this->room_.part.segment<3>(3 * a) = right;
    }
  }

  /// Derivatives of a pressed contact's residual by its displacement and by its own force.
  struct Law
  {
    Mat3 ofMoved = Mat3::Identity();
    Mat3 ofForce = Mat3::Zero();
  };

  [[nodiscard]] Law lawAt(int c, const ContactProblem::Numbers& f) const noexcept
  {
    Law law;
    const Vec3 z = this->aim(c, f);
    const double most = this->p_.friction * z[0];
    const double length = z.tail<2>().norm();
    if (length <= most)
    {
      return law;
    }
    // wt (f_t - mu z_n e): e = z_t / |z_t|, dz_n = df_n - dd_n / wn, dz_t = df_t - dd_t / wt.
    const double wt = this->acrossAim(c);
    const Vec2 e = z.tail<2>() / length;
    const Eigen::Matrix2d bend = most / length * (Eigen::Matrix2d::Identity() - e * e.transpose());
    law.ofMoved.block<2, 1>(1, 0) = wt * this->p_.friction / this->normalAim(c) * e;
    law.ofMoved.block<2, 2>(1, 1) = bend;
    law.ofForce.block<2, 1>(1, 0) = -wt * this->p_.friction * e;
    law.ofForce.block<2, 2>(1, 1) = wt * (Eigen::Matrix2d::Identity() - bend);
    return law;
  }

  const ContactProblem& p_;
  FrictionScratch& room_;
  bool inARow_;
  double share_ = 1.0; ///< of contacts' compliance in aim(), in a row
  std::array<int, ContactProblem::most> list_{};
  int pressed_ = 0;
  int tried_ = 0;
};

} // namespace palpate
