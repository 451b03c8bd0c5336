// SPDX-License-Identifier: GPL-3.0-or-later
// A program that is started with this library finds a WoodenHaptics: its hidapi is the model's, and its home has the
// owner's file. The handle stays in the pose of calibration until the counters are set; then a hand swings it along z.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <numbers>
#include <thread>

#include "testing/devices/arm/WoodenHapticsModel.h"
#include "testing/devices/hid/FakeHidapi.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

class AttachedArm
{
public:
  AttachedArm()
  {
    std::ofstream(this->home_.file("woodenhaptics.json")) << WoodenHapticsModel::file();
    setenv("HOME", this->home_.path().c_str(), 1);
  }

private:
  void swing(const std::stop_token& end)
  {
    constexpr double reach_m = 0.04, turns_per_s = 0.5;
    constexpr std::chrono::milliseconds step(1);
    for (double time_s = 0.0; !end.stop_requested(); std::this_thread::sleep_for(step))
    {
      this->bus_.alone(
        [&]
        {
          if (this->arm_->setOrders > 0)
          {
            time_s += std::chrono::duration<double>(step).count();
            this->arm_->lead({ 0.0, 0.0, reach_m * std::sin(2.0 * std::numbers::pi * turns_per_s * time_s) });
          }
        });
    }
  }

  TemporaryFolder home_;
  FakeHidBus bus_{ false };
  std::shared_ptr<WoodenHapticsModel> arm_ = std::make_shared<WoodenHapticsModel>();
  FakePort& port_ = bus_.plug(arm_, { "", WoodenHapticsModel::vendor, WoodenHapticsModel::product, "7", "arm" });
  FakeHidapi hidapi_{ bus_ };
  std::jthread hand_{ [this](const std::stop_token& end) { this->swing(end); } };
};

const AttachedArm attachedArm;

} // namespace
} // namespace palpate::test
