// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ReplayDevice.h"

#include <utility>
#include <variant>

#include "haptics/recording/Recording.h"

namespace palpate
{

ReplayDevice::ReplayDevice(std::vector<DeviceSample> samples) : samples_(std::move(samples))
{
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
  if (!this->file_.empty())
  {
    const auto read = readRecording(this->file_);
    if (const auto* problem = std::get_if<std::string>(&read))
    {
      return *problem;
    }
    this->samples_.clear();
    for (const RecordedEntry& entry : std::get<Recording>(read).entries)
    {
      if (const auto* tick = std::get_if<TickRecord>(&entry); tick != nullptr && tick->status != DeviceStatus::Waiting)
      {
        this->samples_.push_back(tick->sample);
      }
    }
  }
  return this->samples_.empty() ? "the recording to replay has no samples: give one that has" : "";
}

DeviceStatus ReplayDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  if (this->next_ == this->samples_.size())
  {
    return DeviceStatus::Ended;
  }
  sample = this->samples_[this->next_++];
  sample.time_s = tickTime_s;
  return DeviceStatus::Ok;
}

} // namespace palpate
