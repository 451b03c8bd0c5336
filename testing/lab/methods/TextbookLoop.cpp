// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>
#include <vector>

#include "testing/lab/backends/Peers.h"
#include "testing/lab/methods/Planes.h"
#include "testing/lab/methods/Textbook.h"

namespace palpate::lab
{
namespace
{

class TextbookLoop final : public ContactMethod
{
public:
  explicit TextbookLoop(std::shared_ptr<const RayCaster> faces) : faces_(std::move(faces)) {}

  void start(const Vec3& p_W) override
  {
    this->x_W_ = p_W;
    this->planes_.clear();
  }

  MethodTick tick(const Vec3& p_W) override
  {
    constexpr int mostPasses = 16;
    for (int pass = 0; pass < mostPasses && this->pass(p_W); ++pass)
    {
    }
    return { this->x_W_, this->x_W_ - p_W };
  }

private:
  /// One goal, one sweep; true while there is more to do.
  bool pass(const Vec3& p_W)
  {
    const Vec3 goal_W = nearestInFront(this->planes_, p_W);
    const auto hit = this->faces_->firstHit(this->x_W_, goal_W);
    std::erase_if(this->planes_, [&goal_W](const Plane& plane) { return plane.height(goal_W) > gap_u; });
    if (!hit)
    {
      this->x_W_ = goal_W;
      return false;
    }
    const Plane plane = planeTowards(*hit, this->x_W_, gap_u);
    this->x_W_ = hit->point_W + gap_u * plane.n;
    const bool known = std::any_of(this->planes_.begin(), this->planes_.end(),
      [&plane](const Plane& other) { return same(plane, other, 0.5 * gap_u); });
    if (!known)
    {
      this->planes_.push_back(plane);
    }
    return !known;
  }

  std::shared_ptr<const RayCaster> faces_;
  Vec3 x_W_ = Vec3::Zero();
  std::vector<Plane> planes_;
};

} // namespace

std::unique_ptr<ContactMethod> makeTextbookLoop(const World& world)
{
  return std::make_unique<TextbookLoop>(world.faces);
}

std::unique_ptr<ContactMethod> makeTextbookLoopOnEmbree(const World& world)
{
  return std::make_unique<TextbookLoop>(embreeRays()(*world.mesh));
}

} // namespace palpate::lab
