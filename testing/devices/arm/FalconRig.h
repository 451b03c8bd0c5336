// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <memory>
#include <unistd.h>
#include <utility>
#include <vector>

#include "devices/arm/FirmwareLine.h"
#include "devices/arm/kit/Kits.h"
#include "testing/devices/arm/BoardRig.h"
#include "testing/devices/arm/FalconModel.h"

namespace palpate::test
{

/// The chip before a Falcon, and the loader that its firmware waits behind, in virtual time.
class FalconChip final : public FtdiPort
{
public:
  /// Bytes that the loader has seen, and its faults.
  struct Loader
  {
    bool runs = true; ///< the firmware does
    bool greets = true;
    bool canBeHeld = true; ///< a guard can have a copy of the open chip
    std::size_t wrongEchoAt = static_cast<std::size_t>(-1);
    bool takesAnything = true;          ///< else the loaded firmware does not run
    std::vector<std::uint8_t> firmware; ///< that alone runs; empty: any does
    std::vector<std::uint8_t> loaded;
    std::vector<std::pair<int, int>> controls;
    std::vector<std::size_t> pieces; ///< how many bytes came at once
    int emptyReads = 0;              ///< that waited for the chip's own bytes alone
  };

  FalconChip(std::shared_ptr<FalconModel> model, std::shared_ptr<Loader> loader, ModelTime& time)
    : model_(model), loader_(std::move(loader)), link_(std::move(model), time), time_(time)
  {
  }
  ~FalconChip() override { ::close(this->file_); }
  FalconChip(const FalconChip&) = delete;
  FalconChip& operator=(const FalconChip&) = delete;

  bool control(std::uint8_t request, std::uint16_t value) noexcept override
  {
    this->loader_->controls.emplace_back(request, value);
    this->slow_ = request == 3 ? value != 2 : this->slow_;
    this->latency_ms_ = request == 9 ? value : this->latency_ms_;
    return this->model_->present;
  }
  bool write(std::span<const std::uint8_t> bytes) noexcept override
  {
    if (this->slow_)
    {
      this->load({ bytes.begin(), bytes.end() });
      return this->model_->present;
    }
    return !this->loader_->runs || this->link_.write(bytes);
  }
  int read(std::span<std::uint8_t> bytes, int timeout_ms) noexcept override
  {
    if (!this->model_->present)
    {
      return -1;
    }
    bytes[0] = 0x01;
    bytes[1] = 0x60;
    if (this->slow_ || !this->loader_->runs)
    {
      if (timeout_ms <= this->latency_ms_)
      {
        this->echo_.clear(); // a transfer that is given up before the chip has sent it
        this->time_.pass(timeout_ms * perMs_ns);
        return 0;
      }
      const std::size_t count = std::min(bytes.size() - 2, this->echo_.size());
      std::copy_n(this->echo_.begin(), count, bytes.begin() + 2);
      this->echo_.erase(this->echo_.begin(), this->echo_.begin() + static_cast<std::ptrdiff_t>(count));
      this->time_.pass(count < bytes.size() - 2 ? this->latency_ms_ * perMs_ns : 0); // a full one goes at once
      return static_cast<int>(count + 2);
    }
    if (this->model_->said.empty())
    {
      ++this->loader_->emptyReads;
      this->time_.pass(
        std::min(timeout_ms, this->latency_ms_) * perMs_ns); // it says that it has nothing after its latency
      return 2;
    }
    const int count = this->link_.read(bytes.subspan(2), timeout_ms);
    return count < 0 ? count : count + 2;
  }
  std::string error() const override { return "No such device"; }
  /// The time that the chip waits for more bytes before it sends those that it has.
  [[nodiscard]] int latency_ms() const noexcept { return this->latency_ms_; }
  int handle() const noexcept override { return this->loader_->canBeHeld ? this->file_ : -1; }

private:
  void load(std::vector<std::uint8_t> bytes)
  {
    if (bytes == std::vector<std::uint8_t>{ 0x0A, 0x43, 0x0D })
    {
      this->begun_ = false;
      this->loader_->loaded.clear();
      this->echo_ = this->loader_->greets ? std::vector<std::uint8_t>{ 0x00, 0x0A, 0x44, 0x2C, 0x0D } : bytes;
      return;
    }
    this->echo_ = bytes;
    if (!this->begun_)
    {
      this->begun_ = bytes == std::vector<std::uint8_t>{ 0x41 };
      return;
    }
    this->loader_->pieces.push_back(bytes.size());
    const std::size_t before = this->loader_->loaded.size();
    this->loader_->loaded.insert(this->loader_->loaded.end(), bytes.begin(), bytes.end());
    if (this->loader_->wrongEchoAt >= before && this->loader_->wrongEchoAt < this->loader_->loaded.size())
    {
      this->echo_[this->loader_->wrongEchoAt - before] ^= 1U;
    }
    const bool isIts = this->loader_->firmware.empty() || this->loader_->loaded == this->loader_->firmware;
    this->loader_->runs = this->loader_->takesAnything && isIts;
  }

  std::shared_ptr<FalconModel> model_;
  std::shared_ptr<Loader> loader_;
  BoardLink link_;
  ModelTime& time_;
  std::vector<std::uint8_t> echo_;
  bool slow_ = false, begun_ = false;
  int latency_ms_ = 16;                                ///< a chip begins with that
  int file_ = ::open("/dev/null", O_RDWR | O_CLOEXEC); ///< for the guard to hold
};

/// A Falcon in virtual time.
struct FalconRig
{
  /// Homes all its motors, as a person does.
  void home()
  {
    this->model->homed = { true, true, true };
    this->rig.run(5);
  }

  ModelTime time;
  std::shared_ptr<FalconModel> model = std::make_shared<FalconModel>();
  std::shared_ptr<FalconChip::Loader> loader = std::make_shared<FalconChip::Loader>();
  BoardRig rig{ time, model, falconSetup(),
    [this]
    {
      auto line = std::make_unique<FirmwareLine>(
        std::make_unique<FalconChip>(this->model, this->loader, this->time), &this->time);
      std::string problem = line->begin();
      return ArmBus::Opened{ problem.empty() ? std::move(line) : nullptr, problem };
    } };
};

} // namespace palpate::test
