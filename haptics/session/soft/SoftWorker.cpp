// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/soft/SoftWorker.h"

#include <utility>

#include "haptics/recording/inputs/Bodies.h"
#include "haptics/session/soft/SoftAside.h"

namespace palpate
{

SoftTask::SoftTask(WorkerChannel<Order, Status>& channel, SoftLinks& links) : channel_(channel), links_(links) {}

SoftTask::~SoftTask() = default;

std::optional<double> SoftTask::iterate()
{
  if (!this->maker_)
  {
    return std::nullopt;
  }
  const BodyHand& hand = this->links_.hand.read();
  const auto body = this->maker_->press(hand, this->period_s());
  if (body && !this->aside_)
  {
    // The first shape is published with the first snapshot; no later snapshot waits for a shape.
    this->show(this->maker_->shape());
    this->aside_ = std::make_unique<SoftAside>([this](BodyShape shape) { this->show(std::move(shape)); });
  }
  this->publish(body);
  if (body)
  {
    this->aside_->look(this->maker_->sight());
    if (hand.tick > 0) // before the first tick the hand's position is unknown
    {
      this->aside_->condense(this->maker_->keepAround(hand.ball_W));
    }
  }
  return this->period_s();
}

void SoftTask::step(double time_s)
{
  if (!this->maker_)
  {
    return;
  }
  const std::shared_ptr<const PressedBody> before = this->paced_->now();
  (void)this->paced_->at(time_s, this->links_.hand.read());
  if (this->paced_->now() == before)
  {
    return;
  }
  if (this->paced_->now())
  {
    this->show(this->maker_->shape());
  }
  this->publish(this->paced_->now());
}

void SoftTask::show(BodyShape shape)
{
  this->channel_.report([shown = std::make_shared<const BodyShape>(std::move(shape))](SoftStatus& status, const Order&)
    { status.shape = shown; });
}

void SoftTask::giveUp()
{
  this->aside_.reset();
  this->paced_.reset();
  this->maker_.reset();
  this->channel_.report(
    [](SoftStatus& status, const Order&)
    {
      status = {};
      status.problem = "not enough memory for the soft body: use a coarser mesh";
    });
}

bool SoftTask::apply(Order order, const std::stop_token& stop, bool again)
{
  const Order before = std::exchange(this->now_, std::move(order));
  const bool interrupted = (again || this->now_.cancels(before)) && this->build(stop);
  if (this->maker_)
  {
    this->maker_->touch(this->now_.beside);
    if (this->period_s() != workerPeriod_s(before.choice.rate_Hz))
    {
      this->paced_.emplace(*this->maker_, this->period_s());
    }
  }
  return interrupted;
}

bool SoftTask::build(const std::stop_token& stop)
{
  this->aside_.reset();
  this->paced_.reset();
  this->maker_.reset();
  this->links_.bodies.publish(nullptr);
  SoftStatus made;
  if (this->now_.isActive())
  {
    this->maker_ =
      BodyMaker::make(*this->now_.choice.input, this->now_.choice.name, this->revision_, made.problem, stop);
  }
  if (this->maker_)
  {
    made.asMade = std::make_shared<const CheckedTetras>(this->maker_->checked());
    this->paced_.emplace(*this->maker_, this->period_s());
  }
  this->channel_.report(
    [&](SoftStatus& status, const Order& wanted)
    {
      const bool stopped = stop.stop_requested();
      status = stopped ? SoftStatus{} : std::move(made);
      status.building = stopped && wanted.isActive();
    });
  return !this->maker_ && stop.stop_requested();
}

void SoftTask::publish(std::shared_ptr<const PressedBody> body)
{
  this->channel_.report(
    [&](SoftStatus& status, const Order&)
    {
      status.problem = body ? ""
                            : "The stiffness matrix of the soft body is no longer positive definite (the body is "
                              "overloaded). The last shape is kept; release the body";
      status.snapshots += body ? 1 : 0;
    });
  if (body)
  {
    this->revision_ = body->revision;
    this->links_.bodies.publish(std::move(body));
  }
}

} // namespace palpate
