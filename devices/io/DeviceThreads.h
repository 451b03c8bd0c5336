// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace palpate
{

/// The threads of one open device, each calling one function again and again. Each owns its data, so that one
/// that hangs in the system can be left behind.
class DeviceThreads
{
public:
  struct Work
  {
    std::function<bool()> pass;  ///< false: there is nothing to do now
    int idle_ms = 1;             ///< then it waits that long
    int priority = 0;            ///< of the real-time kind, 0: the usual one
    std::function<void()> leave; ///< last action of its thread
    std::shared_ptr<void> keeps; ///< lives as long as the thread
  };

  DeviceThreads() = default;
  ~DeviceThreads() { static_cast<void>(this->end()); }
  DeviceThreads(const DeviceThreads&) = delete;
  DeviceThreads& operator=(const DeviceThreads&) = delete;

  void run(Work work);
  /// Waits for half a second at most for each. False: one hangs and was left to itself, with all it keeps.
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
