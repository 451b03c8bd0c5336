// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/servo/SharedDents.h"

#include <algorithm>

#include "haptics/compliance/servo/SubgridForce.h"

namespace palpate
{
namespace
{

/// Relative difference of equal forces, by rounding.
constexpr double sameForce = 1e-14;

double sharedOf(const SoftContact& a, const SoftContact& b) noexcept
{
  const bool dented = a.soft && a.soft == b.soft && a.spring.hertz > 0.0 && b.spring.hertz > 0.0;
  return dented ? sharedBy(a.point, b.point) : 0.0;
}

} // namespace

SharedDents::SharedDents(std::span<const SoftContact> contacts) noexcept : contacts_(contacts)
{
  for (int e = 0; e < this->count(); ++e)
  {
    double sum = 0.0;
    for (int c = 0; c < this->count(); ++c)
    {
      this->share_[e][c] = sharedOf(contacts[e], contacts[c]);
      sum += this->share_[e][c];
    }
    this->weight_[e] = sum > 0.0 ? 1.0 / sum : 0.0;
    this->force_N_[e] = this->depth_u_[e] = Vec3::Zero();
  }
}

Vec3 SharedDents::forceOn(int e) const noexcept
{
  Vec3 force_N = Vec3::Zero();
  for (int c = 0; c < this->count(); ++c)
  {
    const SoftContact& contact = this->contacts_[c];
    force_N += this->share_[e][c] * contact.n.dot(contact.force_N) * contact.n;
  }
  return force_N;
}

bool SharedDents::press(Line line, double least_N_per_u) noexcept
{
  bool same = true;
  for (int e = 0; e < this->count(); ++e)
  {
    const SoftContact& at = this->contacts_[e];
    const Vec3 force_N = this->forceOn(e);
    same = same && (force_N - this->force_N_[e]).norm() <= sameForce * force_N.norm();
    this->force_N_[e] = force_N;
    const double size_N = std::max(force_N.norm(), least_N_per_u * at.point.patch_u);
    const SubgridDepth spring = subgridDepth(at.spring, size_N);
    const double secant = size_N > 0.0 ? spring.depth_u / size_N : 0.0;
    this->depth_u_[e] = this->weight_[e] * secant * force_N;
    this->across_[e] = this->weight_[e] * at.spring.across * spring.slope;
    const Vec3 along = size_N > 0.0 ? Vec3(force_N / size_N) : Vec3(Vec3::Zero());
    const double beyond = line == Line::Tangent ? spring.slope - secant : 0.0;
    for (int d = 0; d < this->count(); ++d)
    {
      const Vec3& n = this->contacts_[d].n;
      this->bends_[e][d] = this->weight_[e] * this->share_[e][d] * (secant * n + beyond * along.dot(n) * along);
    }
  }
  return same;
}

Vec3 SharedDents::depthAt(int c) const noexcept
{
  Vec3 depth_u = Vec3::Zero();
  for (int e = 0; e < this->count(); ++e)
  {
    depth_u += this->share_[e][c] * this->depth_u_[e];
  }
  return depth_u;
}

double SharedDents::acrossBetween(int c, int d) const noexcept
{
  double sum = 0.0;
  for (int e = 0; e < this->count(); ++e)
  {
    sum += this->share_[e][c] * this->across_[e] * this->share_[e][d];
  }
  return sum;
}

Vec3 SharedDents::asideAt(int c) const noexcept
{
  Vec3 aside_u = Vec3::Zero();
  for (int d = 0; d < this->count(); ++d)
  {
    const SoftContact& other = this->contacts_[d];
    aside_u += this->acrossBetween(c, d) * (other.force_N - other.n.dot(other.force_N) * other.n);
  }
  const Vec3& n = this->contacts_[c].n;
  return aside_u - n.dot(aside_u) * n;
}

double SharedDents::slopeBetween(int c, int d) const noexcept
{
  Vec3 bend = Vec3::Zero();
  for (int e = 0; e < this->count(); ++e)
  {
    bend += this->share_[e][c] * this->bends_[e][d];
  }
  return this->contacts_[c].n.dot(bend);
}

double SharedDents::energy() const noexcept
{
  double sum = 0.0;
  for (int e = 0; e < this->count(); ++e)
  {
    sum += this->weight_[e] * subgridEnergy(this->contacts_[e].spring, this->force_N_[e].norm());
    sum += 0.5 * this->contacts_[e].force_N.dot(this->asideAt(e));
  }
  return sum;
}

} // namespace palpate
