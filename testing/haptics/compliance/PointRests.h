// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "SoftScenes.h"

namespace palpate::test
{

/// Where a point without friction, drawn to a hand by a spring, is at rest on the upper side of a surface that yields:
/// all such places, found face by face, crease by crease, vertex by vertex from triangles and compliance alone. There x
/// is p + C f, C the spring's compliance and the surface's own at x; f lies in the cone of the normals there.
class PointRests
{
public:
  struct Rest
  {
    Vec3 x_W = Vec3::Zero(); ///< in the material
    Vec3 force_N = Vec3::Zero();
  };

  /// The scene is kept. `above_u`: no triangle below that height counts.
  PointRests(const SoftScene& scene, double stiffness_N_per_u, double above_u)
    : s_(scene), spring_(Mat3::Identity() / stiffness_N_per_u)
  {
    for (const auto& corners : scene.pad.surface.triangles)
    {
      Face face{ corners, normalOf(corners) };
      if (std::abs(face.n.z()) > 0.3 && this->corner(face, 0).z() > above_u)
      {
        face.n *= face.n.z() > 0.0 ? 1.0 : -1.0;
        this->faces_.push_back(face);
      }
    }
    for (std::size_t f = 0; f < this->faces_.size(); ++f)
    {
      for (int c = 0; c < 3; ++c)
      {
        const std::uint32_t a = this->faces_[f].corners[c], b = this->faces_[f].corners[(c + 1) % 3];
        this->edges_[std::minmax(a, b)].push_back(f);
      }
    }
  }

  [[nodiscard]] std::vector<Rest> at(const Vec3& p_W, double within_u = 0.02) const
  {
    std::vector<Rest> rests;
    for (const Face& face : this->faces_)
    {
      if ((this->corner(face, 0) - p_W).norm() < within_u)
      {
        this->addOnFace(face, p_W, rests);
      }
    }
    std::map<std::uint32_t, std::vector<Vec3>> ways; // from a vertex along its edges
    for (const auto& [ends, faces] : this->edges_)
    {
      const Vec3 &a = this->vertex(ends.first), &b = this->vertex(ends.second);
      if ((a - p_W).norm() < within_u)
      {
        ways[ends.first].push_back((b - a).normalized());
        ways[ends.second].push_back((a - b).normalized());
        if (faces.size() == 2)
        {
          this->addInCrease(ends, this->faces_[faces[0]], this->faces_[faces[1]], p_W, rests);
        }
      }
    }
    for (const auto& [v, along] : ways)
    {
      this->addAtVertex(v, along, p_W, rests);
    }
    return rests;
  }

private:
  struct Face
  {
    std::array<std::uint32_t, 3> corners;
    Vec3 n;
  };
  static constexpr double slack = 1e-9; ///< of a place on the border of a face

  [[nodiscard]] const Vec3& vertex(std::uint32_t v) const { return this->s_.pad.surface.rest_W[v]; }
  [[nodiscard]] const Vec3& corner(const Face& f, int c) const { return this->vertex(f.corners[c]); }
  [[nodiscard]] Vec3 normalOf(const std::array<std::uint32_t, 3>& t) const
  {
    return (this->vertex(t[1]) - this->vertex(t[0])).cross(this->vertex(t[2]) - this->vertex(t[0])).normalized();
  }
  [[nodiscard]] Mat3 own(std::uint32_t v) const { return this->s_.snapshot->between(v, v); }

  void addOnFace(const Face& face, const Vec3& p_W, std::vector<Rest>& rests) const
  {
    const Vec3 &a = this->corner(face, 0), &b = this->corner(face, 1), &c = this->corner(face, 2);
    const Vec3 n = (b - a).cross(c - a);
    const double deep_u = face.n.dot(a - p_W);
    Vec3 x = p_W, force_N = Vec3::Zero(), weights = Vec3::Constant(1.0 / 3.0);
    for (int i = 0; i < 60 && deep_u > 0.0; ++i) // a contraction: compliance differs little from corner to corner
    {
      const Mat3 give = this->spring_ + weights[0] * this->own(face.corners[0]) +
                        weights[1] * this->own(face.corners[1]) + weights[2] * this->own(face.corners[2]);
      force_N = deep_u / face.n.dot(give * face.n) * face.n;
      x = p_W + give * force_N;
      weights = Vec3((c - b).cross(x - b).dot(n), (a - c).cross(x - c).dot(n), (b - a).cross(x - a).dot(n));
      weights /= n.squaredNorm();
      weights = weights.cwiseMax(-1.0).cwiseMin(2.0);
    }
    if (deep_u > 0.0 && weights.minCoeff() > -slack)
    {
      rests.push_back({ x, force_N });
    }
  }

  /// A fold that opens upwards pushes by both of its faces.
  void addInCrease(const std::pair<std::uint32_t, std::uint32_t>& ends, const Face& one, const Face& other,
    const Vec3& p_W, std::vector<Rest>& rests) const
  {
    const Vec3 &a = this->vertex(ends.first), &b = this->vertex(ends.second);
    double highest = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      highest = std::max(highest, one.n.dot(this->corner(other, c) - a));
    }
    if (highest <= slack * (b - a).norm())
    {
      return;
    }
    Eigen::Matrix<double, 3, 2> n;
    n << one.n, other.n;
    double share = 0.5;
    Eigen::Vector2d push = Eigen::Vector2d::Zero();
    Mat3 give = this->spring_;
    for (int i = 0; i < 60; ++i)
    {
      give = this->spring_ + (1.0 - share) * this->own(ends.first) + share * this->own(ends.second);
      push = (n.transpose() * give * n).fullPivLu().solve(n.transpose() * (a - p_W));
      share = std::clamp((p_W + give * (n * push) - a).dot(b - a) / (b - a).squaredNorm(), -1.0, 2.0);
    }
    if (push.minCoeff() >= 0.0 && share > -slack && share < 1.0 + slack)
    {
      rests.push_back({ p_W + give * (n * push), n * push });
    }
  }

  /// In a vertex the point stays if no direction along its edges leads nearer.
  void addAtVertex(std::uint32_t v, const std::vector<Vec3>& along, const Vec3& p_W, std::vector<Rest>& rests) const
  {
    const Vec3 force_N = (this->spring_ + this->own(v)).inverse() * (this->vertex(v) - p_W);
    const auto held = [&](const Vec3& way) { return force_N.dot(way) >= 0.0; };
    if (force_N.z() > 0.0 && along.size() > 2 && std::all_of(along.begin(), along.end(), held))
    {
      rests.push_back({ this->vertex(v), force_N });
    }
  }

  const SoftScene& s_;
  Mat3 spring_;
  std::vector<Face> faces_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> edges_;
};

} // namespace palpate::test
