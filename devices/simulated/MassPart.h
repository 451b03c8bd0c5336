// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/simulated/DeviceModels.h"
#include "devices/simulated/MovingPart.h"
#include "devices/simulated/PrincipalPlant.h"

namespace palpate
{

/// The moving part of a model without an arm: the same along every axis, with stops at the model's travel and an
/// encoder of whole steps.
class MassPart final : public MovingPart
{
public:
  MassPart(const DeviceModel& model, const HandModel& hand, double period_s);

  [[nodiscard]] bool begin(const Vec3& p_D, const Vec3& v_D) noexcept override;
  void step(const Vec3& hand_N, const Wrench& motors_D) noexcept override;
  [[nodiscard]] Vec3 shown_D() const noexcept override;

private:
  PrincipalPlant plant_;
  double travel_m_, step_m_;
};

} // namespace palpate
