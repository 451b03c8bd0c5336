// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "haptics/contact/view/KnownPart.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/session/background/BackgroundWorker.h"
#include "haptics/session/tool/ToolChoice.h"
#include "haptics/tool/worker/HandHistory.h"
#include "haptics/tool/worker/ToolFollower.h"

namespace palpate
{

/// How a tool is, for a person to read.
struct ToolStatus
{
  std::string refusal;  ///< why the tool cannot touch the scene; "": it can, or nothing is held
  std::string noWayOut; ///< it was put where it is free and can never leave: why, to follow its name. "": it can
};

/// A tool, the scene that it touches, and how much of a whole that scene has.
struct ToolOrder
{
  ToolChoice choice;
  std::shared_ptr<const Scene> scene;
  KnownPart known;

  [[nodiscard]] bool isActive() const noexcept { return this->choice.tool != nullptr; }
  /// Its trees are built to their end.
  [[nodiscard]] static bool cancels(const ToolOrder& /*before*/) noexcept { return false; }
  static void announce(const ToolOrder& /*before*/, ToolStatus& /*status*/) noexcept {}
};

/// Builds the surroundings of a tool, and moves the tool. While it builds, the contacts of before hold the hand. See
/// BackgroundWorker.
class ToolTask
{
public:
  using Order = ToolOrder;
  using Status = ToolStatus;

  ToolTask(WorkerChannel<Order, Status>& channel, ToolLinks& links, std::int64_t period_ns)
    : channel_(channel), links_(links), period_s_(1e-9 * static_cast<double>(period_ns))
  {
  }
  bool apply(Order order, const std::stop_token& stop, bool again);
  std::optional<double> iterate();
  void step(double time_s);
  void giveUp();
  /// No contacts: there is no tool, or it stands nowhere.
  void publishNone(bool held);

private:
  void placeIn(const Order& order);
  void publishBall(const Order& order);
  void report(std::string refusal, std::string noWayOut = {});
  [[nodiscard]] bool isSameBody(const Order& order) const;
  [[nodiscard]] bool isFeltAsBall(const Order& order);

  WorkerChannel<Order, Status>& channel_;
  ToolLinks& links_;
  double period_s_;
  Order now_;
  std::optional<ToolFollower> follower_;
  std::uint64_t revision_ = 0; ///< of the last set that was published
  bool stands_ = false;        ///< in this body
  HandHistory came_;
  std::uint64_t ballBody_ = 0; ///< the body that the next is of: it costs hundreds of walks through trees
  double largestBall_u_ = 0.0; ///< that a tick can follow there
};

/// The tool of a session, and the thread that moves it beside the servo.
class ToolWorker : public BackgroundWorker<ToolTask>
{
public:
  /// The links must outlive it.
  ToolWorker(ToolLinks& links, bool virtualTime, std::int64_t period_ns)
    : BackgroundWorker(virtualTime, links, period_ns)
  {
  }

  void setTool(const ToolChoice& choice) { this->change({ choice, this->wanted().scene, this->wanted().known }); }
  /// `known`: how much of a whole that scene has.
  void setScene(std::shared_ptr<const Scene> scene, const KnownPart& known = {})
  {
    this->change({ this->wanted().choice, std::move(scene), known });
  }

private:
  /// Before there is a thread, the owner says that a tool is held, so that the ball touches nothing meanwhile.
  void change(Order order)
  {
    if (this->begins(order))
    {
      this->task().publishNone(true);
    }
    this->order(std::move(order));
  }
};

} // namespace palpate
