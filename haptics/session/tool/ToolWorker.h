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

/// How a tool is, for a person to read.
struct ToolStatus : WorkStatus
{
  std::string noWayOut; ///< it was put where it is free and can never leave: why, to follow its name. "": it can
};

/// A tool, the scene that it touches, and how much of a whole that scene has.
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
  /// What is known counts where a tool is put into another scene, which comes with it.
  friend bool operator==(const ToolOrder& a, const ToolOrder& b) { return a.choice == b.choice && a.scene == b.scene; }
  [[nodiscard]] bool isActive() const noexcept { return this->choice.tool != nullptr; }
  /// Its trees are built to their end.
  [[nodiscard]] static bool cancels(const ToolOrder& /*before*/) noexcept { return false; }
  [[nodiscard]] static bool awaits(const ToolOrder& /*before*/) noexcept { return false; }
};

/// Builds the surroundings of a tool, and moves the tool. While it builds, the contacts of before hold the hand. See
/// WorkerList.
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
  /// A tool is held, so that the ball touches nothing until there is more of it.
  void publishFirst() { this->publishNone(true); }

private:
  /// No contacts: there is no tool, or it stands nowhere.
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
  std::uint64_t revision_ = 0; ///< of the last set that was published
  bool stands_ = false;        ///< in this body
  HandHistory came_;
  std::uint64_t ballBody_ = 0; ///< the body that the next is of: it costs hundreds of walks through trees
  double largestBall_u_ = 0.0; ///< that a tick can follow there
};

} // namespace palpate
