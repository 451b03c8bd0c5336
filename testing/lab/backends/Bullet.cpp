// SPDX-License-Identifier: GPL-3.0-or-later
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

#include "testing/lab/backends/Backend.h"
#include "testing/lab/backends/BulletPoint.h"

namespace palpate::lab
{
namespace
{

/// Keeps the first hit of a segment.
class FirstHit final : public btTriangleRaycastCallback
{
public:
  using btTriangleRaycastCallback::btTriangleRaycastCallback;

  btScalar reportHit(const btVector3& /*normal*/, btScalar fraction, int /*part*/, int /*triangle*/) override
  {
    this->found_ = true;
    return fraction;
  }
  [[nodiscard]] bool found() const { return this->found_; }

private:
  bool found_ = false;
};

class Bullet final : public Backend
{
public:
  explicit Bullet(const TriangleMesh& mesh)
  {
    for (const auto& [a, b, c] : mesh.triangles)
    {
      this->triangles_.addTriangle(
        toBullet(mesh.vertices_W[a]), toBullet(mesh.vertices_W[b]), toBullet(mesh.vertices_W[c]));
    }
    this->shape_ = std::make_unique<btBvhTriangleMeshShape>(&this->triangles_, true);
  }

  [[nodiscard]] bool meets(const Vec3& from_W, const Vec3& to_W) override
  {
    return this->firstHit(from_W, to_W).has_value();
  }

  [[nodiscard]] std::optional<double> firstHit(const Vec3& from_W, const Vec3& to_W) override
  {
    FirstHit callback(toBullet(from_W), toBullet(to_W));
    this->shape_->performRaycast(&callback, callback.m_from, callback.m_to);
    return callback.found() ? std::optional<double>(callback.m_hitFraction) : std::nullopt;
  }

private:
  btTriangleMesh triangles_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};

} // namespace

std::unique_ptr<Backend> makeBullet(const TriangleMesh& mesh)
{
  return std::make_unique<Bullet>(mesh);
}

} // namespace palpate::lab
