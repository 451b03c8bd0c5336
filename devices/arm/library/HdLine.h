// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "devices/arm/ArmLine.h"
#include "devices/arm/library/SharedLibrary.h"

namespace palpate
{

/// The functions of OpenHaptics' library that are called, declared by hand: millimetres, newtons, millinewton metres.
struct HdFunctions
{
  struct Error
  {
    std::uint32_t code;
    int internal;
    std::uint32_t device;
  };
  using Callback = std::uint32_t (*)(void*);

  explicit HdFunctions(const std::string& name);

  SharedLibrary library;
  std::uint32_t (*init)(const char*) = nullptr;
  void (*disable)(std::uint32_t) = nullptr;
  void (*makeCurrent)(std::uint32_t) = nullptr;
  void (*beginFrame)(std::uint32_t) = nullptr;
  void (*endFrame)(std::uint32_t) = nullptr;
  void (*getDoubles)(std::uint32_t, double*) = nullptr;
  void (*getIntegers)(std::uint32_t, int*) = nullptr;
  void (*setDoubles)(std::uint32_t, const double*) = nullptr;
  void (*enable)(std::uint32_t) = nullptr;
  std::uint64_t (*schedule)(Callback, void*, std::uint16_t) = nullptr;
  void (*unschedule)(std::uint64_t) = nullptr;
  void (*startScheduler)() = nullptr;
  void (*stopScheduler)() = nullptr;
  Error (*error)() = nullptr;
};

/// A Touch or Phantom. The vendor's scheduler, one for all devices, calls back; the call only exchanges the newest
/// order for the newest reading, which the exchange waits for. An order that is not renewed ends after 20 ms.
class HdLine final : public ArmLine
{
public:
  [[nodiscard]] static ArmBus::Opened open(const std::shared_ptr<HdFunctions>& hd, const std::string& device);
  ~HdLine() override;
  HdLine(const HdLine&) = delete;
  HdLine& operator=(const HdLine&) = delete;

  [[nodiscard]] Answer exchange(const WireOrder& order, int timeout_ms) override;
  void letGo() noexcept override;
  [[nodiscard]] std::string error() const override;

private:
  HdLine(std::shared_ptr<HdFunctions> hd, std::uint32_t device) : hd_(std::move(hd)), device_(device) {}
  static std::uint32_t called(void* line);
  void begin();
  void frame();
  [[nodiscard]] Vec3 forceNow() const;

  std::shared_ptr<HdFunctions> hd_;
  std::uint32_t device_;
  std::uint64_t scheduled_ = 0;
  bool begun_ = false;

  mutable std::mutex mutex_; ///< of the members below: the vendor's thread and the exchange
  std::condition_variable done_;
  WireOrder order_;
  std::chrono::steady_clock::time_point ordered_; ///< when that was
  Answer answer_;
  std::uint64_t frames_ = 0, seen_ = 0;
  std::string error_;
};

} // namespace palpate
