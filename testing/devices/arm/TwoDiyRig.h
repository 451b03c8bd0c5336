// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "devices/arm/kit/Kits.h"
#include "devices/arm/protocol/TwoDiyWire.h"
#include "testing/devices/arm/BoardRig.h"
#include "testing/devices/arm/TwoDiyModel.h"

namespace palpate::test
{

/// A 2DIY, or another arm on such a board, in virtual time, without a guard: its line is none of the system's.
struct TwoDiyRig
{
  explicit TwoDiyRig(const WiredArm& itsArm = twoDiyArm(), const TwoDiyBody& body = {})
    : arm(itsArm), model(std::make_shared<TwoDiyModel>(body))
  {
  }

  /// A person holds the arms stretched out and presses the button.
  void setInPose()
  {
    this->rig.run(5);
    this->rig.device.stepDone("");
    this->rig.run(10);
  }

  WiredArm arm;
  ModelTime time;
  std::shared_ptr<TwoDiyModel> model;
  BoardRig rig{ time, model, setupOf(arm),
    [this]
    {
      auto line = std::make_unique<WireLine>(
        std::make_unique<BoardSerial>(this->model, this->time), std::make_shared<TwoDiyWire>(boardOf(this->arm)));
      std::string problem = line->begin();
      return ArmBus::Opened{ problem.empty() ? std::move(line) : nullptr, problem };
    } };
};

} // namespace palpate::test
