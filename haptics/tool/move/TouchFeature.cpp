// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/move/TouchFeature.h"

#include <algorithm>
#include <cmath>

#include "haptics/geometry/mesh/NearestOnLines.h"

namespace palpate
{
namespace
{

/// True if a point, seen along the face's normal, lies in the triangle or on its border.
bool projectsInside(const Vec3& p, const Corners& t, const Vec3& n)
{
  for (int k = 0; k < 3; ++k)
  {
    if (n.cross(t[(k + 1) % 3] - t[k]).dot(p - t[k]) < 0.0)
    {
      return false;
    }
  }
  return true;
}

class FeatureSearch
{
public:
  FeatureSearch(
    const PosedPair& pair, const Mat3& turn, const Vec3& centre_W, double within_u, std::vector<TouchFeature>& features)
    : pair_(pair), turn_(turn), centre_W_(centre_W), within_u_(within_u), features_(features),
      ofScene_(unitNormal(pair.scene_W)), ofTool_(unitNormal(pair.tool_W))
  {
  }

  /// The larger gap along the planes of the two triangles.
  [[nodiscard]] double facesApart_u() const
  {
    const Corners &tool = this->pair_.tool_W, &scene = this->pair_.scene_W;
    const auto apart = [&](const Vec3& n) { return std::max(gapAlong(n, tool, scene), gapAlong(-n, tool, scene)); };
    return std::max(apart(this->ofScene_), apart(this->ofTool_));
  }

  void corners()
  {
    const Corners &tool = this->pair_.tool_W, &scene = this->pair_.scene_W;
    const Vec3 &ofScene = this->ofScene_, &ofTool = this->ofTool_;
    for (int k = 0; k < 3; ++k)
    {
      const double above = ofScene.dot(tool[k] - scene[0]);
      if (!this->pair_.toolFlat.corner(k) && this->near(above) && projectsInside(tool[k], scene, ofScene))
      {
        const Vec3 n = above < 0.0 ? Vec3(-ofScene) : ofScene;
        this->add({ TouchFeature::Kind::CornerOnFace, this->toBody(tool[k]), Vec3::Zero(), scene[0], n }, n);
      }
      const double below = ofTool.dot(scene[k] - tool[0]);
      if (!this->pair_.sceneFlat.corner(k) && this->near(below) && projectsInside(scene[k], tool, ofTool))
      {
        const Vec3 n = below > 0.0 ? Vec3(-ofTool) : ofTool;
        const Vec3 touching = scene[k] - below * ofTool;
        this->add({ TouchFeature::Kind::FaceOnCorner, this->toBody(touching), this->turn_.transpose() * n, scene[k],
                    Vec3::Zero() },
          n);
      }
    }
  }

  void edges()
  {
    const Corners &tool = this->pair_.tool_W, &scene = this->pair_.scene_W;
    for (int i = 0; i < 3; ++i)
    {
      const Vec3 u = tool[(i + 1) % 3] - tool[i];
      for (int j = 0; j < 3 && !this->pair_.toolFlat.edge(i); ++j)
      {
        if (!this->pair_.sceneFlat.edge(j))
        {
          this->edgeOnEdge(tool[i], u, scene[j], scene[(j + 1) % 3] - scene[j]);
        }
      }
    }
  }

private:
  [[nodiscard]] bool near(double distance) const { return std::abs(distance) <= this->within_u_; }
  [[nodiscard]] Vec3 toBody(const Vec3& p_W) const { return this->turn_.transpose() * (p_W - this->centre_W_); }

  void edgeOnEdge(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v)
  {
    const Vec3 across = u.cross(v);
    const double height = across.dot(a - b);
    double s = 0.0, t = 0.0;
    if (height * height > this->within_u_ * this->within_u_ * across.squaredNorm() ||
        !nearestOnLines(a, u, b, v, s, t) || s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0)
    {
      return;
    }
    const Vec3 onTool = a + s * u, onScene = b + t * v;
    Vec3 n = across.normalized();
    const double gap = n.dot(onTool - onScene);
    if (!this->near(gap))
    {
      return;
    }
    // The signs of the two directions are such that their cross product points out of the scene.
    const Vec3 along = gap < 0.0 ? Vec3(-u) : u;
    n = gap < 0.0 ? Vec3(-n) : n;
    this->add({ TouchFeature::Kind::EdgeOnEdge, this->toBody(onTool), this->turn_.transpose() * along.normalized(),
                onScene, v.normalized() },
      n);
  }

  void add(const TouchFeature& feature, const Vec3& n)
  {
    if (gapAlong(n, this->pair_.tool_W, this->pair_.scene_W) > 0.0)
    {
      this->features_.push_back(feature);
    }
  }

  const PosedPair& pair_;
  const Mat3& turn_;
  const Vec3& centre_W_;
  double within_u_;
  std::vector<TouchFeature>& features_;
  Vec3 ofScene_, ofTool_;
};

} // namespace

TouchPlane planeAt(const TouchFeature& feature, const Mat3& turn, const Vec3& centre_W) noexcept
{
  TouchPlane plane;
  plane.arm_W = turn * feature.point_B;
  const Vec3 between = centre_W + plane.arm_W - feature.point_W;
  const Vec3 ofTool = turn * feature.direction_B;
  switch (feature.kind)
  {
    case TouchFeature::Kind::CornerOnFace:
      plane.n_W = feature.direction_W;
      break;
    case TouchFeature::Kind::FaceOnCorner:
      plane.n_W = ofTool;
      plane.arm_W -= between - ofTool.dot(between) * ofTool; // the face slides over the corner
      break;
    case TouchFeature::Kind::EdgeOnEdge:
    {
      plane.n_W = ofTool.cross(feature.direction_W).normalized();
      double s = 0.0, t = 0.0;
      if (nearestOnLines(between, ofTool, Vec3::Zero(), feature.direction_W, s, t))
      {
        plane.arm_W += s * ofTool;
      }
      break;
    }
  }
  plane.gap_u = plane.n_W.dot(between);
  return plane;
}

double appendFeatures(
  const PosedPair& pair, const Mat3& turn, const Vec3& centre_W, double within_u, std::vector<TouchFeature>& features)
{
  const double boxes_u = boxesApart_u(pair.tool_W, pair.scene_W);
  if (boxes_u > within_u)
  {
    return boxes_u;
  }
  FeatureSearch search(pair, turn, centre_W, within_u, features);
  const double faces_u = search.facesApart_u();
  if (!(faces_u > within_u))
  {
    search.corners();
    search.edges();
  }
  return std::max(boxes_u, faces_u);
}

TouchFeature nearestFeature(const Corners& tool_W, const Corners& scene_W, const Mat3& turn, const Vec3& centre_W)
{
  const NearestPair nearest = nearestPair(tool_W, scene_W);
  return { TouchFeature::Kind::CornerOnFace, turn.transpose() * (nearest.onTool_W - centre_W), Vec3::Zero(),
    nearest.onScene_W, nearest.n };
}

} // namespace palpate
