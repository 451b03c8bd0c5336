// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/soft/SoftWorker.h"

#include <utility>

#include "haptics/session/beside/InItsMemory.h"

namespace palpate
{
namespace
{

/// As often or not.
bool isSameBody(const SoftChoice& a, const SoftChoice& b)
{
  return a.input == b.input && a.name == b.name;
}

double periodOf(const SoftChoice& choice)
{
  return PacedThread::periodOf(choice.rate_Hz);
}

} // namespace

void SoftWorker::take(const SoftChoice& choice)
{
  this->give({ choice, this->wanted_.beside, {} });
}

void SoftWorker::touch(std::shared_ptr<const Scene> beside)
{
  this->give({ this->wanted_.choice, std::move(beside), {} });
}

/// A session without a soft body has no thread for one.
void SoftWorker::give(Order order)
{
  const bool hasBody = order.choice.input != nullptr;
  {
    const std::lock_guard lock(this->mutex_);
    const bool told = hasBody || this->wanted_.choice.input;
    const bool other = !isSameBody(order.choice, this->wanted_.choice);
    this->status_.building = this->status_.building || (hasBody && other);
    if (other)
    {
      this->building_.request_stop();
      this->building_ = std::stop_source();
    }
    order.stop = this->building_.get_token();
    this->wanted_ = std::move(order);
    this->news_ = this->news_ || told;
  }
  if (hasBody && !this->virtualTime_ && !this->thread_.runs())
  {
    this->thread_.begin([this] { return this->run(); });
  }
}

/// Until when it need not be asked again.
double SoftWorker::run()
{
  double period_s = PacedThread::idle_s;
  inItsMemory(
    [&]
    {
      this->obey();
      if (this->maker_)
      {
        period_s = periodOf(this->now_.choice);
        this->publish(this->maker_->press(this->links_.hand.read(), period_s));
      }
    },
    [this] { this->giveUp(); });
  return period_s;
}

void SoftWorker::step(double time_s)
{
  inItsMemory(
    [&]
    {
      this->obey();
      if (!this->maker_)
      {
        return;
      }
      const std::shared_ptr<const PressedBody> before = this->paced_->now();
      (void)this->paced_->at(time_s, this->links_.hand.read());
      if (this->paced_->now() != before)
      {
        this->publish(this->paced_->now());
      }
    },
    [this] { this->giveUp(); });
}

void SoftWorker::giveUp()
{
  this->paced_.reset();
  this->maker_.reset();
  const std::lock_guard lock(this->mutex_);
  this->status_ = {};
  this->status_.problem = "the soft body is too large: memory is used up; mesh it coarser";
}

void SoftWorker::obey()
{
  if (!this->news_.exchange(false))
  {
    return;
  }
  const Order before = this->now_;
  {
    const std::lock_guard lock(this->mutex_);
    this->now_ = this->wanted_;
  }
  if (this->stopped_ || !isSameBody(this->now_.choice, before.choice))
  {
    this->build(this->now_);
  }
  if (this->maker_)
  {
    this->maker_->touch(this->now_.beside);
    if (periodOf(this->now_.choice) != periodOf(before.choice))
    {
      this->paced_.emplace(*this->maker_, periodOf(this->now_.choice));
    }
  }
}

void SoftWorker::build(const Order& order)
{
  this->paced_.reset();
  this->maker_.reset();
  this->links_.bodies.publish(nullptr);
  SoftStatus status;
  if (order.choice.input)
  {
    this->maker_ = BodyMaker::make(*order.choice.input, order.choice.name, this->revision_, status.problem, order.stop);
  }
  if (this->maker_)
  {
    status.asMade = std::make_shared<const CheckedTetras>(this->maker_->checked());
    this->paced_.emplace(*this->maker_, periodOf(order.choice));
  }
  this->stopped_ = !this->maker_ && order.stop.stop_requested();
  const std::lock_guard lock(this->mutex_);
  if (order.stop.stop_requested())
  {
    status = {};
    status.building = this->wanted_.choice.input != nullptr;
  }
  this->status_ = std::move(status);
}

/// Told to the owner first: what the servo takes must be there for a recording.
void SoftWorker::publish(std::shared_ptr<const PressedBody> body)
{
  const auto shape = body ? std::make_shared<const BodyShape>(this->maker_->shape()) : nullptr;
  {
    const std::lock_guard lock(this->mutex_);
    if (!body)
    {
      this->status_.problem = "the soft body's stiffness can no more be factored: it stays as it was; let go of it";
      return;
    }
    this->status_.problem.clear();
    ++this->status_.packets;
    this->status_.shape = shape;
  }
  this->made_.put(body);
  this->revision_ = body->revision;
  this->links_.bodies.publish(std::move(body));
}

SoftStatus SoftWorker::status() const
{
  const std::lock_guard lock(this->mutex_);
  return this->status_;
}

} // namespace palpate
