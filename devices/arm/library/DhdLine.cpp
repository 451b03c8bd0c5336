// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/library/DhdLine.h"

#include <algorithm>
#include <utility>

#include "devices/arm/library/ReportedHand.h"

namespace palpate
{
namespace
{

constexpr unsigned char watchdogTens_ms = 20; ///< in units of 10 ms

} // namespace

DhdFunctions::DhdFunctions(const std::string& name) : library(name)
{
  this->library.take("dhdGetDeviceCount", this->count);
  this->library.take("dhdOpenID", this->openAt);
  this->library.take("dhdClose", this->close);
  this->library.take("dhdErrorGetLastStr", this->lastError);
  this->library.take("dhdGetPositionAndOrientationFrame", this->place);
  this->library.take("dhdGetLinearVelocity", this->velocity);
  this->library.take("dhdGetButtonMask", this->buttons);
  this->library.take("dhdSetForceAndTorqueAndGripperForce", this->push);
  this->library.take("dhdEnableForce", this->enable);
  this->library.take("dhdSetWatchdog", this->watchdog);
  this->library.takeIfThere("dhdGetGripperAngleRad", this->gripper);
}

std::string DhdFunctions::why() const
{
  const char* const text = this->lastError();
  return text != nullptr ? text : "no reason is given";
}

ArmBus::Opened DhdLine::open(const std::shared_ptr<DhdFunctions>& dhd, int index)
{
  if (!dhd->library.problem().empty())
  {
    return { nullptr, dhd->library.problem() };
  }
  const int id = dhd->openAt(static_cast<char>(index));
  if (id < 0)
  {
    return { nullptr, "the vendor's library does not open the device: " + dhd->why() };
  }
  std::unique_ptr<DhdLine> line(new DhdLine(dhd, static_cast<char>(id)));
  // In this order: without its watchdog it is not to push.
  if (line->failed(dhd->watchdog(watchdogTens_ms, line->id_)) || line->failed(dhd->enable(1, line->id_)))
  {
    return { nullptr, line->error() };
  }
  return { std::move(line), {} };
}

DhdLine::~DhdLine()
{
  this->dhd_->enable(0, this->id_);
  this->dhd_->close(this->id_);
}

bool DhdLine::failed(int result)
{
  if (result < 0)
  {
    this->error_ = "the vendor's library reports an error: " + this->dhd_->why();
  }
  return result < 0;
}

/// An arm without a gripper answers with an error: it is not gripped.
bool DhdLine::isGripped()
{
  double opening_rad = 0.0;
  return this->dhd_->gripper != nullptr && this->dhd_->gripper(&opening_rad, this->id_) >= 0 &&
         this->grip_.isHeld(opening_rad);
}

ArmLine::Answer DhdLine::exchange(const WireOrder& order, int /*timeout_ms*/)
{
  const Vec3& f = order.wrench_D.force;
  const Vec3& t = order.wrench_D.torque;
  Vec3 p, v;
  double frame[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  if (this->failed(this->dhd_->push(f.x(), f.y(), f.z(), t.x(), t.y(), t.z(), 0.0, this->id_)) ||
      this->failed(this->dhd_->place(&p.x(), &p.y(), &p.z(), frame, this->id_)) ||
      this->failed(this->dhd_->velocity(&v.x(), &v.y(), &v.z(), this->id_)))
  {
    return { Said::Gone, {} };
  }
  Mat3 turn;
  turn << frame[0][0], frame[0][1], frame[0][2], frame[1][0], frame[1][1], frame[1][2], frame[2][0], frame[2][1],
    frame[2][2];
  Answer answer = reportedHand(p, v, turn, static_cast<std::uint32_t>(std::max(0, this->dhd_->buttons(this->id_))));
  answer.reading.grip = this->isGripped();
  this->error_ = noHand;
  return answer;
}

void DhdLine::letGo() noexcept
{
  this->dhd_->push(0, 0, 0, 0, 0, 0, 0, this->id_);
}

} // namespace palpate
