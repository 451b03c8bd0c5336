// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "testing/lab/methods/Textbook.h"

namespace palpate::lab
{
namespace
{

class Penalty final : public ContactMethod
{
public:
  explicit Penalty(const World& world) : faces_(world.faces) {}

  void start(const Vec3&) override {}

  MethodTick tick(const Vec3& p_W) override
  {
    const Face face = this->faces_->nearest(p_W);
    const Vec3 force = std::max(0.0, face.normal_W.dot(face.point_W - p_W)) * face.normal_W;
    return { p_W + force, force };
  }

private:
  std::shared_ptr<const FaceTree> faces_;
};

} // namespace

std::unique_ptr<ContactMethod> makePenalty(const World& world)
{
  return std::make_unique<Penalty>(world);
}

} // namespace palpate::lab
