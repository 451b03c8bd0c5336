// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/way/Trajectory.h"

#include <algorithm>
#include <limits>
#include <variant>

namespace palpate
{
namespace
{

/// The servo's own: all other periods are whole numbers of it.
double ownPeriod_s(const Recording& recording)
{
  double shortest_s = std::numeric_limits<double>::infinity();
  for (const RecordedEntry& entry : recording.entries)
  {
    if (const auto* tick = std::get_if<TickRecord>(&entry); tick != nullptr && tick->dt_s > 0.0)
    {
      shortest_s = std::min(shortest_s, tick->dt_s);
    }
  }
  return shortest_s;
}

bool isHeld(const TickRecord& tick)
{
  HapticState held;
  held.held = true;
  return (tick.flags & recordFlags(held)) != 0;
}

TrajectoryPoint pointOf(const TickRecord& tick, const WorkspaceMap& map)
{
  TrajectoryPoint point;
  point.tick = tick.tick;
  point.hand_W = map.toScene(tick.sample.pose_D.p);
  point.proxy_W = tick.proxy_W.p;
  point.force_W = map.directionToScene(tick.wrench_D.force);
  point.stiffnessShare = tick.lateness.stiffnessFactor;
  point.excess_J = tick.excess_J;
  point.contacts = tick.contacts;
  return point;
}

} // namespace

std::vector<TrajectoryPoint> trajectoryOf(const Recording& recording)
{
  const double period_s = ownPeriod_s(recording);
  WorkspaceMap map = recording.parameters.map;
  std::vector<TrajectoryPoint> points;
  double time_s = 0.0;
  bool first = true;
  for (const RecordedEntry& entry : recording.entries)
  {
    if (const auto* change = std::get_if<RecordedChange>(&entry))
    {
      map = change->parameters ? change->parameters->map : map;
      continue;
    }
    const auto& tick = std::get<TickRecord>(entry);
    time_s += first ? 0.0 : std::max(0.0, tick.dt_s); // not a number counts as nothing
    first = false;
    if (!isHeld(tick))
    {
      TrajectoryPoint point = pointOf(tick, map);
      point.time_s = time_s;
      point.lateness_s = std::max(0.0, tick.dt_s - period_s);
      points.push_back(point);
    }
  }
  return points;
}

} // namespace palpate
