// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/servo/SoftEnergy.h"

#include <algorithm>
#include <cmath>

#include "haptics/compliance/servo/SharedDents.h"

namespace palpate
{
namespace
{

/// Elastic energy of a body, from the work of the forces beyond those of its snapshot.
class SnapshotEnergy
{
public:
  SnapshotEnergy(const SoftSurfaceRef& touch, const SoftState& state) noexcept
    : snapshot_(*touch.snapshot), state_(state)
  {
    for (int c = 0; c < state.count; ++c)
    {
      this->own_[c] = state.contacts[c].feature.surface == touch.surface;
    }
  }

  [[nodiscard]] double value() const noexcept
  {
    // f_S C (f - f_S) + (f - f_S) C (f - f_S) / 2 = (f C f - f_S C f_S) / 2, and the snapshot has the latter.
    return this->snapshot_.energy_Nu + 0.5 * this->ofContacts();
  }

private:
  [[nodiscard]] double ofContacts() const noexcept
  {
    double sum = 0.0;
    for (int c = 0; c < this->state_.count; ++c)
    {
      for (int d = 0; this->own_[c] && d < this->state_.count; ++d)
      {
        const SoftContact& a = this->state_.contacts[c];
        const SoftContact& b = this->state_.contacts[d];
        sum += this->own_[d] ? a.force_N.dot(complianceBetween(this->snapshot_, a.point, b.point) * b.force_N) : 0.0;
      }
    }
    return sum;
  }

  const ComplianceSnapshot& snapshot_;
  const SoftState& state_;
  std::array<bool, GodObjectState::maxFeatures> own_{};
};

} // namespace

double storedEnergy(std::span<const SoftSurfaceRef> soft, const SoftState& state, double coupling_N_per_u) noexcept
{
  double stored = 0.0;
  for (const SoftSurfaceRef& touch : soft)
  {
    stored += SnapshotEnergy(touch, state).value();
  }
  Vec3 force_N = Vec3::Zero();
  for (int c = 0; c < state.count; ++c)
  {
    force_N += state.contacts[c].force_N;
  }
  SharedDents dents({ state.contacts.data(), static_cast<std::size_t>(state.count) });
  (void)dents.press();
  return stored + dents.energy() + 0.5 * force_N.squaredNorm() / coupling_N_per_u;
}

double balanceEnergy(const EnergyBalancePlan& plan, double stored_Nu, double step_u, double felt_N, double force_N,
  EnergyBalance& balance) noexcept
{
  balance.taken_Nu += felt_N * step_u;
  if (force_N <= 0.0)
  {
    balance = {};
    return 0.0;
  }
  const double owed = std::max(stored_Nu - balance.taken_Nu, 0.0);
  const double most = std::min(owed / std::max(std::abs(step_u), plan.leastStep_u), plan.share * force_N);
  const double wanted = most * std::clamp(step_u / plan.leastStep_u, -1.0, 1.0); // else a hand at rest would be shaken
  balance.added_N += std::clamp(wanted - balance.added_N, -plan.slew_N, plan.slew_N);
  const double share_N = plan.share * force_N; // of a force that falls fast, too
  balance.added_N = std::clamp(balance.added_N, -share_N, share_N);
  return balance.added_N;
}

} // namespace palpate
