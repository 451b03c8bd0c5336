// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "haptics/session/scene/FeltField.h"
#include "haptics/session/soft/VirtualBody.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate
{

/// The tick along a path of the hand that is known before, one tick a place, without a device and its limits.
class PathTouch
{
public:
  /// `scene`: null where there is a field alone. `first_s`: how long the first tick is, as there is none before.
  PathTouch(std::shared_ptr<const Scene> scene, const HapticParameters& parameters, double first_s);

  /// Numbers in space are felt as well, from the next tick on. Their blocks are as large as the memory of one allows,
  /// and are waited for: the same path gives the same forces on any machine.
  void feel(std::shared_ptr<const FieldSource> field);

  /// A soft body beside the scene, from the next tick on. `rate_Hz`: of its snapshots, each of which arrives one period
  /// after the forces that it was made from; 0: it is at rest in every tick, which is the reference.
  void press(std::unique_ptr<BodyMaker> body, double rate_Hz);

  /// The hand is there at that time, which is later than the time before. Where a field alone is touched the proxy is
  /// that of the field. The contacts are those of the surfaces and those of the field.
  [[nodiscard]] HapticState next(double time_s, const Pose& hand_D);

  /// The newest block of the field, or why there is none.
  [[nodiscard]] const MadeFieldBlock& madeFieldBlock() const noexcept { return this->field_.made(); }
  /// The soft body; null: none.
  [[nodiscard]] const BodyMaker* body() const noexcept { return this->maker_.get(); }
  /// "", or that smooth levels hold with less than was asked for.
  [[nodiscard]] std::string detentText() const;
  /// "", or that surfaces of the field are felt on a lattice, as it is where the hand was last.
  [[nodiscard]] std::string latticeText() const;
  /// "", or why no tick until now was among the values of the field.
  [[nodiscard]] std::string whyNothingOfField() const;

private:
  void followField(const Pose& hand_D);
  [[nodiscard]] TickOutput compute();
  [[nodiscard]] TickOutput computeAtRest();
  void takeBody(const PressedBody* body);

  std::shared_ptr<const Scene> scene_;
  FeltField field_;
  std::shared_ptr<const FieldBlock> brick_;
  HapticParameters parameters_;
  RendererState state_;
  TickInput input_;
  std::unique_ptr<BodyMaker> maker_;
  std::optional<VirtualBody> paced_;          ///< none: the body is at rest in every tick
  std::shared_ptr<const PressedBody> atRest_; ///< of the last tick
  std::unique_ptr<SoftScratch> softScratch_;
  BodyHand bodyHand_;
  double springs_N_per_u_ = 0.0; ///< stiffness of each spring in the last tick
  bool begun_ = false;
  bool knowsSlope_ = false;
  bool metField_ = false; ///< some tick was among its values
};

} // namespace palpate
