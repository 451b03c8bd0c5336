// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "haptics/recording/writing/Recorder.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate::test
{

/// The tick by itself, recorded: a hand, a device and a scene that go as a test wants.
class RecordedTicks
{
public:
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;
  LatenessVerdict lateness;

  RecordedTicks(const std::string& path, const HapticParameters& first) : parameters_(first)
  {
    const std::string problem = this->recorder_.open(path, "scripted", false);
    if (!problem.empty() || !this->recorder_.pushStart(first, this->state_))
    {
      throw std::runtime_error(problem);
    }
  }

  void setParameters(const HapticParameters& parameters)
  {
    this->parameters_ = parameters;
    this->recorder_.pushParameters(this->tick_ + 1, parameters);
  }
  void setScene(const std::shared_ptr<const Scene>& scene)
  {
    this->previous_ = this->scene_;
    this->scene_ = scene;
    this->recorder_.store<input::Scenes>(scene);
    this->recorder_.pushInput<input::Scenes>(this->tick_ + 1, scene.get());
  }
  void push(EventKind kind)
  {
    this->events_.push_back({ this->tick_ + 1, kind, 0 });
    this->recorder_.pushEvent(this->events_.back());
  }

  /// One period of 2 ms with the hand at p_D [m].
  HapticState tickAt(const Vec3& p_D)
  {
    constexpr double period_s = 2e-3;
    TickInput input;
    input.tick = ++this->tick_;
    input.dt_s = period_s;
    input.sample = this->sample;
    input.sample.time_s = period_s * static_cast<double>(this->tick_);
    input.sample.pose_D.p = p_D;
    input.status = this->status;
    input.scene = this->scene_.get();
    input.previousScene = this->previous_.get();
    input.lateness = this->lateness;
    input.events = this->events_;
    const TickOutput output = renderTick(input, this->parameters_, this->state_);
    this->recorder_.pushTick(makeRecord(input, output));
    this->recorder_.pump();
    this->previous_.reset();
    this->events_.clear();
    return output.state;
  }

  /// Empty, or the fault.
  [[nodiscard]] std::string close() { return this->recorder_.close(); }

private:
  Recorder recorder_;
  HapticParameters parameters_;
  RendererState state_;
  std::shared_ptr<const Scene> scene_, previous_;
  std::vector<HapticEvent> events_;
  std::uint64_t tick_ = 0;
};

} // namespace palpate::test
