// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/SimplerSearch.h"

#include <chrono>
#include <utility>

#include "haptics/contact/RadiusLimit.h"

namespace palpate
{

SimplerSearch::~SimplerSearch()
{
  this->cancel();
  if (this->running_.valid())
  {
    this->running_.wait();
  }
}

bool SimplerSearch::follow(std::shared_ptr<const Scene> full, std::vector<SurfaceChoice> choices,
  const SimplifyRules& rules, std::uint64_t revision)
{
  this->cancel();
  this->next_ = Order{ std::move(full), std::move(choices), rules, revision };
  return !this->running_.valid() && this->launch();
}

void SimplerSearch::cancel()
{
  this->stop_.request_stop();
  this->next_.reset();
}

bool SimplerSearch::launch()
{
  this->stop_ = std::stop_source();
  this->next_->rules.stop = this->stop_.get_token();
  Order order = *std::exchange(this->next_, std::nullopt);
  const bool known = this->simplifier_.knows(*order.full, order.choices, order.rules);
  this->running_ = std::async(known ? std::launch::deferred : std::launch::async,
    [this, order = std::move(order)]() mutable { return this->look(std::move(order)); });
  if (known)
  {
    this->running_.wait();
  }
  return known;
}

FoundScene SimplerSearch::look(Order order)
{
  FoundScene found{ this->simplifier_.simplify(*order.full, std::move(order.choices), order.rules, order.revision) };
  found.largestRadius_u = found.scene ? radiusLimit(*found.scene, {}).largest_u : 0.0;
  return found;
}

std::optional<FoundScene> SimplerSearch::poll()
{
  if (!this->running_.valid() || this->running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
  {
    return std::nullopt;
  }
  const bool wanted = !this->stop_.stop_requested();
  FoundScene found = this->running_.get();
  if (this->next_)
  {
    this->launch();
  }
  return wanted ? std::optional(std::move(found)) : std::nullopt;
}

std::optional<FoundScene> SimplerSearch::wait()
{
  while (this->running_.valid())
  {
    this->running_.wait();
    if (auto found = this->poll())
    {
      return found;
    }
  }
  return std::nullopt;
}

} // namespace palpate
