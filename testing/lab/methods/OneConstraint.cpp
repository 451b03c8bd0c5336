// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "testing/lab/methods/Planes.h"
#include "testing/lab/methods/Textbook.h"

namespace palpate::lab
{
namespace
{

class OneConstraint final : public ContactMethod
{
public:
  explicit OneConstraint(const World& world) : faces_(world.faces) {}

  void start(const Vec3& p_W) override
  {
    this->x_W_ = p_W;
    this->planes_.clear();
  }

  MethodTick tick(const Vec3& p_W) override
  {
    std::erase_if(this->planes_, [this](const Plane& plane) { return !this->supports(plane); });
    const Vec3 goal_W = nearestInFront(this->planes_, p_W);
    std::erase_if(this->planes_, [&goal_W](const Plane& plane) { return plane.height(goal_W) > gap_u; });
    if (const auto hit = this->faces_->firstHit(this->x_W_, goal_W))
    {
      const Plane plane = planeTowards(*hit, this->x_W_, gap_u);
      this->x_W_ = hit->point_W + gap_u * plane.n; // the rest of the displacement is left to the next call
      this->planes_.push_back(plane);
    }
    else
    {
      this->x_W_ = goal_W;
    }
    return { this->x_W_, this->x_W_ - p_W };
  }

private:
  [[nodiscard]] bool supports(const Plane& plane) const
  {
    return this->faces_->firstHit(this->x_W_, this->x_W_ - 3 * gap_u * plane.n).has_value();
  }

  std::shared_ptr<const FaceTree> faces_;
  Vec3 x_W_ = Vec3::Zero();
  std::vector<Plane> planes_;
};

} // namespace

std::unique_ptr<ContactMethod> makeOneConstraint(const World& world)
{
  return std::make_unique<OneConstraint>(world);
}

} // namespace palpate::lab
