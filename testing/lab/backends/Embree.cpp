// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <stdexcept>

#include <embree3/rtcore.h>

#include "testing/lab/backends/Backend.h"
#include "testing/lab/backends/Peers.h"

namespace palpate::lab
{
namespace
{

/// A mesh in Embree.
class EmbreeScene
{
public:
  explicit EmbreeScene(const TriangleMesh& mesh)
    : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(this->device_))
  {
    // Robust: the documented mode in which neighbouring triangles leave no gap between them.
    rtcSetSceneFlags(this->scene_, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(this->device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    fill(geometry, mesh);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->scene_);
    if (rtcGetDeviceError(this->device_) != RTC_ERROR_NONE)
    {
      throw std::runtime_error("embree does not take the mesh of a query");
    }
  }

  ~EmbreeScene()
  {
    rtcReleaseScene(this->scene_);
    rtcReleaseDevice(this->device_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  [[nodiscard]] bool occludes(const Vec3& from_W, const Vec3& to_W) const
  {
    RTCRay ray = rayOf(from_W, to_W);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(this->scene_, &context, &ray);
    return ray.tfar < 0.0f; // how embree says: occluded
  }

  /// The first triangle on the segment and the fraction of the segment at which it is met.
  struct Hit
  {
    std::size_t triangle;
    double t;
  };
  [[nodiscard]] std::optional<Hit> first(const Vec3& from_W, const Vec3& to_W) const
  {
    RTCRayHit query{};
    query.ray = rayOf(from_W, to_W);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(this->scene_, &context, &query);
    return query.hit.geomID != RTC_INVALID_GEOMETRY_ID ? std::optional<Hit>({ query.hit.primID, query.ray.tfar })
                                                       : std::nullopt;
  }

private:
  static void fill(RTCGeometry geometry, const TriangleMesh& mesh)
  {
    auto* const xyz = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices_W.size()));
    for (std::size_t i = 0; i < mesh.vertices_W.size(); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        xyz[3 * i + static_cast<std::size_t>(axis)] = static_cast<float>(mesh.vertices_W[i][axis]);
      }
    }
    auto* const corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      std::copy(mesh.triangles[i].begin(), mesh.triangles[i].end(), corners + 3 * i);
    }
  }

  [[nodiscard]] static RTCRay rayOf(const Vec3& from_W, const Vec3& to_W)
  {
    const Eigen::Vector3f from = from_W.cast<float>(), way = to_W.cast<float>() - from;
    RTCRay ray{};
    ray.org_x = from.x();
    ray.org_y = from.y();
    ray.org_z = from.z();
    ray.dir_x = way.x();
    ray.dir_y = way.y();
    ray.dir_z = way.z();
    ray.tnear = 0.0f;
    ray.tfar = 1.0f;
    ray.mask = std::numeric_limits<unsigned>::max();
    return ray;
  }

  RTCDevice device_;
  RTCScene scene_;
};

class Embree final : public Backend
{
public:
  explicit Embree(const TriangleMesh& mesh) : scene_(mesh) {}

  [[nodiscard]] bool meets(const Vec3& from_W, const Vec3& to_W) override
  {
    return this->scene_.occludes(from_W, to_W);
  }

  [[nodiscard]] std::optional<double> firstHit(const Vec3& from_W, const Vec3& to_W) override
  {
    const auto hit = this->scene_.first(from_W, to_W);
    return hit ? std::optional<double>(hit->t) : std::nullopt;
  }

private:
  EmbreeScene scene_;
};

class EmbreeRays final : public RayCaster
{
public:
  explicit EmbreeRays(const TriangleMesh& mesh) : mesh_(mesh), scene_(mesh) {}

  [[nodiscard]] std::optional<Face> firstHit(const Vec3& from_W, const Vec3& to_W) const override
  {
    const auto hit = this->scene_.first(from_W, to_W);
    if (!hit)
    {
      return std::nullopt;
    }
    const auto& [a, b, c] = this->mesh_.triangles[hit->triangle];
    const Vec3 &at = this->mesh_.vertices_W[a], &along = this->mesh_.vertices_W[b], &across = this->mesh_.vertices_W[c];
    return Face{ hit->triangle, from_W + hit->t * (to_W - from_W), (along - at).cross(across - at).normalized() };
  }

private:
  TriangleMesh mesh_;
  EmbreeScene scene_;
};

} // namespace

std::unique_ptr<Backend> makeEmbree(const TriangleMesh& mesh)
{
  return std::make_unique<Embree>(mesh);
}

std::unique_ptr<RayCaster> makeEmbreeRays(const TriangleMesh& mesh)
{
  return std::make_unique<EmbreeRays>(mesh);
}

} // namespace palpate::lab
