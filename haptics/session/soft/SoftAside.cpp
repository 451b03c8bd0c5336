// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/soft/SoftAside.h"

#include <sys/resource.h>

#include <algorithm>
#include <new>
#include <utility>

namespace palpate
{
namespace
{

constexpr std::chrono::milliseconds betweenLooks(33); // a frame of a view; after longer work the thread rests as long

/// In Linux the priority belongs to the thread.
void giveWay() noexcept
{
  constexpr int nice = 10;
  (void)setpriority(PRIO_PROCESS, 0, nice);
}

} // namespace

SoftAside::SoftAside(Publish publish)
  : publish_(std::move(publish)), thread_([this](const std::stop_token& stop) { this->run(stop); })
{
}

void SoftAside::look(BodySight sight)
{
  {
    const std::lock_guard lock(this->mutex_);
    this->work_.sight = std::move(sight);
  }
  this->changed_.notify_one();
}

void SoftAside::condense(std::shared_ptr<KeptInverse> kept)
{
  if (!kept)
  {
    return;
  }
  {
    const std::lock_guard lock(this->mutex_);
    this->work_.kept = std::move(kept);
  }
  this->changed_.notify_one();
}

/// Waits for work. A shape is not computed before its time; meanwhile nodes are condensed, if there are any.
SoftAside::Work SoftAside::next(const std::stop_token& stop, Clock::time_point nextLook)
{
  std::unique_lock lock(this->mutex_);
  this->changed_.wait(lock, stop, [this] { return this->work_.sight || this->work_.kept; });
  this->changed_.wait_until(lock, stop, nextLook, [this] { return this->work_.kept != nullptr; });
  Work work{ {}, this->work_.kept };
  if (Clock::now() >= nextLook)
  {
    work.sight = std::exchange(this->work_.sight, std::nullopt);
  }
  return work;
}

/// Without enough memory the last shape stays.
void SoftAside::lookAt(const BodySight& sight)
{
  try
  {
    this->publish_(shapeOf(sight));
  }
  catch (const std::bad_alloc&)
  {
  }
}

void SoftAside::condenseNext(const std::shared_ptr<KeptInverse>& kept)
{
  bool more = false;
  try
  {
    more = kept->condenseNext();
  }
  catch (const std::bad_alloc&) // the factor answers requests beyond the condensed nodes
  {
  }
  const std::lock_guard lock(this->mutex_);
  if (!more && this->work_.kept == kept)
  {
    this->work_.kept.reset();
  }
}

void SoftAside::run(const std::stop_token& stop)
{
  giveWay();
  auto nextLook = Clock::now();
  while (!stop.stop_requested())
  {
    const Work work = this->next(stop, nextLook);
    if (work.sight && !stop.stop_requested())
    {
      const auto begin = Clock::now();
      this->lookAt(*work.sight);
      nextLook = Clock::now() + std::max<Clock::duration>(betweenLooks, Clock::now() - begin);
    }
    if (work.kept && !stop.stop_requested())
    {
      this->condenseNext(work.kept);
    }
  }
}

} // namespace palpate
