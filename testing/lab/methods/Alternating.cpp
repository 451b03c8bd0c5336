// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/methods/Planes.h"
#include "testing/lab/methods/Textbook.h"

namespace palpate::lab
{
namespace
{

class Alternating final : public ContactMethod
{
public:
  explicit Alternating(const World& world) : faces_(world.faces) {}

  void start(const Vec3& p_W) override { this->x_W_ = p_W; }

  MethodTick tick(const Vec3& p_W) override
  {
    constexpr int mostSteps = 16;
    Vec3 goal_W = p_W;
    std::optional<Face> hit = this->faces_->firstHit(this->x_W_, goal_W);
    for (int step = 0; hit && step < mostSteps; ++step)
    {
      const Plane plane = planeTowards(*hit, this->x_W_, gap_u);
      goal_W -= plane.height(goal_W) * plane.n;
      hit = this->faces_->firstHit(this->x_W_, goal_W);
    }
    this->x_W_ = hit ? Vec3(hit->point_W + gap_u * planeTowards(*hit, this->x_W_, 0.0).n) : goal_W;
    return { this->x_W_, this->x_W_ - p_W };
  }

private:
  std::shared_ptr<const FaceTree> faces_;
  Vec3 x_W_ = Vec3::Zero();
};

} // namespace

std::unique_ptr<ContactMethod> makeAlternating(const World& world)
{
  return std::make_unique<Alternating>(world);
}

} // namespace palpate::lab
