// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/library/HdLine.h"

#include <array>
#include <chrono>
#include <utility>

#include "devices/arm/library/ReportedHand.h"

namespace palpate
{
namespace
{

enum Name : std::uint32_t
{
  Buttons = 0x2000,
  Position = 0x2050,
  Velocity = 0x2051,
  Transform = 0x2052,
  Force = 0x2700,
  ForceOutput = 0x4000,
};
constexpr std::uint32_t noDevice = 0xFFFFFFFF, goOn = 1;
constexpr std::uint16_t usualPriority = 32767;
constexpr double perMetre = 1000.0;
constexpr auto lastingOrder = std::chrono::milliseconds(20);

/// One scheduler serves all devices: it runs while there is one.
std::mutex schedulerMutex;
int schedulerUsers = 0;

std::string describe(std::uint32_t code)
{
  switch (code)
  {
    case 0x0200:
      return "the motors are warm: let them cool";
    case 0x0201:
      return "the force was beyond the largest";
    case 0x0203:
      return "the hand was too fast";
    case 0x0302:
      return "the link to the device is lost";
    case 0x0600:
      return "there is no licence";
    default:
      return "error " + std::to_string(code);
  }
}

/// Those that a device goes on after.
bool isPassing(std::uint32_t code)
{
  return code == 0x0201 || code == 0x0203;
}

} // namespace

HdFunctions::HdFunctions(const std::string& name) : library(name)
{
  this->library.take("hdInitDevice", this->init);
  this->library.take("hdDisableDevice", this->disable);
  this->library.take("hdMakeCurrentDevice", this->makeCurrent);
  this->library.take("hdBeginFrame", this->beginFrame);
  this->library.take("hdEndFrame", this->endFrame);
  this->library.take("hdGetDoublev", this->getDoubles);
  this->library.take("hdGetIntegerv", this->getIntegers);
  this->library.take("hdSetDoublev", this->setDoubles);
  this->library.take("hdEnable", this->enable);
  this->library.take("hdScheduleAsynchronous", this->schedule);
  this->library.take("hdUnschedule", this->unschedule);
  this->library.take("hdStartScheduler", this->startScheduler);
  this->library.take("hdStopScheduler", this->stopScheduler);
  this->library.take("hdGetError", this->error);
}

ArmBus::Opened HdLine::open(const std::shared_ptr<HdFunctions>& hd, const std::string& device)
{
  if (!hd->library.problem().empty())
  {
    return { nullptr, hd->library.problem() };
  }
  const std::uint32_t id = hd->init(device.empty() ? nullptr : device.c_str());
  const HdFunctions::Error failed = hd->error();
  if (id == noDevice || failed.code != 0)
  {
    if (id != noDevice)
    {
      hd->disable(id);
    }
    return { nullptr, "the vendor's library does not open the device: " + describe(failed.code) };
  }
  std::unique_ptr<HdLine> line(new HdLine(hd, id));
  line->begin();
  return { std::move(line), {} };
}

void HdLine::begin()
{
  const std::lock_guard lock(schedulerMutex);
  this->hd_->makeCurrent(this->device_);
  this->hd_->enable(ForceOutput);
  this->scheduled_ = this->hd_->schedule(called, this, usualPriority);
  if (schedulerUsers++ == 0)
  {
    this->hd_->startScheduler();
  }
  this->begun_ = true;
}

/// The scheduler stops first: nothing is called back any more.
HdLine::~HdLine()
{
  const std::lock_guard lock(schedulerMutex);
  if (this->begun_)
  {
    if (--schedulerUsers == 0)
    {
      this->hd_->stopScheduler();
    }
    this->hd_->unschedule(this->scheduled_);
  }
  this->hd_->disable(this->device_);
}

std::uint32_t HdLine::called(void* line)
{
  static_cast<HdLine*>(line)->frame();
  return goOn;
}

/// None where the last one was not renewed.
Vec3 HdLine::forceNow() const
{
  const std::lock_guard lock(this->mutex_);
  const bool lasts = std::chrono::steady_clock::now() - this->ordered_ <= lastingOrder;
  return lasts ? this->order_.wrench_D.force : Vec3(Vec3::Zero());
}

/// The order is taken last: the calls before may have blocked since it was given.
void HdLine::frame()
{
  Vec3 p, v;
  std::array<double, 16> transform{};
  int buttons = 0;
  this->hd_->beginFrame(this->device_);
  this->hd_->getDoubles(Position, p.data());
  this->hd_->getDoubles(Velocity, v.data());
  this->hd_->getDoubles(Transform, transform.data());
  this->hd_->getIntegers(Buttons, &buttons);
  const Vec3 force_N = this->forceNow();
  this->hd_->setDoubles(Force, force_N.data());
  this->hd_->endFrame(this->device_);
  const HdFunctions::Error failed = this->hd_->error();
  const Mat3 turn = Eigen::Map<const Eigen::Matrix4d>(transform.data()).topLeftCorner<3, 3>();
  const Answer hand = reportedHand(p / perMetre, v / perMetre, turn, static_cast<std::uint32_t>(buttons));
  {
    const std::lock_guard lock(this->mutex_);
    const bool gone = failed.code != 0 && !isPassing(failed.code);
    this->answer_ = gone ? Answer{} : hand;
    this->error_ = gone ? "the vendor's library reports: " + describe(failed.code) : std::string(noHand);
    ++this->frames_;
  }
  this->done_.notify_one();
}

ArmLine::Answer HdLine::exchange(const WireOrder& order, int timeout_ms)
{
  std::unique_lock lock(this->mutex_);
  this->order_ = order;
  this->ordered_ = std::chrono::steady_clock::now();
  if (!this->done_.wait_for(
        lock, std::chrono::milliseconds(timeout_ms), [this] { return this->frames_ != this->seen_; }))
  {
    this->error_ = "the vendor's scheduler does not call back";
    return { Said::Nothing, {} };
  }
  this->seen_ = this->frames_;
  return this->answer_;
}

void HdLine::letGo() noexcept
{
  const std::lock_guard lock(this->mutex_);
  this->order_ = {};
}

std::string HdLine::error() const
{
  const std::lock_guard lock(this->mutex_);
  return this->error_;
}

} // namespace palpate
