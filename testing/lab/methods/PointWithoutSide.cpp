// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/methods/Planes.h"
#include "testing/lab/methods/Textbook.h"

namespace palpate::lab
{
namespace
{

class PointWithoutSide final : public ContactMethod
{
public:
  explicit PointWithoutSide(const World& world) : faces_(world.faces) {}

  void start(const Vec3& p_W) override { this->x_W_ = p_W; }

  MethodTick tick(const Vec3& p_W) override
  {
    const auto hit = this->faces_->firstHit(this->x_W_, p_W);
    this->x_W_ = hit ? nearestInFront({ planeTowards(*hit, this->x_W_, gap_u) }, p_W) : p_W;
    return { this->x_W_, this->x_W_ - p_W };
  }

private:
  std::shared_ptr<const FaceTree> faces_;
  Vec3 x_W_ = Vec3::Zero();
};

} // namespace

std::unique_ptr<ContactMethod> makePointWithoutSide(const World& world)
{
  return std::make_unique<PointWithoutSide>(world);
}

} // namespace palpate::lab
