// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/view/ContactPlan.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/lab/backends/Backend.h"

namespace palpate::lab
{
namespace
{

class Ours final : public Backend
{
public:
  explicit Ours(const TriangleMesh& mesh)
    : scene_(SceneBuilder().build({ { "mesh", std::make_shared<TriangleMesh>(mesh), {} } }).scene)
  {
    if (this->scene_ == nullptr)
    {
      throw std::runtime_error("the mesh of a query cannot be touched");
    }
  }

  [[nodiscard]] bool meets(const Vec3& from_W, const Vec3& to_W) override { return this->sweep(from_W, to_W).hit; }

  [[nodiscard]] std::optional<double> firstHit(const Vec3& from_W, const Vec3& to_W) override
  {
    const SweepHit hit = this->sweep(from_W, to_W);
    return hit.hit ? std::optional(hit.t) : std::nullopt;
  }

private:
  [[nodiscard]] SweepHit sweep(const Vec3& from_W, const Vec3& to_W) const
  {
    return sweepBall(*this->scene_, straightQuery(from_W, to_W), ContactPlan().workBudget);
  }

  std::shared_ptr<const Scene> scene_;
};

} // namespace

std::unique_ptr<Backend> makeOurs(const TriangleMesh& mesh)
{
  return std::make_unique<Ours>(mesh);
}

} // namespace palpate::lab
