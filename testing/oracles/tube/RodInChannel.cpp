// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/tube/RodInChannel.h"

#include <algorithm>
#include <cmath>

namespace palpate::test
{
namespace
{

constexpr double wall_N_per_mm = 2000.0; // of a joint
constexpr double smooth_mm = 5e-4;       // slip below which friction is less than Coulomb's

Eigen::Vector2d turned(const Eigen::Vector2d& d)
{
  return { -d.y(), d.x() };
}

} // namespace

RodInChannel::RodInChannel(const Form& form) : form_(form), piece_mm_(form.length_mm / form.pieces)
{
  const int joints = form.pieces + 1;
  this->at_.setZero(2 * joints);
  for (int i = 0; i < joints; ++i)
  {
    this->at_[2 * i] = -form.length_mm + this->piece_mm_ * i;
  }
  this->before_ = this->at_;
}

RodInChannel::Wall RodInChannel::wallAt(const Eigen::Vector2d& p) const
{
  const Eigen::Vector2d middle(this->form_.first_mm, this->form_.middle_mm);
  const Eigen::Vector2d from = p - middle;
  const Eigen::Vector2d last(std::cos(this->form_.angle_rad), std::sin(this->form_.angle_rad));
  const bool bends = this->form_.angle_rad > 0.0 && (p.x() > this->form_.first_mm || from.y() > 0.0);
  double off_mm = p.y(), bends_per_mm = 0.0;
  Eigen::Vector2d up = Eigen::Vector2d::UnitY();
  if (bends && from.dot(last) > 0.0 && from.dot(turned(last)) < 0.0)
  {
    up = turned(last);
    off_mm = this->form_.middle_mm + from.dot(up);
  }
  else if (bends)
  {
    off_mm = this->form_.middle_mm - from.norm();
    up = -from.normalized();
    bends_per_mm = -1.0 / from.norm();
  }
  const double side = off_mm > 0.0 ? 1.0 : -1.0;
  return { std::abs(off_mm) - this->form_.clearance_mm, side * up, side * bends_per_mm };
}

double& RodInChannel::band(int row, int column)
{
  return this->band_(row, column - row + half);
}

void RodInChannel::addBlock(int row, int column, const Eigen::Matrix2d& block)
{
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      this->band(2 * row + i, 2 * column + j) += block(i, j);
    }
  }
}

void RodInChannel::addPieces()
{
  const double h = this->piece_mm_;
  for (int i = 0; i < this->form_.pieces; ++i)
  {
    const Eigen::Vector2d d = this->at_.segment<2>(2 * i + 2) - this->at_.segment<2>(2 * i);
    const double l = d.norm();
    const Eigen::Vector2d t = d / l;
    const Eigen::Vector2d pull = this->form_.stretch_N * (l / h - 1.0) * t;
    this->force_.segment<2>(2 * i) += pull;
    this->force_.segment<2>(2 * i + 2) -= pull;
    const Eigen::Matrix2d along = t * t.transpose();
    const Eigen::Matrix2d k =
      this->form_.stretch_N * (along / h + (1.0 / h - 1.0 / l) * (Eigen::Matrix2d::Identity() - along));
    this->addBlock(i, i, k);
    this->addBlock(i + 1, i + 1, k);
    this->addBlock(i, i + 1, -k);
    this->addBlock(i + 1, i, -k);
  }
}

/// Energy E I / (2 h) of the squared angle between two pieces.
void RodInChannel::addJoints()
{
  const double k = this->form_.bend_Nmm2 / this->piece_mm_;
  for (int i = 1; i < this->form_.pieces; ++i)
  {
    const Eigen::Vector2d d1 = this->at_.segment<2>(2 * i) - this->at_.segment<2>(2 * i - 2);
    const Eigen::Vector2d d2 = this->at_.segment<2>(2 * i + 2) - this->at_.segment<2>(2 * i);
    const double angle = std::atan2(d1.x() * d2.y() - d1.y() * d2.x(), d1.dot(d2));
    const Eigen::Vector2d g1 = turned(d1) / d1.squaredNorm(), g2 = turned(d2) / d2.squaredNorm();
    const auto second = [](const Eigen::Vector2d& d)
    {
      const double xy = 2.0 * d.x() * d.y(), off = d.y() * d.y() - d.x() * d.x();
      return Eigen::Matrix2d((Eigen::Matrix2d() << xy, off, off, -xy).finished() / (d.squaredNorm() * d.squaredNorm()));
    };
    // The angle is that of d2 less that of d1; d1 falls with the first joint, d2 grows with the last one.
    const Eigen::Vector2d g[3] = { g1, Eigen::Vector2d(-g1 - g2), g2 };
    const Eigen::Matrix2d h1 = second(d1), h2 = second(d2), none = Eigen::Matrix2d::Zero();
    const Eigen::Matrix2d h[3][3] = { { -h1, h1, none }, { h1, h2 - h1, -h2 }, { none, -h2, h2 } };
    for (int a = 0; a < 3; ++a)
    {
      this->force_.segment<2>(2 * (i - 1 + a)) -= k * angle * g[a];
      for (int b = 0; b < 3; ++b)
      {
        this->addBlock(i - 1 + a, i - 1 + b, k * (g[a] * g[b].transpose() + angle * h[a][b]));
      }
    }
  }
}

