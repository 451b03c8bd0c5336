// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/tool/HeldTool.h"

#include <new>
#include <utility>

#include "haptics/contact/RadiusLimit.h"
#include "haptics/realtime/PeriodicTimer.h"
#include "haptics/session/tool/ToolSurroundings.h"

namespace palpate
{
namespace
{

/// A tool that was left behind where nothing is known any more touches nothing that is felt.
bool isKnown(const KnownPart& known, const Scene& scene, const Pose& tool_W, const ToolMesh& tool)
{
  return known.geometry != scene.geometryHash() || known.has(tool_W.p, tool.reach_u);
}

} // namespace

HeldTool::HeldTool(ToolLinks& links, bool virtualTime, std::int64_t period_ns)
  : links_(links), virtualTime_(virtualTime), period_ns_(period_ns)
{
}

HeldTool::~HeldTool() = default;

void HeldTool::take(const ToolChoice& choice)
{
  this->give({ choice, this->wanted_.scene, this->wanted_.known });
}

void HeldTool::touch(std::shared_ptr<const Scene> scene, const KnownPart& known)
{
  this->give({ this->wanted_.choice, std::move(scene), known });
}

/// A session without a tool has no thread for one. Before there is one, its owner says that a tool is held, so that the
/// ball touches nothing meanwhile.
void HeldTool::give(const Order& order)
{
  {
    const std::lock_guard lock(this->mutex_);
    const bool toldTool =
      order.choice.tool || this->wanted_.choice.tool; // without one, scenes are none of its business
    this->wanted_ = order;
    this->news_ = this->news_ || toldTool;
  }
  this->asked_.notify_one();
  if (order.choice.tool && !this->virtualTime_ && !this->thread_.joinable())
  {
    this->tellWaiting(true);
    this->thread_ = std::jthread([this](const std::stop_token& stop) { this->run(stop); });
  }
}

/// With nothing to move it sleeps until its owner asks for something.
void HeldTool::run(const std::stop_token& stop)
{
  while (!stop.stop_requested())
  {
    {
      std::unique_lock lock(this->mutex_);
      this->asked_.wait(lock, stop, [this] { return this->news_.load(); });
    }
    this->step();
    for (PeriodicTimer timer(this->period_ns_); this->follower_ && !stop.stop_requested(); this->step())
    {
      timer.wait();
    }
  }
}

void HeldTool::step()
{
  if (this->news_.exchange(false))
  {
    this->tryToObey(this->wanted());
  }
  if (this->follower_)
  {
    this->follow();
  }
}

void HeldTool::follow()
{
  this->follower_->step();
  this->came_.note(this->links_.hand.read(), *this->now_.choice.tool);
  this->revision_ = this->follower_->revision();
  const std::optional<Pose> tool_W = this->follower_->tool_W();
  if (tool_W && !this->stands_)
  {
    this->stands_ = true;
    this->say("", noWayOutOf(*this->now_.scene, *this->now_.choice.tool, *tool_W));
  }
}

HeldTool::Order HeldTool::wanted() const
{
  const std::lock_guard lock(this->mutex_);
  return this->wanted_;
}

/// No room in memory for a tree of the scene is no reason to end the program that asked for it.
void HeldTool::tryToObey(Order order)
{
  try
  {
    this->obey(std::move(order));
  }
  catch (const std::bad_alloc&)
  {
    this->follower_.reset();
    this->now_ = {};
    this->stands_ = false;
    this->tellWaiting(true);
    this->say("what is shown is too large for a tool to touch: memory is used up; show less of it");
  }
}

/// Beyond the largest ball of a scene a tick may fall behind, which its mesh beside the tick does less.
bool HeldTool::isFeltAsBall(const Order& order)
{
  const double ball_u = order.choice.tool->ball_u();
  if (!(ball_u > 0.0))
  {
    return false;
  }
  if (const std::uint64_t body = bodyNameOf(*order.scene); this->ballBody_ != body)
  {
    this->ballBody_ = body;
    this->largestBall_u_ = radiusLimit(*order.scene, {}).largest_u;
  }
  return ball_u <= this->largestBall_u_;
}

void HeldTool::obey(Order order)
{
  if (order.choice.tool != this->now_.choice.tool)
  {
    this->came_ = {}; // where another tool was led
  }
  if (!order.choice.tool || !order.scene || order.scene->empty())
  {
    this->follower_.reset();
    this->tellWaiting(order.choice.tool != nullptr);
    this->say("");
  }
  else if (this->isFeltAsBall(order))
  {
    this->tellBall(order);
  }
  else if (order.choice == this->now_.choice && this->isSameBody(order))
  {
    this->follower_->carry(bodyPlaceOf(*order.scene));
  }
  else
  {
    this->putIn(order);
  }
  this->now_ = std::move(order);
}

bool HeldTool::isSameBody(const Order& order) const
{
  return this->follower_ && bodyNameOf(*this->now_.scene) == bodyNameOf(*order.scene) && !order.scene->bends();
}

/// The tick sweeps it, whatever moves, bends or is replaced: there is nothing to be done beside it.
void HeldTool::tellBall(const Order& order)
{
  this->follower_.reset();
  this->stands_ = false;
  this->say("");
  ToolContacts ball;
  ball.held = ball.placed = true;
  ball.ball_u = order.choice.tool->ball_u();
  ball.lever_u = order.choice.weighs_u();
  ball.revision = ++this->revision_;
  this->links_.contacts.write(ball);
}

/// In another body, and with another tool, it stays where the one before was, if it is free there. Else, and where it
/// stood nowhere, it goes on from where the hand came from and it is free.
void HeldTool::putIn(const Order& order)
{
  const ToolMesh& tool = *order.choice.tool;
  ToolSurroundings around = surroundingsOf(*order.scene, tool);
  std::optional<Pose> was_W = this->follower_ ? this->follower_->tool_W() : std::nullopt;
  if (was_W && !isKnown(order.known, *order.scene, *was_W, tool))
  {
    was_W.reset();
  }
  this->follower_.reset();
  this->stands_ = false;
  this->say(around.refusal);
  if (!around.refusal.empty())
  {
    this->tellWaiting(true);
    return;
  }
  this->follower_.emplace(ToolMove(tool, std::move(around.mesh_S), order.choice.weighs_u()), this->links_,
    ToolFollower::usualWork,
    ToolStart{ around.scene_WS, this->revision_, was_W, this->came_.newestFirst(this->links_.hand.read()) });
  this->revision_ = this->follower_->revision();
}

void HeldTool::say(std::string refusal, std::string noWayOut)
{
  const std::lock_guard lock(this->mutex_);
  this->refusal_ = std::move(refusal);
  this->noWayOut_ = std::move(noWayOut);
}

std::string HeldTool::refusal() const
{
  const std::lock_guard lock(this->mutex_);
  return this->refusal_;
}

std::string HeldTool::noWayOut() const
{
  const std::lock_guard lock(this->mutex_);
  return this->noWayOut_;
}

/// No contacts: there is no tool, or it stands nowhere.
void HeldTool::tellWaiting(bool held)
{
  ToolContacts none;
  none.held = held;
  none.revision = ++this->revision_;
  this->links_.contacts.write(none);
}

} // namespace palpate
