// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/Neighbourhood.h"

#include <algorithm>

#include "haptics/contact/BoxTest.h"
#include "haptics/contact/DiscFilter.h"
#include "haptics/contact/TreeWalk.h"

namespace palpate
{

bool Neighbourhood::covers(const Motion& m) const noexcept
{
  const double furthest = std::max((m.x_W - this->centre_W_).norm(), (m.e_W - this->centre_W_).norm());
  return this->reach_u_ > 0.0 && furthest + m.r + 2 * m.tol <= this->reach_u_;
}

bool Neighbourhood::gather(const Scene& scene, const Motion& m, std::uint32_t budget, std::uint32_t& nodes) noexcept
{
  if (this->crowded_)
  {
    return false;
  }
  // Later motions of a tick are mostly shorter than this one and start where it ends.
  constexpr double room = 0.15;
  this->centre_W_ = m.x_W + 0.5 * m.d;
  this->reach_u_ = 1.1 * m.length + (1.0 + room) * m.r + 8 * m.tol;
  this->count_ = 0;
  this->extent_u_ = 0.0;
  Motion still = m;
  still.x_W = still.e_W = this->centre_W_;
  still.d = Vec3::Zero();
  still.dd = still.length = 0.0;
  still.r = this->reach_u_;
  const BoxTest test(still);
  const bool fits = walkWithin(scene.surfaceTree().nodes, test, budget, nodes,
    [&](std::uint32_t s) noexcept
    { return this->gatherSurface(scene.surfaces()[s].tree->data(), s, still, test, budget, nodes); });
  if (!fits)
  {
    this->crowded_ = true;
    this->reach_u_ = -1.0;
  }
  return fits;
}

bool Neighbourhood::gatherSurface(const SurfaceData& data, std::uint32_t surface, const Motion& still,
  const BoxTest& test, std::uint32_t budget, std::uint32_t& nodes) noexcept
{
  return walkWithin(data.nodes, test, budget, nodes,
    [&](std::uint32_t index) noexcept
    {
      const Leaf& leaf = data.leaves[index];
      const DiscFilter filter(still, leaf.origin_W, leaf.extent);
      const int lanes = filter.touched(data.discs[2 * index]) | filter.touched(data.discs[2 * index + 1]) << 4;
      for (std::uint32_t lane = 0; lane < leaf.count; ++lane)
      {
        if ((lanes >> lane) & 1)
        {
          if (this->count_ == capacity)
          {
            return false;
          }
          this->add(data, surface, index, lane);
        }
      }
      return true;
    });
}

void Neighbourhood::add(const SurfaceData& data, std::uint32_t surface, std::uint32_t leaf, std::uint32_t lane) noexcept
{
  const DiscQuad& from = data.discs[2 * leaf + lane / 4];
  const std::uint32_t k = lane % 4;
  const Vec3 shift = data.leaves[leaf].origin_W - this->centre_W_;
  this->extent_u_ = std::max(this->extent_u_, data.leaves[leaf].extent + shift.cwiseAbs().maxCoeff());
  DiscQuad& to = this->discs_[this->count_ / 4];
  const int at = this->count_ % 4;
  to.cx[at] = from.cx[k] + static_cast<float>(shift.x());
  to.cy[at] = from.cy[k] + static_cast<float>(shift.y());
  to.cz[at] = from.cz[k] + static_cast<float>(shift.z());
  to.nx[at] = from.nx[k];
  to.ny[at] = from.ny[k];
  to.nz[at] = from.nz[k];
  to.radius[at] = from.radius[k];
  this->faces_[this->count_++] = { surface, data.leaves[leaf].first + lane };
}

} // namespace palpate
