// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ReplayDevice.h"

#include <utility>
#include <variant>

namespace palpate
{

ReplayDevice::ReplayDevice(std::vector<DeviceSample> samples)
{
  this->hand_.samples = std::move(samples);
  this->info_.name = "replay";
  this->info_.simulated = true;
  this->info_.rendersForce = false;
}

ReplayDevice::ReplayDevice(std::string recordingFile) : ReplayDevice(std::vector<DeviceSample>{})
{
  this->file_ = std::move(recordingFile);
}

std::string ReplayDevice::open()
{
  this->next_ = 0;
  if (!this->file_.empty() && this->hand_.samples.empty())
  {
    const auto read = readRecording(this->file_);
    if (const auto* problem = std::get_if<std::string>(&read))
    {
      return *problem;
    }
    this->hand_ = recordedHand(std::get<Recording>(read));
  }
  return this->hand_.samples.empty() ? "the recording has no samples: choose another recording" : "";
}

DeviceStatus ReplayDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  if (this->next_ == this->hand_.samples.size())
  {
    return DeviceStatus::Ended;
  }
  sample = this->hand_.samples[this->next_++];
  sample.time_s = tickTime_s;
  return DeviceStatus::Ok;
}

} // namespace palpate
