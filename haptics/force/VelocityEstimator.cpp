// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/force/VelocityEstimator.h"

#include <algorithm>

namespace palpate
{
namespace
{

void push(const Vec3& p_D, double dt_s, VelocityHistory& history) noexcept
{
  history.newest = (history.newest + 1) % VelocityHistory::capacity;
  history.count = std::min(history.count + 1, VelocityHistory::capacity);
  const auto at = static_cast<std::size_t>(history.newest);
  history.p_D[at] = p_D;
  history.dt_s[at] = dt_s;
}

const Vec3& position(const VelocityHistory& history, int k) noexcept
{
  return history.p_D[static_cast<std::size_t>(history.at(k))];
}

double interval_s(const VelocityHistory& history, int k) noexcept
{
  return history.dt_s[static_cast<std::size_t>(history.at(k))];
}

Vec3 backwardDifference(const VelocityHistory& history) noexcept
{
  return (position(history, 0) - position(history, 1)) / interval_s(history, 0);
}

/// Are all samples between now and n ticks ago within the encoder step of the line with this velocity through now?
bool explains(const VelocityHistory& history, const Vec3& velocity, int n, double resolution_m) noexcept
{
  double back_s = 0.0;
  for (int k = 1; k < n; ++k)
  {
    back_s += interval_s(history, k - 1);
    const Vec3 off = position(history, 0) - back_s * velocity - position(history, k);
    if (off.cwiseAbs().maxCoeff() > resolution_m)
    {
      return false;
    }
  }
  return true;
}

Vec3 adaptiveWindow(const VelocityFilter& filter, const VelocityHistory& history) noexcept
{
  Vec3 velocity = backwardDifference(history);
  double span_s = interval_s(history, 0);
  const int longest = std::min(filter.window, history.count - 1);
  for (int n = 2; n <= longest; ++n)
  {
    span_s += interval_s(history, n - 1);
    const Vec3 candidate = (position(history, 0) - position(history, n)) / span_s;
    if (!explains(history, candidate, n, filter.resolution_m))
    {
      break;
    }
    velocity = candidate;
  }
  return velocity;
}

} // namespace

Vec3 estimateVelocity(const VelocityFilter& filter, const Vec3& p_D, double dt_s, VelocityHistory& history) noexcept
{
  push(p_D, dt_s, history);
  if (history.count < 2 || !(dt_s > 0.0))
  {
    return Vec3::Zero();
  }
  switch (filter.method)
  {
    case VelocityMethod::LowPass:
      history.filtered_D += dt_s / (filter.lowPass_s + dt_s) * (backwardDifference(history) - history.filtered_D);
      return history.filtered_D;
    case VelocityMethod::AdaptiveWindow:
      return adaptiveWindow(filter, history);
    case VelocityMethod::BackwardDifference:
      break;
  }
  return backwardDifference(history);
}

} // namespace palpate
