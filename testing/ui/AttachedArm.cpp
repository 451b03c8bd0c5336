// SPDX-License-Identifier: GPL-3.0-or-later
// A program that is started with this library finds a WoodenHaptics: its hidapi is the model's, and its home has the
// owner's file. The handle stays in the pose of calibration until the counters are set; then a hand leads it to the
// middle of the work space.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
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
    this->bus_.plug(this->arm_, { "", WoodenHapticsModel::vendor, WoodenHapticsModel::product, "7", "arm" });
    setenv("HOME", this->home_.path().c_str(), 1);
  }

private:
  void lead(const std::stop_token& end)
  {
    constexpr double way_s = 4.0;
    constexpr std::chrono::milliseconds step(1);
    const Vec3 pose_m = this->arm_->tip_m();
    for (double time_s = 0.0; !end.stop_requested(); std::this_thread::sleep_for(step))
    {
      this->bus_.alone(
        [&]
        {
          time_s += this->arm_->setOrders > 0 ? std::chrono::duration<double>(step).count() : 0.0;
          this->arm_->lead(std::max(1.0 - time_s / way_s, 0.0) * pose_m);
        });
    }
  }

  TemporaryFolder home_;
  FakeHidBus bus_{ false };
  std::shared_ptr<WoodenHapticsModel> arm_ = std::make_shared<WoodenHapticsModel>();
  FakeHidapi hidapi_{ bus_ };
  std::jthread hand_{ [this](const std::stop_token& end) { this->lead(end); } };
};

const AttachedArm attachedArm;

} // namespace
} // namespace palpate::test
