// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <gtest/gtest.h>

#include "Blocks.h"
#include "haptics/compliance/snapshot/SnapshotMaker.h"

namespace palpate::test
{

/// A pad (Blocks.h) with its surface.
struct SoftPad
{
  explicit SoftPad(
    int n, double edges = patchEdges, ElementKind element = ElementKind::EdgeSmoothed,
    const std::function<void(SoftBodyInput&)>& change = [](SoftBodyInput&) {})
  {
    SoftBodyInput input = pad(n);
    input.element = element;
    input.model = ElasticModel::Linear;
    change(input);
    SoftBodyResult made = makeSoftBody(input);
    EXPECT_TRUE(made.body) << made.refusal;
    this->mesh = made.checked.mesh;
    this->body = std::move(made.body);
    this->surface = makeSoftSurface(*this->body, this->mesh, edges);
  }

  [[nodiscard]] static Vec3 middle() { return middleOfPad(); }

  [[nodiscard]] SurfacePoint pointOn(std::uint32_t triangle, const Vec3& weights) const
  {
    SurfacePoint p{ this->surface.triangles[triangle], weights, Vec3::Zero() };
    for (int c = 0; c < 3; ++c)
    {
      p.x_W += weights[c] * this->surface.rest_W[p.vertices[c]];
    }
    return p;
  }

  /// The vertex in the middle of the top.
  [[nodiscard]] SurfacePoint top() const
  {
    for (std::uint32_t t = 0; t < this->surface.triangles.size(); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        if ((this->surface.rest_W[this->surface.triangles[t][c]] - middle()).norm() < 1e-9)
        {
          return this->pointOn(t, Vec3::Unit(c));
        }
      }
    }
    ADD_FAILURE() << "no vertex there";
    return {};
  }

  /// Which of the border's faces a point lies on.
  [[nodiscard]] std::uint32_t faceUnder(const BorderFaces& border, const SurfacePoint& p) const
  {
    for (const std::uint32_t face : border.facesAt(this->surface.vertices[p.vertices[0]]))
    {
      const auto& corners = border.faces()[face];
      if (std::all_of(p.vertices.begin(), p.vertices.end(),
            [&](std::uint32_t v)
            { return std::count(corners.begin(), corners.end(), this->surface.vertices[v]) == 1; }))
      {
        return face;
      }
    }
    ADD_FAILURE() << "no face there";
    return 0;
  }

  [[nodiscard]] SnapshotRequest request(double radius_u) const
  {
    SnapshotRequest request;
    request.ball_W = middle();
    request.radius_u = radius_u;
    return request;
  }

  /// At rest; `beyond`: how much further than usual its neighbourhood reaches.
  [[nodiscard]] std::shared_ptr<const ComplianceSnapshot> snapshot(double radius_u, double beyond_u) const
  {
    SnapshotRequest request = this->request(radius_u);
    request.velocity_u_per_s = Vec3(0.0, 0.0, 1e-9);
    request.period_s = beyond_u / 2e-9;
    return SnapshotMaker(*this->body, this->surface).make(request);
  }

  TetraMesh mesh;
  std::unique_ptr<SoftBody> body;
  SoftSurface surface;
};

} // namespace palpate::test
