// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include "haptics/core/HapticDevice.h"
#include "haptics/realtime/TripleBuffer.h"

namespace palpate
{

/// How a hand gets from pose to pose where these come slower than ticks. The defaults: at once.
struct Glide
{
  double longest_s = 0.0; ///< takes as long as since the pose before, up to this: a screen's 60 Hz are no steps
  double fastest_m_per_s = std::numeric_limits<double>::infinity();
};

/// A device whose poses a program feeds. The last pose holds; before the first there is no hand.
class FedDevice final : public HapticDevice
{
public:
  /// Poses of a script or a test, there at the next tick: "fed".
  FedDevice();
  /// The mouse in a view, between whose events the hand glides evenly: "mouse".
  [[nodiscard]] static std::unique_ptr<FedDevice> mouse();

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override { return {}; }
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand& command) noexcept override { this->command_.write(command); }

  /// Feeding thread only; wait-free. The time of the sample is set by the tick that reads it.
  void feed(const DeviceSample& sample) noexcept { this->feed(sample, this->places_); }
  /// The same, and the hand is there at the next tick: where the old place means nothing any more.
  void place(const DeviceSample& sample) noexcept { this->feed(sample, ++this->places_); }
  /// There is no hand until it is fed again, and then it is there at once: while the meaning of a pose changes.
  void withdraw() noexcept
  {
    ++this->places_;
    this->fed_.write({});
  }
  /// The newest command. Feeding thread only; wait-free.
  [[nodiscard]] const DeviceCommand& command() noexcept { return this->command_.read(); }

private:
  struct Fed
  {
    DeviceSample sample;
    std::uint64_t count = 0;  ///< of poses fed so far
    std::uint64_t places = 0; ///< of these, where the hand was put without a motion
  };

  FedDevice(const char* name, const Glide& glide);
  void feed(const DeviceSample& sample, std::uint64_t places) noexcept;
  void glideTo(const Fed& fed, double tickTime_s) noexcept;

  DeviceInfo info_;
  Glide glide_;
  TripleBuffer<Fed> fed_;
  TripleBuffer<DeviceCommand> command_;
  std::uint64_t feeds_ = 0;  ///< feeding thread's
  std::uint64_t places_ = 0; ///< feeding thread's

  // The servo thread's: where the hand is, and when it is to arrive.
  Vec3 hand_D_ = Vec3::Zero();
  std::uint64_t seen_ = 0; ///< count of the pose it goes to; 0: nowhere yet
  std::uint64_t placed_ = 0;
  double news_s_ = 0.0;
  double arrival_s_ = 0.0;
  double last_s_ = 0.0;
};

} // namespace palpate
