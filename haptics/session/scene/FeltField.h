// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "haptics/field/proxy/FieldPlan.h"
#include "haptics/session/background/LatestTask.h"
#include "haptics/session/scene/FieldSource.h"
#include "haptics/tick/base/HapticState.h"

namespace palpate
{

/// Keeps a block of a field around the hand: the next one is made, by a worker unless the source wants its owner to
/// ask, once the hand has used up half of its margin. By distance, never by a clock: a hand at rest costs nothing. One
/// thread, the session's owner, calls every method.
class FeltField
{
public:
  /// From now on this is felt; null: nothing. A block that is being made of another source is thrown away.
  void setSource(std::shared_ptr<const FieldSource> source);
  [[nodiscard]] bool hasSource() const noexcept { return this->source_ != nullptr; }

  /// The block that the session is to feel from now on, if that changed. `hand_W`: where the hand is. `reach_u`: how
  /// far it may get before it is asked again, and a worker has answered. `plan`: how the field is felt; where the value
  /// of a surface goes far, noise is measured beside it anew. With `wait` the block of here and now.
  [[nodiscard]] std::optional<std::shared_ptr<const FieldBlock>> follow(
    const Vec3& hand_W, double reach_u, const FieldPlan& plan, bool wait = false);

  /// The newest that was made, felt or refused.
  [[nodiscard]] const MadeFieldBlock& made() const noexcept { return this->made_; }
  /// Since when that is felt [s]; 0 where nothing is.
  [[nodiscard]] double age_s() const noexcept;
  /// FieldBlocks made until now.
  [[nodiscard]] std::uint64_t count() const noexcept { return this->revision_; }

private:
  [[nodiscard]] bool needsAnother(const FieldBlockWish& wish) const noexcept;
  void ask(FieldBlockWish wish);
  std::optional<std::shared_ptr<const FieldBlock>> take(bool wait);

  std::shared_ptr<const FieldSource> source_;
  MadeFieldBlock made_;
  std::chrono::steady_clock::time_point taken_{};
  std::uint64_t revision_ = 0;
  bool askedLevels_ = false; ///< how steep all of the data is was asked of this source
  bool changed_ = false;     ///< another source: the block is of the one before
  LatestTask<MadeFieldBlock> task_;
};

/// A state as one sees it who feels a field alone: proxy and contacts are those of the field.
[[nodiscard]] HapticState ofFieldAlone(HapticState state) noexcept;

/// "", or that the ball which touches surfaces is a point to an isosurface: one that is offset by its radius would need
/// the distance to the surface, which the values are not.
[[nodiscard]] std::string pointText(const FieldPlan& plan, double radius_u);

/// "", or that smooth levels hold the hand with less than the strength set, since the hand would jump from one to the
/// next. The text has the force at the usual gradient, for which the strength is set, and the largest force, which is
/// never exceeded. `stiffness_N_per_u`: of each spring of the field.
[[nodiscard]] std::string detentText(const FieldPlan& plan, double stiffness_N_per_u);

/// "", or that surfaces and clicking levels are felt at the points of a block instead of the data's own cells, how far
/// apart these are at a place, and why.
[[nodiscard]] std::string latticeText(const FieldPlan& plan, const MadeFieldBlock& made, const Vec3& hand_W);

/// The numbers of a plan that come from the data, so that no block changes the feel: the gradient for which a detent's
/// strength is set, where the block is the first of its data, and the steepest gradient of the scalar in all of them.
void takeFromData(FieldPlan& plan, const MadeFieldBlock& made, bool first);

/// Least and largest value of all of the data; turned round where there are none.
using FieldEnds = std::array<double, 2>;

/// The modes of a plan that can be felt of data between these values.
[[nodiscard]] FieldPlan withinEnds(FieldPlan plan, const FieldEnds& ends) noexcept;
/// "", or which value that is to be felt the data do not have, so that no surface or level of it is anywhere.
[[nodiscard]] std::string levelText(const FieldPlan& plan, const FieldEnds& ends);
/// The same where nothing else is to be felt.
[[nodiscard]] std::string levelProblem(const FieldPlan& plan, const FieldEnds& ends);

/// The status of data of that name: how finely and how far around the hand they are felt, and how fast the hand may go
/// so that a block is there in time; or why nothing is felt.
[[nodiscard]] std::string fieldText(
  const std::string& name, const MadeFieldBlock& made, double scale_u_per_m, double ahead_s);

} // namespace palpate
