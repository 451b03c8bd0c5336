// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "haptics/contact/view/KnownPart.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/tool/worker/HandHistory.h"
#include "haptics/tool/worker/ToolFollower.h"

namespace palpate
{

/// What a hand holds in place of the ball.
struct ToolChoice
{
  std::shared_ptr<const ToolMesh> tool; ///< null: none
  double lever_u = 0.0;                 ///< what a turn by 1 rad weighs as a way; 0: the tool's own

  /// The lever that counts; 0: no tool.
  [[nodiscard]] double weighs_u() const noexcept
  {
    return !this->tool ? 0.0 : this->lever_u > 0.0 ? this->lever_u : this->tool->gyration_u;
  }
  friend bool operator==(const ToolChoice&, const ToolChoice&) = default;
};

/// The tool of a session, and the thread that moves it beside the servo. It builds what the tool touches, too: while it
/// does, the contacts of before hold the hand. Its owner never waits for it, but for its end.
class HeldTool
{
public:
  /// The links must outlive it. In virtual time there is no thread: see step().
  HeldTool(ToolLinks& links, bool virtualTime, std::int64_t period_ns);
  ~HeldTool();
  HeldTool(const HeldTool&) = delete;
  HeldTool& operator=(const HeldTool&) = delete;

  void take(const ToolChoice& choice);
  /// `known`: how much of a whole that scene has.
  void touch(std::shared_ptr<const Scene> scene, const KnownPart& known = {});
  /// What its thread does once, in the caller's. Virtual time.
  void step();
  /// Why the tool cannot touch the scene; "": it can, or nothing is held.
  [[nodiscard]] std::string refusal() const;
  /// It was put where it is free and can never leave: why, to follow its name. "": it can.
  [[nodiscard]] std::string noWayOut() const;

private:
  struct Order
  {
    ToolChoice choice;
    std::shared_ptr<const Scene> scene;
    KnownPart known;
  };
  void give(const Order& order);
  void run(const std::stop_token& stop);
  [[nodiscard]] Order wanted() const;
  void tryToObey(Order order);
  void obey(Order order);
  void putIn(const Order& order);
  void tellBall(const Order& order);
  void say(std::string refusal, std::string noWayOut = {});
  void tellWaiting(bool held);
  void follow();
  [[nodiscard]] bool isSameBody(const Order& order) const;
  [[nodiscard]] bool isFeltAsBall(const Order& order);

  ToolLinks& links_;
  bool virtualTime_;
  std::int64_t period_ns_;

  mutable std::mutex mutex_; ///< between owner and thread; guards the next five, news_ where it is waited for
  Order wanted_;
  std::atomic<bool> news_ = false; ///< asked without the lock in each step
  std::condition_variable_any asked_;
  std::string refusal_, noWayOut_;

  // Of the thread alone.
  Order now_;
  std::optional<ToolFollower> follower_;
  std::uint64_t revision_ = 0; ///< of the last set that was told
  bool stands_ = false;        ///< in this body
  HandHistory came_;
  std::uint64_t ballBody_ = 0; ///< the body that the next is of: it costs hundreds of walks through trees
  double largestBall_u_ = 0.0; ///< that a tick can follow there

  std::jthread thread_; ///< last: it ends before what it uses
};

} // namespace palpate
