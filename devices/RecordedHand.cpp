// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/RecordedHand.h"

#include <algorithm>
#include <variant>

namespace palpate
{
namespace
{

/// The pose in a device that lies in the scene as `to` says, at the place that it had as `from` said.
Pose inOtherMap(const Pose& pose_D, const WorkspaceMap& from, const WorkspaceMap& to)
{
  return { to.toDevice(from.toScene(pose_D.p)), to.q_WD.conjugate() * from.q_WD * pose_D.q };
}

} // namespace

RecordedHand recordedHand(const Recording& recording)
{
  RecordedHand hand;
  hand.map = recording.parameters.map;
  const GodObjectState& ball = recording.initialState.contact;
  hand.ball_W = ball.placed ? std::optional(ball.x_W) : std::nullopt;
  WorkspaceMap map = hand.map;
  for (const RecordedEntry& entry : recording.entries)
  {
    if (const auto* change = std::get_if<RecordedChange>(&entry))
    {
      map = change->parameters ? change->parameters->map : map;
      continue;
    }
    const auto& tick = std::get<TickRecord>(entry);
    if (tick.status != DeviceStatus::Waiting)
    {
      hand.samples.push_back(tick.sample);
      Pose& pose_D = hand.samples.back().pose_D;
      pose_D = isSame(map, hand.map) ? pose_D : inOtherMap(pose_D, map, hand.map);
    }
  }
  for (const RecordedScene& scene : recording.scenes)
  {
    hand.touched.push_back(scene.geometryHash);
  }
  return hand;
}

std::string otherSceneText(const RecordedHand& hand, std::uint64_t shown)
{
  const bool same = std::find(hand.touched.begin(), hand.touched.end(), shown) != hand.touched.end();
  if (hand.touched.empty() || same)
  {
    return {};
  }
  return shown == 0 ? "the recorded scene is not visible: the hand repeats its motion and touches nothing; show the "
                      "recorded data"
                    : "the visible scene differs from the recorded one: the hand repeats its motion and touches the "
                      "visible scene";
}

} // namespace palpate
