// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/tool/ToolWorker.h"

#include <utility>

#include "haptics/contact/RadiusLimit.h"
#include "haptics/recording/inputs/Tools.h"
#include "haptics/session/tool/ToolSurroundings.h"

namespace palpate
{
namespace
{

/// False where the data around the tool are no longer loaded: there the tool would touch nothing that is felt.
bool isKnown(const LoadedRegion& known, const Scene& scene, const Pose& tool_W, const ToolMesh& tool)
{
  return known.geometry != scene.geometryHash() || known.has(tool_W.p, tool.reach_u);
}

} // namespace

std::optional<double> ToolTask::iterate()
{
  if (!this->follower_)
  {
    return std::nullopt;
  }
  this->follower_->step();
  this->came_.note(this->links_.hand.read(), *this->now_.choice.tool);
  this->revision_ = this->follower_->revision();
  const std::optional<Pose> tool_W = this->follower_->tool_W();
  if (tool_W && !this->stands_)
  {
    this->stands_ = true;
    this->report("", noWayOutOf(*this->now_.scene, *this->now_.choice.tool, *tool_W));
  }
  return this->now_.period_s;
}

void ToolTask::step(double /*time_s*/)
{
  (void)this->iterate();
}

void ToolTask::giveUp()
{
  this->follower_.reset();
  this->now_ = {};
  this->stands_ = false;
  this->publishNone(true);
  this->report("not enough memory to touch the visible data with a tool: show fewer data");
}

/// Above the radius limit of the scene a tick may fall behind the hand; the worker with the tool's mesh lags less.
bool ToolTask::isFeltAsBall(const Order& order)
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

bool ToolTask::apply(Order order, const std::stop_token& /*stop*/, bool /*again*/)
{
  if (order.choice.tool != this->now_.choice.tool)
  {
    this->came_ = {}; // the history of another tool
  }
  if (!order.choice.tool || !order.scene || order.scene->empty())
  {
    this->follower_.reset();
    this->publishNone(order.choice.tool != nullptr);
    this->report("");
  }
  else if (this->isFeltAsBall(order))
  {
    this->publishBall(order);
  }
  else if (order.choice == this->now_.choice && this->isSameBody(order))
  {
    this->follower_->carry(bodyPlaceOf(*order.scene));
  }
  else
  {
    this->placeIn(order);
  }
  this->now_ = std::move(order);
  return false;
}

bool ToolTask::isSameBody(const Order& order) const
{
  return this->follower_ && bodyNameOf(*this->now_.scene) == bodyNameOf(*order.scene) && !order.scene->bends();
}

/// The tick sweeps the ball itself, whatever moves, bends or is replaced: the worker has nothing to compute.
void ToolTask::publishBall(const Order& order)
{
  this->follower_.reset();
  this->stands_ = false;
  this->report("");
  ToolContacts ball;
  ball.held = ball.placed = true;
  ball.ball_u = order.choice.tool->ball_u();
  ball.characteristic_u = order.choice.weighs_u();
  ball.revision = ++this->revision_;
  this->links_.contacts.write(ball);
}

/// In another body, or with another tool, the tool stays at the pose of the previous one, if it is free there. Else, or
/// without a previous pose, the tool begins at the newest free pose of the hand's path.
void ToolTask::placeIn(const Order& order)
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
  this->report(around.refusal);
  if (!around.refusal.empty())
  {
    this->publishNone(true);
    return;
  }
  const std::uint64_t work = ToolFollower::workOf(tool, *around.mesh_S);
  this->follower_.emplace(ToolMove(tool, std::move(around.mesh_S), order.choice.weighs_u()), this->links_, work,
    ToolStart{ around.scene_WS, this->revision_, was_W, this->came_.newestFirst(this->links_.hand.read()) });
  this->revision_ = this->follower_->revision();
}

void ToolTask::report(std::string refusal, std::string noWayOut)
{
  this->channel_.report(
    [&](ToolStatus& status, const Order&)
    {
      status.problem = std::move(refusal);
      status.noWayOut = std::move(noWayOut);
    });
}

void ToolTask::publishNone(bool held)
{
  ToolContacts none;
  none.held = held;
  none.revision = ++this->revision_;
  this->links_.contacts.write(none);
}

} // namespace palpate
