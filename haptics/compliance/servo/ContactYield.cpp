// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/servo/ContactYield.h"

#include <algorithm>
#include <limits>

#include "haptics/compliance/servo/SharedDents.h"

namespace palpate
{
namespace
{

/// Displacement of the surface under a contact.
Vec3 yieldOf(const SoftState& state, const SharedDents& dents, int c) noexcept
{
  const SoftContact& contact = state.contacts[c];
  Vec3 u = -dents.depthAt(c) - dents.asideAt(c);
  for (int d = 0; d < state.count; ++d)
  {
    u -= complianceOf(contact, state.contacts[d]) * state.contacts[d].force_N;
  }
  return u;
}

} // namespace

Mat3 complianceOf(const SoftContact& a, const SoftContact& b) noexcept
{
  return a.soft && a.soft == b.soft ? complianceBetween(*a.soft->snapshot, a.point, b.point) : Mat3(Mat3::Zero());
}

std::span<const SoftContact> contactsOf(const SoftState& state) noexcept
{
  return { state.contacts.data(), static_cast<std::size_t>(state.count) };
}

bool givesWay(const SoftState& state) noexcept
{
  return std::any_of(
    state.contacts.begin(), state.contacts.begin() + state.count, [](const SoftContact& c) { return c.gives; });
}

Yield yieldUnder(SoftState& state) noexcept
{
  Yield sum;
  SharedDents dents(contactsOf(state));
  (void)dents.press();
  double all_N = 0.0;
  for (int c = 0; c < state.count; ++c)
  {
    SoftContact& contact = state.contacts[c];
    contact.yielded_W = yieldOf(state, dents, c);
    const double size_N = contact.force_N.norm();
    sum.force_N += contact.force_N;
    sum.across_N += contact.force_N - contact.n.dot(contact.force_N) * contact.n;
    sum.yielded_W += size_N * contact.yielded_W;
    all_N += size_N;
  }
  sum.yielded_W = all_N > 0.0 ? Vec3(sum.yielded_W / all_N) : Vec3(Vec3::Zero());
  return sum;
}

int pressingFirst(SoftState& state) noexcept
{
  int pressing = 0;
  for (int c = 0; c < state.count; ++c)
  {
    if (state.contacts[c].force_N.squaredNorm() > 0.0)
    {
      std::swap(state.contacts[c], state.contacts[pressing++]);
    }
  }
  for (int c = pressing; c < state.count; ++c)
  {
    state.contacts[c].yielded_W = Vec3::Zero();
  }
  return pressing;
}

SlipStart::SlipStart(const SoftState& state) noexcept
{
  for (int c = 0; c < state.count; ++c)
  {
    const SoftContact& contact = state.contacts[c];
    if (contact.force_N.squaredNorm() > 0.0) // one without force has no slip to begin from
    {
      this->places_[this->count_++] = { contact.feature.surface, contact.n, state.yielded_W - contact.yielded_W };
    }
  }
}

void SlipStart::tell(SoftState& state) const noexcept
{
  constexpr double nearlySame = 0.984807753012208; // cosine of ten degrees, as forces are kept (SoftContacts)
  for (int c = 0; c < state.count; ++c)
  {
    SoftContact& contact = state.contacts[c];
    contact.aside_W = Vec3::Zero();
    for (int i = 0; i < this->count_; ++i)
    {
      const Place& place = this->places_[i];
      if (place.surface == contact.feature.surface && place.n.dot(contact.n) > nearlySame)
      {
        contact.aside_W = place.aside_W;
      }
    }
  }
}

double patchUnder(const SoftState& state) noexcept
{
  double patch_u = std::numeric_limits<double>::infinity();
  for (int c = 0; c < state.count; ++c)
  {
    patch_u = state.contacts[c].gives ? std::min(patch_u, state.contacts[c].point.patch_u) : patch_u;
  }
  return patch_u;
}

CommonYield::CommonYield(const SoftState& state, const Vec3& mean_W) noexcept : state_(state), mean_W_(mean_W)
{
  for (int c = 0; c < state.count; ++c)
  {
    const SoftContact& contact = state.contacts[c];
    if (contact.n.dot(contact.force_N) > 0.0)
    {
      this->touches(c, contact.n.dot(contact.yielded_W));
    }
  }
  this->u_W_ = this->solved_W();
}

void CommonYield::stayOut(const Vec3& y_W, double radius_u) noexcept
{
  for (int c = this->deepest(y_W, radius_u); c >= 0 && this->count_ < 3; c = this->deepest(y_W, radius_u))
  {
    this->touches(c, this->mostAlong(c, y_W, radius_u));
    this->u_W_ = this->solved_W();
  }
}

double CommonYield::mostAlong(int c, const Vec3& y_W, double radius_u) const noexcept
{
  return this->state_.contacts[c].n.dot(y_W - this->state_.contacts[c].foot_W) - radius_u;
}

int CommonYield::deepest(const Vec3& y_W, double radius_u) const noexcept
{
  int found = -1;
  double most_u = 0.0;
  for (int c = 0; c < this->state_.count; ++c)
  {
    const double deep_u = this->state_.contacts[c].n.dot(this->u_W_) - this->mostAlong(c, y_W, radius_u);
    if (!this->touched_[c] && deep_u > most_u)
    {
      most_u = deep_u;
      found = c;
    }
  }
  return found;
}

void CommonYield::touches(int c, double along_u) noexcept
{
  const Vec3& n = this->state_.contacts[c].n;
  this->touched_[c] = true;
  ++this->count_;
  this->planes_ += n * n.transpose();
  this->missed_W_ += (along_u - n.dot(this->mean_W_)) * n;
}

Vec3 CommonYield::solved_W() const noexcept
{
  constexpr double rounding = 1e-8;
  // Without a plane the mean stays. Refinement corrects the error of that along two planes of nearly one normal.
  const Eigen::LDLT<Mat3> factor((this->planes_ + rounding * Mat3::Identity()).ldlt());
  Vec3 way_W = factor.solve(this->missed_W_);
  for (int again = 0; again < 3; ++again)
  {
    way_W += factor.solve(this->missed_W_ - this->planes_ * way_W);
  }
  return this->mean_W_ + way_W;
}

} // namespace palpate
