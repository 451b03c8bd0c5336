// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/labyrinth/WayTrace.h"

namespace palpate
{

void WayTrace::add(const Vec3& p_W)
{
  this->keep(p_W);
  if (this->points_W_.size() < most)
  {
    return;
  }
  while (this->points_W_.size() > most / 2)
  {
    this->apart_u_ *= 2.0;
    std::vector<Vec3> all_W;
    all_W.swap(this->points_W_);
    for (const Vec3& old_W : all_W)
    {
      this->keep(old_W);
    }
  }
}

void WayTrace::keep(const Vec3& p_W)
{
  if (this->points_W_.empty() || (p_W - this->points_W_.back()).norm() >= this->apart_u_)
  {
    this->points_W_.push_back(p_W);
  }
}

} // namespace palpate
