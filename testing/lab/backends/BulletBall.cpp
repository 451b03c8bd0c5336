// SPDX-License-Identifier: GPL-3.0-or-later
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>

#include "testing/lab/backends/BulletPoint.h"
#include "testing/lab/backends/Peers.h"

namespace palpate::lab
{
namespace
{

Vec3 vector(const btVector3& v)
{
  return { v.x(), v.y(), v.z() };
}

class BulletBall final : public ContactMethod
{
public:
  BulletBall(const World& world, double radius_m)
    : perUnit_(1e3 / world.metre_u), ball_(static_cast<btScalar>(1e3 * radius_m))
  {
    for (const auto& [a, b, c] : world.mesh->triangles)
    {
      const auto corner = [&](std::uint32_t i) { return toBullet(this->perUnit_ * world.mesh->vertices_W[i]); };
      this->triangles_.addTriangle(corner(a), corner(b), corner(c));
    }
    this->shape_ = std::make_unique<btBvhTriangleMeshShape>(&this->triangles_, true);
    this->shape_->setMargin(0.0f); // else faces would be felt 40 um before they are there
    this->mesh_.setCollisionShape(this->shape_.get());
    this->mesh_.setWorldTransform(btTransform::getIdentity());
  }

  void start(const Vec3& p_W) override { this->x_ = this->perUnit_ * p_W; }

  MethodTick tick(const Vec3& p_W) override
  {
    constexpr int mostSweeps = 10;
    Vec3 goal = this->perUnit_ * p_W;
    for (int i = 0; i < mostSweeps && this->sweepTo(goal); ++i)
    {
    }
    const Vec3 x_W = this->x_ / this->perUnit_;
    return { x_W, x_W - p_W };
  }

private:
  /// Goes to the goal or to the first contact. At a contact the goal becomes the point of the tangent plane below it;
  /// true while the ball has further to go.
  bool sweepTo(Vec3& goal)
  {
    constexpr double little = 1e-6; // mm: less is no displacement in single precision
    if ((goal - this->x_).norm() <= little)
    {
      return false;
    }
    btTransform from = btTransform::getIdentity(), to = from;
    from.setOrigin(toBullet(this->x_));
    to.setOrigin(toBullet(goal));
    btCollisionWorld::ClosestConvexResultCallback hit(from.getOrigin(), to.getOrigin());
    btCollisionWorld::objectQuerySingle(
      &this->ball_, from, to, &this->mesh_, this->shape_.get(), this->mesh_.getWorldTransform(), hit, 0.0f);
    if (!hit.hasHit())
    {
      this->x_ = goal;
      return false;
    }
    constexpr double skin = 1e-3; // mm that are kept to the surface, so that the next sweep begins outside
    const Vec3 n = vector(hit.m_hitNormalWorld);
    this->x_ += static_cast<double>(hit.m_closestHitFraction) * (goal - this->x_) + skin * n;
    goal -= (goal - this->x_).dot(n) * n;
    return true;
  }

  double perUnit_; ///< millimetres in a unit of the scene
  btSphereShape ball_;
  btTriangleMesh triangles_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
  btCollisionObject mesh_;
  Vec3 x_ = Vec3::Zero();
};

} // namespace

std::unique_ptr<ContactMethod> makeBulletBall(const World& world, double radius_m)
{
  return std::make_unique<BulletBall>(world, radius_m);
}

} // namespace palpate::lab