void RodInChannel::addWalls()
{
  for (int i = 0; i <= this->form_.pieces; ++i)
  {
    const Eigen::Vector2d p = this->at_.segment<2>(2 * i);
    const Wall wall = this->wallAt(p);
    if ((i < this->out_ && p.x() <= 0.0) || wall.off_mm <= 0.0)
    {
      continue;
    }
    const double press_N = wall_N_per_mm * wall.off_mm;
    const Eigen::Vector2d t = turned(wall.out);
    this->force_.segment<2>(2 * i) -= press_N * wall.out;
    Eigen::Matrix2d k = wall_N_per_mm * wall.out * wall.out.transpose();
    k += press_N * wall.bends_per_mm * t * t.transpose();
    const double slip_mm = t.dot(p - this->before_.segment<2>(2 * i));
    const double root = std::hypot(slip_mm, smooth_mm);
    this->force_.segment<2>(2 * i) -= this->form_.friction * press_N * slip_mm / root * t;
    k += this->form_.friction * t *
         (wall_N_per_mm * slip_mm / root * wall.out + press_N * smooth_mm * smooth_mm / (root * root * root) * t)
           .transpose();
    this->addBlock(i, i, k);
  }
}

void RodInChannel::assemble(double hand_mm)
{
  this->force_.setZero(this->at_.size());
  this->band_.setZero(this->at_.size(), 2 * half + 1);
  this->addPieces();
  this->addJoints();
  this->addWalls();
  this->force_[0] += this->form_.hand_N_per_mm * (hand_mm - this->form_.length_mm - this->at_[0]);
  this->band(0, 0) += this->form_.hand_N_per_mm;
  for (int i = 0; i <= this->form_.pieces; ++i) // the sheath
  {
    const int row = 2 * i + 1;
    if (i < this->out_ && (i == 0 || this->at_[2 * i] <= 0.0))
    {
      for (int other = std::max(row - half, 0); other <= std::min(row + half, static_cast<int>(this->at_.size()) - 1);
           ++other)
      {
        this->band(row, other) = this->band(other, row) = 0.0;
      }
      this->band(row, row) = 1.0;
      this->force_[row] = -this->at_[row];
    }
  }
}

/// Gauss without exchanges.
Eigen::VectorXd RodInChannel::solve(double drag) const
{
  Eigen::MatrixXd a = this->band_;
  a.col(half).array() += drag;
  Eigen::VectorXd x = this->force_;
  const int n = static_cast<int>(x.size());
  for (int i = 0; i < n; ++i)
  {
    for (int r = i + 1; r <= std::min(i + half, n - 1); ++r)
    {
      const double share = a(r, i - r + half) / a(i, half);
      for (int c = i; c <= std::min(i + half, n - 1); ++c)
      {
        a(r, c - r + half) -= share * a(i, c - i + half);
      }
      x[r] -= share * x[i];
    }
  }
  for (int i = n - 1; i >= 0; --i)
  {
    for (int c = i + 1; c <= std::min(i + half, n - 1); ++c)
    {
      x[i] -= a(i, c - i + half) * x[c];
    }
    x[i] /= a(i, half);
  }
  return x;
}

double RodInChannel::push(double hand_mm)
{
  constexpr int mostSteps = 400;
  constexpr double enough_N = 1e-7, most_mm = 0.2;
  double drag = 0.0;
  this->before_ = this->at_;
  this->out_ = 0;
  while (this->out_ <= this->form_.pieces && this->before_[2 * this->out_] <= 0.0)
  {
    ++this->out_;
  }
  this->rests_ = false;
  this->assemble(hand_mm);
  for (int i = 0; i < mostSteps && !this->rests_; ++i)
  {
    const double open_N = this->force_.norm();
    const Eigen::VectorXd at = this->at_;
    Eigen::VectorXd step = this->solve(drag);
    const double longest_mm = step.lpNorm<Eigen::Infinity>();
    step *= longest_mm > most_mm ? most_mm / longest_mm : 1.0;
    this->at_ += step;
    this->assemble(hand_mm);
    this->rests_ = this->force_.norm() < enough_N;
    const bool worse = !(this->force_.norm() < 4.0 * open_N) && i > 20;
    drag = worse ? std::max(2.0 * drag, 1e-3) : 0.3 * drag;
    drag = drag < 1e-9 ? 0.0 : drag;
    if (!this->force_.allFinite())
    {
      this->at_ = at;
      this->assemble(hand_mm);
      drag = std::max(4.0 * drag, 1e-2);
    }
  }
  return this->form_.hand_N_per_mm * (hand_mm - this->form_.length_mm - this->at_[0]);
}

double RodInChannel::largestWall_N() const
{
  double most_N = 0.0;
  for (int i = 0; i <= this->form_.pieces; ++i)
  {
    const Eigen::Vector2d p = this->at_.segment<2>(2 * i);
    most_N = i >= this->out_ || p.x() > 0.0 ? std::max(most_N, wall_N_per_mm * this->wallAt(p).off_mm) : most_N;
  }
  return most_N;
}

} // namespace palpate::test
