// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "devices/io/DeviceThreads.h"
#include "haptics/core/Clock.h"

namespace palpate
{

/// The link to a device, its clock and the threads that serve it. A thread that hangs in the system is left behind with
/// its link and the clock, and a new link takes the place of the old one.
template<class Link>
class ServedLink
{
public:
  using Make = std::function<std::shared_ptr<Link>(const Clock&)>;
  using Work = std::vector<DeviceThreads::Work>;

  /// Makes a clock where none is given; a given clock must outlive the device.
  ServedLink(const Clock* clock, Make make) : clock_(clockOf(clock)), make_(std::move(make)), link_(make_(*clock_)) {}
  ~ServedLink() { this->close(); }
  ServedLink(const ServedLink&) = delete;
  ServedLink& operator=(const ServedLink&) = delete;

  /// Attaches the link and starts the threads of `workOf`; without `workOf` there are none. One of the threads must
  /// detach the link at its end. Returns the problem, empty when the link is open.
  [[nodiscard]] std::string open(const std::function<Work(Link&)>& workOf)
  {
    if (this->threads_ != nullptr)
    {
      return {};
    }
    std::string problem = this->link_->attach();
    if (!problem.empty() || !workOf)
    {
      return problem;
    }
    const auto kept = std::make_shared<Kept>(Kept{ this->clock_, this->link_ });
    this->threads_ = std::make_unique<DeviceThreads>();
    for (DeviceThreads::Work& work : workOf(*this->link_))
    {
      work.keeps = kept;
      this->threads_->run(std::move(work));
    }
    return {};
  }

  void close() noexcept
  {
    if (this->threads_ == nullptr)
    {
      this->link_->detach();
    }
    else if (!std::exchange(this->threads_, nullptr)->end())
    {
      this->link_ = this->make_(*this->clock_); // threads that hang keep the old link
    }
  }

  [[nodiscard]] Link* operator->() const noexcept { return this->link_.get(); }
  [[nodiscard]] Link& operator*() const noexcept { return *this->link_; }

private:
  struct Kept
  {
    std::shared_ptr<const Clock> clock;
    std::shared_ptr<Link> link;
  };

  static std::shared_ptr<const Clock> clockOf(const Clock* given)
  {
    return given != nullptr ? std::shared_ptr<const Clock>(given, [](const Clock*) {})
                            : std::make_shared<const MonotonicClock>();
  }

  std::shared_ptr<const Clock> clock_;
  Make make_;
  std::shared_ptr<Link> link_;
  std::unique_ptr<DeviceThreads> threads_;
};

} // namespace palpate
