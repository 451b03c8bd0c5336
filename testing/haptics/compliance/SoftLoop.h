// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "SoftPads.h"
#include "haptics/compliance/servo/SoftTick.h"
#include "haptics/contact/carry/CarryBall.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/geometry/scene/SceneMotion.h"

namespace palpate::test
{

/// A servo of 1 kHz and a body that is computed once in a while, both in virtual time: packets arrive one period after
/// the tick that they were made from.
class SoftLoop
{
public:
  SoftLoop(SoftPad& pad, int period_ticks, const ContactPlan& plan)
    : plan(plan), pad_(pad), maker_(*pad.body, pad.surface), period_ticks_(period_ticks)
  {
    this->take(this->ask());
  }

  /// `arrives`: whether a packet that is due in this tick does.
  SoftResult tick(const Vec3& p_W, bool arrives = true)
  {
    if (this->ticks_ % this->period_ticks_ == 0 && this->ticks_ > 0)
    {
      if (this->due_ && arrives)
      {
        this->take(this->due_);
      }
      this->due_ = this->ask();
    }
    ++this->ticks_;
    const double share = std::min(this->share_ + 1.0 / this->period_ticks_, 1.0);
    const MovingScene before(*this->scene_, this->share_);
    const MovingScene now(*this->scene_, share);
    if (this->state.core.placed)
    {
      (void)carryBall(before, now, this->plan, this->state.core);
    }
    this->share_ = share;
    fadeChange(1e-3, this->state);
    return moveOnSoft(now, this->plan, std::span(&this->touch_, 1), p_W, this->state, *this->room_);
  }

  [[nodiscard]] const CompliancePacket& packet() const { return *this->packet_; }

  ContactPlan plan;
  SoftState state;

private:
  std::shared_ptr<const CompliancePacket> ask()
  {
    PacketRequest request = this->pad_.request(0.0);
    request.period_s = 1e-3 * this->period_ticks_;
    request.ball_W = this->state.core.placed ? this->state.core.x_W : SoftPad::middle();
    for (int c = 0; c < this->state.count; ++c)
    {
      request.forceAt.push_back(this->state.contacts[c].point.at);
      request.force_N.push_back(-this->state.contacts[c].force_N);
    }
    return this->maker_.make(request);
  }

  void take(std::shared_ptr<const CompliancePacket> packet)
  {
    SurfaceInput input;
    input.name = "soft";
    input.mesh = std::make_shared<TriangleMesh>(TriangleMesh{ packet->free_W, this->pad_.surface.triangles });
    input.ordered = true;
    const auto next = this->builder_.build({ input }, this->scene_.get()).scene;
    ASSERT_TRUE(next);
    this->scene_ = this->scene_ ? movingFrom(*this->scene_, this->share_, next, 1e-3 * this->period_ticks_) : next;
    this->share_ = 0.0;
    this->packet_ = std::move(packet);
    this->touch_ = { 0, this->packet_.get() };
    changePackets(std::span(&this->touch_, 1), this->state);
  }

  SoftPad& pad_;
  PacketMaker maker_;
  SceneBuilder builder_;
  int period_ticks_;
  int ticks_ = 0;
  std::shared_ptr<const CompliancePacket> packet_, due_;
  SoftTouch touch_;
  std::shared_ptr<const Scene> scene_;
  double share_ = 1.0;
  std::unique_ptr<SoftRoom> room_ = std::make_unique<SoftRoom>();
};

} // namespace palpate::test
