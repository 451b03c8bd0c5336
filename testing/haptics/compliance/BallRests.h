// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include "SoftScenes.h"
#include "haptics/compliance/servo/SubgridForce.h"

namespace palpate::test
{

/// A place where a ball without friction is at rest.
struct BallRest
{
  Vec3 x_W = Vec3::Zero(); ///< in the material
  Vec3 force_N = Vec3::Zero();
  std::vector<std::uint32_t> on; ///< indices of the touched features
};

/// A ball without friction that a spring draws to a hand, on the upper side of a surface that yields: its places of
/// rest, found by trying every set of one to three faces, edges and vertices near a place. A set S touched at feet a_c
/// with normals n_c and pressed by forces f_c n_c is a rest if
///   - the centre x is at a distance of one radius from every feature of S and no nearer to any triangle,
///   - every gap is closed: n_c (p + f / K + u_c - a_c) = r, u_c being the surface's displacement at c under all f_c,
///   - no force draws, and along the directions that S leaves free x is p + f / K plus the mean of u_c by force,
///   - the rest is stable: displaced along these directions, the ball goes back.
/// Where the ball fits at the hand itself, the empty set is a rest too.
/// The compliance between two points and the depth of the springs are the snapshot's, and tested elsewhere; balance,
/// features and stability are computed here.
class BallRests
{
public:
  /// The scene is kept. `above_u`: no triangle below that height counts.
  BallRests(const SoftScene& scene, double stiffness_N_per_u, double above_u)
    : s_(scene), k_(stiffness_N_per_u), r_(scene.plan.radius_u)
  {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> edges;
    std::map<std::uint32_t, bool> corners;
    for (const auto& t : scene.pad.surface.triangles)
    {
      const Vec3 n = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).normalized();
      if (std::abs(n.z()) > 0.3 && at(t[0]).z() > above_u)
      {
        for (int c = 0; c < 3; ++c)
        {
          edges[std::minmax(t[c], t[(c + 1) % 3])].push_back(this->features_.size());
          corners[t[c]] = true;
        }
        this->features_.push_back({ { t[0], t[1], t[2] }, n.z() > 0.0 ? n : Vec3(-n) });
      }
    }
    this->faces_ = this->features_.size();
    for (const auto& [ends, faces] : edges)
    {
      if (faces.size() == 2 && this->opensDown(faces[0], faces[1]))
      {
        this->features_.push_back({ { ends.first, ends.second }, Vec3::Zero() });
      }
    }
    for (const auto& [v, is] : corners)
    {
      this->features_.push_back({ { v }, Vec3::Zero() });
    }
  }

  /// All rests whose place is within `reach_u` of x.
  [[nodiscard]] std::vector<BallRest> near(const Vec3& p_W, const Vec3& x_W, double reach_u) const
  {
    std::vector<std::uint32_t> close;
    for (std::uint32_t f = 0; f < this->features_.size(); ++f)
    {
      if ((x_W - this->nearest(f, x_W)).norm() < this->r_ + reach_u)
      {
        close.push_back(f);
      }
    }
    std::vector<BallRest> rests;
    if (const auto apart = this->restOn({}, p_W, x_W); apart && (p_W - x_W).norm() < reach_u)
    {
      rests.push_back(*apart);
    }
    const auto add = [&](const std::vector<std::uint32_t>& on)
    {
      if (const auto rest = this->restOn(on, p_W, x_W); rest && (rest->x_W - x_W).norm() < reach_u)
      {
        rests.push_back(*rest);
      }
    };
    for (std::size_t a = 0; a < close.size(); ++a)
    {
      add({ close[a] });
      for (std::size_t b = 0; b < a; ++b)
      {
        add({ close[a], close[b] });
        for (std::size_t c = 0; c < b; ++c)
        {
          const std::vector<std::uint32_t> three{ close[a], close[b], close[c] };
          if (this->fitsOn(three, x_W, reach_u))
          {
            add(three);
          }
        }
      }
    }
    return rests;
  }

