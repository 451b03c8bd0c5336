// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace palpate
{

/// The threads of one open device; each calls one function repeatedly and owns its data, so that a thread that hangs in
/// the system can be left behind.
class DeviceThreads
{
public:
  struct Work
  {
    std::function<bool()> pass;  ///< false: there is nothing to do now
    int idle_ms = 1;             ///< pause after that
    int priority = 0;            ///< real-time priority; 0: normal scheduling
    std::function<void()> leave; ///< last action of its thread
    std::shared_ptr<void> keeps; ///< lives as long as the thread
  };

  DeviceThreads() = default;
  ~DeviceThreads() { static_cast<void>(this->end()); }
  DeviceThreads(const DeviceThreads&) = delete;
  DeviceThreads& operator=(const DeviceThreads&) = delete;

  void run(Work work);
  /// Waits at most half a second for each thread. False: one hangs and was detached with all data that it keeps.
  [[nodiscard]] bool end() noexcept;

private:
  struct Running
  {
    Work work;
    std::shared_ptr<std::atomic<bool>> stop;
    std::atomic<bool> done = false;
  };
  struct Started
  {
    std::shared_ptr<Running> running;
    std::thread thread;
  };

  std::shared_ptr<std::atomic<bool>> stop_ = std::make_shared<std::atomic<bool>>(false);
  std::vector<Started> threads_;
};

} // namespace palpate
