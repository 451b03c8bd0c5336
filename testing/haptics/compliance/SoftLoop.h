// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <stdexcept>

#include "Blocks.h"
#include "haptics/compliance/servo/SoftTick.h"
#include "haptics/compliance/snapshot/SnapshotMaker.h"
#include "haptics/contact/carry/CarryBall.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/geometry/scene/SceneMotion.h"

namespace palpate::test
{

/// A servo of 1 kHz and a pad (Blocks.h) that is computed once in a while, both in virtual time: snapshots arrive so
/// many periods after the tick that they were made from.
class SoftLoop
{
public:
  SoftLoop(SoftBody& body, const SoftSurface& surface, int period_ticks, const ContactPlan& plan, int periodsLate = 1)
    : plan(plan), surface_(surface), maker_(body, surface), period_ticks_(period_ticks),
      periodsLate_(static_cast<std::size_t>(periodsLate))
  {
    this->take(this->ask());
  }

  /// `arrives`: whether a snapshot that is due in this tick does.
  SoftResult tick(const Vec3& p_W, bool arrives = true)
  {
    if (this->ticks_ % this->period_ticks_ == 0 && this->ticks_ > 0)
    {
      if (this->underWay_.size() == this->periodsLate_)
      {
        if (arrives)
        {
          this->take(this->underWay_.front());
        }
        this->underWay_.pop_front();
      }
      this->underWay_.push_back(this->ask());
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

  [[nodiscard]] const ComplianceSnapshot& snapshot() const { return *this->snapshot_; }

  ContactPlan plan;
  SoftState state;

private:
  std::shared_ptr<const ComplianceSnapshot> ask()
  {
    SnapshotRequest request;
    request.period_s = 1e-3 * this->period_ticks_;
    request.ball_W = this->state.core.placed ? this->state.core.x_W : middleOfPad();
    for (int c = 0; c < this->state.count; ++c)
    {
      request.forceAt.push_back(this->state.contacts[c].point.at);
      request.force_N.push_back(-this->state.contacts[c].force_N);
    }
    return this->maker_.make(request);
  }

  void take(std::shared_ptr<const ComplianceSnapshot> snapshot)
  {
    SurfaceInput input;
    input.name = "soft";
    input.mesh = std::make_shared<TriangleMesh>(TriangleMesh{ snapshot->free_W, this->surface_.triangles });
    input.ordered = true;
    const auto next = this->builder_.build({ input }, this->scene_.get()).scene;
    if (!next)
    {
      throw std::runtime_error("a snapshot's surface is no scene");
    }
    this->scene_ = this->scene_ ? movingFrom(*this->scene_, this->share_, next, 1e-3 * this->period_ticks_) : next;
    this->share_ = 0.0;
    this->snapshot_ = std::move(snapshot);
    this->touch_ = { 0, this->snapshot_.get() };
    changeSnapshots(std::span(&this->touch_, 1), this->state);
  }

  const SoftSurface& surface_;
  SnapshotMaker maker_;
  SceneBuilder builder_;
  int period_ticks_;
  std::size_t periodsLate_;
  int ticks_ = 0;
  std::shared_ptr<const ComplianceSnapshot> snapshot_;
  std::deque<std::shared_ptr<const ComplianceSnapshot>> underWay_;
  SoftSurfaceRef touch_;
  std::shared_ptr<const Scene> scene_;
  double share_ = 1.0;
  std::unique_ptr<SoftScratch> room_ = std::make_unique<SoftScratch>();
};

} // namespace palpate::test
