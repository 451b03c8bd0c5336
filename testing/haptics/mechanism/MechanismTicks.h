// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "haptics/recording/inputs/Mechanisms.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate::test
{

/// The ticks of one hand, each with its mechanism, by the session's renderer without a session.
class MechanismTicks
{
public:
  explicit MechanismTicks(std::unique_ptr<RendererState> state = std::make_unique<RendererState>())
    : state_(std::move(state))
  {
    this->parameters_.stiffness_N_per_m = 1000.0;
    this->parameters_.mechanismTurning_N_m_per_rad = 2.0;
    this->parameters_.safety = SafetyLimits::none();
    this->input_.mechanismTick = &this->room_;
  }

  TickOutput next(int tick, const Pose& hand_D, const FeltMechanism& felt)
  {
    this->input_.tick = static_cast<std::uint64_t>(tick + 1);
    this->input_.mechanism = &felt;
    this->input_.sample.pose_D = hand_D;
    return renderTick(this->input_, this->parameters_, *this->state_);
  }
  [[nodiscard]] const RendererState& state() const { return *this->state_; }

private:
  HapticParameters parameters_;
  std::unique_ptr<RendererState> state_;
  MechanismTick room_;
  TickInput input_;
};

/// A mechanism as the bytes of a recording say it.
inline RecordedMechanism writtenAndRead(const FeltMechanism& felt)
{
  ByteWriter out;
  putMechanism(out, felt);
  ByteReader in(out.bytes().data(), out.bytes().size());
  RecordedMechanism read = readMechanism(in);
  EXPECT_TRUE(in.ok());
  EXPECT_EQ(in.left(), 0u);
  return read;
}

} // namespace palpate::test
