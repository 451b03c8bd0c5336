// SPDX-License-Identifier: GPL-3.0-or-later
// A program that is started with this library finds a Falcon without firmware: its libusb is the model's, and the
// kernel's list of plugs has the Falcon. A program that opens it a second time meets a person who pulls the knob out
// and pushes it in, so that its motors find their zero; then a hand leads it from the rim of the work space to the
// middle.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <string_view>
#include <thread>

#include "testing/devices/arm/FakeLibusb.h"
#include "testing/devices/arm/FalconRig.h"
#include "testing/devices/arm/TwoPlugs.h"
#include "testing/support/TemporaryFolder.h"
#include "testing/ui/FakeFiles.h"

namespace palpate::test
{
namespace
{

class AttachedFalcon
{
public:
  AttachedFalcon()
  {
    constexpr std::string_view firmware = PALPATE_FALCON_FIRMWARE;
    std::ofstream(this->folder_.file("chip")).flush(); // stands in for the device's file
    this->loader_->runs = false;
    this->loader_->firmware.assign(firmware.begin(), firmware.end());
    this->model_->place(FalconModel::anglesAt(rim_m));
  }

private:
  static inline const Vec3 rim_m{ 0.0, 0.0, 0.17 }, middle_m{ 0.0, 0.0, 0.125 };

  void lead(const std::stop_token& end)
  {
    constexpr double pull_s = 1.0, push_s = 2.0, way_s = 4.0;
    constexpr std::chrono::milliseconds step(1);
    for (double time_s = 0.0; !end.stop_requested(); std::this_thread::sleep_for(step))
    {
      const bool held = this->libusb_.opened() > 1;
      time_s += held ? std::chrono::duration<double>(step).count() : 0.0;
      const double way = std::clamp((time_s - push_s) / way_s, 0.0, 1.0);
      this->libusb_.alone(
        [&](FtdiPort&)
        {
          const bool homed = this->model_->homing && time_s > push_s;
          this->model_->homed = { homed || (this->model_->homing && time_s > pull_s), homed, homed };
          this->model_->place(FalconModel::anglesAt(rim_m + way * (middle_m - rim_m)));
        });
    }
  }

  TwoPlugs plugs_;
  TemporaryFolder folder_;
  FakeFiles files_{ { { "/sys/bus/usb/devices", plugs_.sys() + "/bus/usb/devices" },
    { "/dev/bus/usb/001/007", folder_.file("chip") } } };
  ModelTime time_; ///< of nobody
  std::shared_ptr<FalconModel> model_ = std::make_shared<FalconModel>();
  std::shared_ptr<FalconChip::Loader> loader_ = std::make_shared<FalconChip::Loader>();
  FalconChip chip_{ model_, loader_, time_ };
  FakeLibusb libusb_{ chip_ };
  std::jthread hand_{ [this](const std::stop_token& end) { this->lead(end); } };
};

const AttachedFalcon attachedFalcon;

} // namespace
} // namespace palpate::test