  /// The rest on these features that Newton's method finds from x.
  [[nodiscard]] std::optional<BallRest> restOn(
    const std::vector<std::uint32_t>& on, const Vec3& p_W, const Vec3& x_W) const
  {
    if (on.empty())
    {
      return this->fits(p_W) ? std::optional(BallRest{ p_W, Vec3::Zero(), {} }) : std::nullopt;
    }
    const auto m = static_cast<Eigen::Index>(on.size());
    Eigen::VectorXd z = Eigen::VectorXd::Zero(3 + m);
    z.head<3>() = x_W;
    z.tail(m).setConstant(std::max(this->k_ * (x_W - p_W).norm(), 1e-3) * 0.5 / static_cast<double>(m));
    for (int i = 0; i < 40; ++i)
    {
      const Eigen::VectorXd off = this->offOf(on, p_W, z);
      if (off.cwiseAbs().maxCoeff() < 1e-13)
      {
        return this->checked(on, p_W, z);
      }
      Eigen::VectorXd step = this->slopes(on, p_W, z).fullPivLu().solve(-off);
      const double most =
        std::max(step.head<3>().norm() / (0.3 * this->r_), step.tail(m).norm() / (0.5 * z.tail(m).norm() + 0.01));
      z += step / std::max(1.0, most);
      z.tail(m) = z.tail(m).cwiseMax(-0.5);
      if (!z.allFinite() || (z.head<3>() - x_W).norm() > 4.0 * this->r_)
      {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

private:
  /// A face, or the two ends of an edge, or a vertex.
  struct Feature
  {
    std::vector<std::uint32_t> v;
    Vec3 n;
  };
  /// How a ball touches a feature.
  struct Touch
  {
    CompliantPoint point;
    SubgridSpring spring;
    Vec3 foot_W = Vec3::Zero();
    Vec3 n = Vec3::Zero();
  };

  [[nodiscard]] const Vec3& at(std::uint32_t v) const { return this->s_.pad.surface.rest_W[v]; }

  [[nodiscard]] bool opensDown(std::size_t one, std::size_t other) const
  {
    const Feature& a = this->features_[one];
    return std::ranges::all_of(
      this->features_[other].v, [&](std::uint32_t v) { return a.n.dot(this->at(v) - this->at(a.v[0])) < 1e-12; });
  }

  /// Barycentric coordinates of the foot of x on the feature's plane or line, beyond it too.
  [[nodiscard]] Vec3 footShares(const Feature& f, const Vec3& x) const
  {
    if (f.v.size() == 1)
    {
      return Vec3::UnitX();
    }
    const Vec3 ab = this->at(f.v[1]) - this->at(f.v[0]);
    if (f.v.size() == 2)
    {
      const double share = (x - this->at(f.v[0])).dot(ab) / ab.squaredNorm();
      return { 1.0 - share, share, 0.0 };
    }
    const Vec3 ac = this->at(f.v[2]) - this->at(f.v[0]);
    Eigen::Matrix<double, 3, 2> sides;
    sides << ab, ac;
    const Eigen::Vector2d w = (sides.transpose() * sides).inverse() * (sides.transpose() * (x - this->at(f.v[0])));
    return { 1.0 - w.sum(), w[0], w[1] };
  }

  [[nodiscard]] Vec3 placeOf(const Feature& f, const Vec3& shares) const
  {
    Vec3 sum = Vec3::Zero();
    for (std::size_t c = 0; c < f.v.size(); ++c)
    {
      sum += shares[static_cast<Eigen::Index>(c)] * this->at(f.v[c]);
    }
    return sum;
  }

  /// Of a triangle's, edge's or vertex's points the nearest one to x.
  [[nodiscard]] Vec3 nearest(std::uint32_t feature, const Vec3& x) const
  {
    const Feature& f = this->features_[feature];
    const Vec3 shares = this->footShares(f, x);
    if (f.v.size() < 3)
    {
      return this->placeOf(f, shares.cwiseMax(0.0).cwiseMin(1.0));
    }
    if (shares.minCoeff() >= 0.0)
    {
      return this->placeOf(f, shares);
    }
    Vec3 best = this->at(f.v[0]);
    for (int c = 0; c < 3; ++c)
    {
      const Feature side{ { f.v[c], f.v[(c + 1) % 3] }, Vec3::Zero() };
      const Vec3 here = this->placeOf(side, this->footShares(side, x).cwiseMax(0.0).cwiseMin(1.0));
      best = (here - x).norm() < (best - x).norm() ? here : best;
    }
    return best;
  }

  /// Whether a ball near x that crosses nothing may touch three features at once: this check saves most sets
  /// Newton's steps on all constraints.
  [[nodiscard]] bool fitsOn(const std::vector<std::uint32_t>& three, const Vec3& x_W, double reach_u) const
  {
    Vec3 x = x_W;
    Vec3 off;
    for (int i = 0; i < 20; ++i)
    {
      Mat3 normals;
      for (int c = 0; c < 3; ++c)
      {
        const Feature& f = this->features_[three[static_cast<std::size_t>(c)]];
        const Vec3 foot = this->placeOf(f, this->footShares(f, x));
        const Vec3 n = f.v.size() == 3 ? f.n : Vec3((x - foot).normalized());
        normals.row(c) = n.transpose();
        off[c] = n.dot(x - foot) - this->r_;
      }
      if (off.cwiseAbs().maxCoeff() < 1e-12 * this->r_)
      {
        break;
      }
      x -= normals.fullPivLu().solve(off);
      if (!x.allFinite() || (x - x_W).norm() > 2.0 * reach_u)
      {
        return false;
      }
    }
    return (x - x_W).norm() < reach_u && std::ranges::all_of(three, [&](std::uint32_t f)
                                           { return (this->nearest(f, x) - x).norm() < this->r_ * (1.0 + 1e-9); });
  }

  [[nodiscard]] Touch touchOf(std::uint32_t feature, const Vec3& x) const
  {
    const Feature& f = this->features_[feature];
    const Vec3 shares = this->footShares(f, x);
    Touch touch;
    touch.foot_W = this->placeOf(f, shares);
    touch.n = f.v.size() == 3 ? f.n : Vec3((x - touch.foot_W).normalized());
    SurfacePoint point{ { f.v[0], f.v[f.v.size() > 1 ? 1 : 0], f.v[f.v.size() > 2 ? 2 : 0] }, shares, touch.foot_W };
    point.weights = point.weights.cwiseMax(0.0);
    point.weights /= point.weights.sum();
    touch.point = compliantPoint(*this->s_.snapshot, point);
    touch.spring = springAt(*this->s_.snapshot, point);
    return touch;
  }

  /// Displacement of the surface at each place, positive along the force on it that draws to the ball.
  [[nodiscard]] std::vector<Vec3> yields(const std::vector<Touch>& touches, const Eigen::VectorXd& f) const
  {
    std::vector<Vec3> u(touches.size(), Vec3::Zero());
    for (std::size_t e = 0; e < touches.size(); ++e)
    {
      Vec3 pressed = Vec3::Zero();
      double sum = 0.0;
      for (std::size_t c = 0; c < touches.size(); ++c)
      {
        const Vec3 force = f[static_cast<Eigen::Index>(c)] * touches[c].n;
        const double share = sharedBy(touches[e].point, touches[c].point);
        u[e] += complianceBetween(*this->s_.snapshot, touches[e].point, touches[c].point) * force;
        pressed += share * force;
        sum += share;
      }
      const double size = pressed.norm();
      const double depth = subgridDepth(touches[e].spring, size).depth_u;
      for (std::size_t c = 0; c < touches.size() && size > 0.0; ++c)
      {
        u[c] += sharedBy(touches[e].point, touches[c].point) / sum * depth / size * pressed;
      }
    }
    return u;
  }

  /// Residual of z = (x, f), 0 at rest: touches, gaps, and balance along the free directions.
  [[nodiscard]] Eigen::VectorXd offOf(
    const std::vector<std::uint32_t>& on, const Vec3& p, const Eigen::VectorXd& z) const
  {
    const auto m = static_cast<Eigen::Index>(on.size());
    const Vec3 x = z.head<3>();
    const Eigen::VectorXd f = z.tail(m);
    std::vector<Touch> touches;
    Vec3 pull = Vec3::Zero();
    for (Eigen::Index c = 0; c < m; ++c)
    {
      touches.push_back(this->touchOf(on[static_cast<std::size_t>(c)], x));
      pull += f[c] * touches.back().n;
    }
    const std::vector<Vec3> u = this->yields(touches, f);
    const Vec3 ball = p + pull / this->k_;
    Eigen::VectorXd off(3 + m);
    Vec3 mean = Vec3::Zero();
    Eigen::MatrixXd normals(m, 3);
    for (Eigen::Index c = 0; c < m; ++c)
    {
      const Touch& t = touches[static_cast<std::size_t>(c)];
      normals.row(c) = t.n.transpose();
      off[c] = t.n.dot(x - t.foot_W) - this->r_;
      off[m + c] = t.n.dot(ball + u[static_cast<std::size_t>(c)] - t.foot_W) - this->r_;
      mean += std::abs(f[c]) / f.cwiseAbs().sum() * u[static_cast<std::size_t>(c)];
    }
    const Eigen::MatrixXd free = this->freeOf(normals);
    off.tail(3 - m) = free.transpose() * (ball + mean - x);
    return off;
  }

  /// An orthonormal basis of the directions across all normals, the same for normals that differ little.
  [[nodiscard]] static Eigen::MatrixXd freeOf(const Eigen::MatrixXd& normals)
  {
    if (normals.rows() == 1)
    {
      const Vec3 n = normals.row(0);
      Eigen::MatrixXd free(3, 2);
      free.col(0) = (Vec3::UnitX() - n.x() * n).normalized();
      free.col(1) = n.cross(Vec3(free.col(0)));
      return free;
    }
    if (normals.rows() == 2)
    {
      return Vec3(normals.row(0)).cross(Vec3(normals.row(1))).normalized();
    }
    return Eigen::MatrixXd(3, 0);
  }

  [[nodiscard]] Eigen::MatrixXd slopes(
    const std::vector<std::uint32_t>& on, const Vec3& p, const Eigen::VectorXd& z) const
  {
    Eigen::MatrixXd j(z.size(), z.size());
    for (Eigen::Index i = 0; i < z.size(); ++i)
    {
      const double aside = i < 3 ? 1e-8 : 1e-6 * std::max(1e-2, std::abs(z[i]));
      Eigen::VectorXd more = z, less = z;
      more[i] += aside;
      less[i] -= aside;
      j.col(i) = (this->offOf(on, p, more) - this->offOf(on, p, less)) / (2.0 * aside);
    }
    return j;
  }

  [[nodiscard]] std::optional<BallRest> checked(
    const std::vector<std::uint32_t>& on, const Vec3& p, const Eigen::VectorXd& z) const
  {
    const auto m = static_cast<Eigen::Index>(on.size());
    const Vec3 x = z.head<3>();
    BallRest rest{ x, Vec3::Zero(), on };
    for (Eigen::Index c = 0; c < m; ++c)
    {
      const std::uint32_t f = on[static_cast<std::size_t>(c)];
      const Touch t = this->touchOf(f, x);
      if (z[3 + c] < 0.0 || (this->nearest(f, x) - t.foot_W).norm() > 1e-9)
      {
        return std::nullopt;
      }
      rest.force_N += z[3 + c] * t.n;
    }
    return this->fits(x) && this->isStable(on, p, z) ? std::optional(rest) : std::nullopt;
  }

  /// Whether a ball at x crosses no triangle and is above them.
  [[nodiscard]] bool fits(const Vec3& x) const
  {
    double least_u = std::numeric_limits<double>::infinity();
    bool above = true;
    for (std::uint32_t f = 0; f < this->faces_; ++f)
    {
      const Vec3 way = x - this->nearest(f, x);
      if (way.norm() < least_u)
      {
        least_u = way.norm();
        above = way.z() > 0.0; // of a surface that is nowhere steep
      }
    }
    return above && least_u >= this->r_ - 1e-9;
  }

  [[nodiscard]] bool isStable(const std::vector<std::uint32_t>& on, const Vec3& p, const Eigen::VectorXd& z) const
  {
    const auto m = static_cast<Eigen::Index>(on.size());
    if (m == 3)
    {
      return true;
    }
    const Eigen::MatrixXd j = this->slopes(on, p, z);
    Eigen::MatrixXd normals(m, 3);
    for (Eigen::Index c = 0; c < m; ++c)
    {
      normals.row(c) = this->touchOf(on[static_cast<std::size_t>(c)], z.head<3>()).n.transpose();
    }
    const Eigen::MatrixXd free = freeOf(normals);
    const Eigen::MatrixXd force = -j.block(m, 3, m, m).inverse() * j.block(m, 0, m, 3) * free;
    const Eigen::MatrixXd goes = j.block(2 * m, 0, 3 - m, 3) * free + j.block(2 * m, 3, 3 - m, m) * force;
    return goes.eigenvalues().real().maxCoeff() < 0.0;
  }

  const SoftScene& s_;
  double k_, r_;
  std::vector<Feature> features_; ///< faces, then edges that open down, then vertices
  std::size_t faces_ = 0;
};

} // namespace palpate::test
