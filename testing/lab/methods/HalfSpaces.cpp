// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "testing/lab/methods/Planes.h"
#include "testing/lab/methods/Textbook.h"

namespace palpate::lab
{
namespace
{

class HalfSpaces final : public ContactMethod
{
public:
  explicit HalfSpaces(const World& world) : faces_(world.faces) {}

  void start(const Vec3& p_W) override { this->x_W_ = p_W; }

  MethodTick tick(const Vec3& p_W) override
  {
    this->x_W_ = nearestInFront(this->planesAround((p_W - this->x_W_).norm() + 4 * gap_u), p_W);
    return { this->x_W_, this->x_W_ - p_W };
  }

private:
  [[nodiscard]] std::vector<Plane> planesAround(double reach_u) const
  {
    constexpr std::size_t mostFaces = 256, mostPlanes = 24;
    std::vector<Plane> planes;
    for (const Face& face : this->faces_->within(this->x_W_, reach_u, mostFaces))
    {
      const Plane plane = planeTowards(face, this->x_W_, gap_u);
      const bool known = std::any_of(
        planes.begin(), planes.end(), [&plane](const Plane& other) { return same(plane, other, 0.5 * gap_u); });
      if (!known && planes.size() < mostPlanes)
      {
        planes.push_back(plane);
      }
    }
    return planes;
  }

  std::shared_ptr<const FaceTree> faces_;
  Vec3 x_W_ = Vec3::Zero();
};

} // namespace

std::unique_ptr<ContactMethod> makeHalfSpaces(const World& world)
{
  return std::make_unique<HalfSpaces>(world);
}

} // namespace palpate::lab
