// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "haptics/session/background/WorkerList.h"
#include "haptics/session/tool/ToolChoice.h"
#include "haptics/tool/worker/HandHistory.h"
#include "haptics/tool/worker/ToolFollower.h"

namespace palpate
{

/// State of a tool for the user.
struct ToolStatus : WorkStatus
{
  std::string noWayOut; ///< why it can never leave the place where it was put, to follow its name. "": it can
};

/// A tool, the scene that it touches, and the part of that scene that is loaded.
struct ToolOrder
{
  ToolChoice choice;
  std::shared_ptr<const Scene> scene;
  LoadedRegion known;
  double period_s = 1e-3; ///< of an iteration

  [[nodiscard]] static ToolOrder of(const ToolChoice& choice, const WorkSurroundings& around)
  {
    return { choice, around.scene, around.known, around.period_s };
  }
  /// `known` is not compared: it matters only where a tool is put into another scene, and comes with that scene.
  friend bool operator==(const ToolOrder& a, const ToolOrder& b) { return a.choice == b.choice && a.scene == b.scene; }
  [[nodiscard]] bool isActive() const noexcept { return this->choice.tool != nullptr; }
  /// The construction of its trees is never cancelled.
  [[nodiscard]] static bool cancels(const ToolOrder& /*before*/) noexcept { return false; }
  [[nodiscard]] static bool awaits(const ToolOrder& /*before*/) noexcept { return false; }
};

/// Builds the surroundings of a tool, and moves the tool. During a construction the previous contacts act on the hand.
/// See WorkerList.
class ToolTask
{
public:
  using Choice = ToolChoice;
  using Order = ToolOrder;
  using Status = ToolStatus;
  static constexpr bool isHeld = true;
  [[nodiscard]] static ToolLinks& linksOf(auto& all) noexcept { return all.tool; }

  ToolTask(WorkerChannel<Order, Status>& channel, ToolLinks& links) : channel_(channel), links_(links) {}
  bool apply(Order order, const std::stop_token& stop, bool again);
  std::optional<double> iterate();
  void step(double time_s);
  void giveUp();
  /// Publishes a tool without contacts, so that the proxy sphere touches nothing until the tool is placed.
  void publishFirst() { this->publishNone(true); }

private:
  /// Publishes no contacts: there is no tool, or the tool has no pose.
  void publishNone(bool held);
  void placeIn(const Order& order);
  void publishBall(const Order& order);
  void report(std::string refusal, std::string noWayOut = {});
  [[nodiscard]] bool isSameBody(const Order& order) const;
  [[nodiscard]] bool isFeltAsBall(const Order& order);

  WorkerChannel<Order, Status>& channel_;
  ToolLinks& links_;
  Order now_;
  std::optional<ToolFollower> follower_;
  std::uint64_t revision_ = 0; ///< of the last contacts that were published
  bool stands_ = false;        ///< whether the tool has a pose in this body
  HandHistory came_;
  std::uint64_t ballBody_ = 0; ///< body of the limit below, which costs hundreds of traversals of trees
  double largestBall_u_ = 0.0; ///< radius limit in that body
};

} // namespace palpate
