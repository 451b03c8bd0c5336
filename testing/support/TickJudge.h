// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "haptics/contact/GodObject.h"
#include "testing/support/PathChecker.h"

namespace palpate::test
{

/// The sums of many ticks. The first seven must be 0.
struct TickFigures
{
  std::uint64_t glued = 0;   ///< the segment to the device was free and the god-object stayed
  std::uint64_t through = 0; ///< the path met a triangle, came nearer than the radius, jumped or ended elsewhere
  std::uint64_t adrift = 0;  ///< neither at the device nor at any triangle
  std::uint64_t beyond = 0;  ///< drawn further than friction holds it
  std::uint64_t untrue = 0;  ///< the pull was not the vector from the device to the god-object
  std::uint64_t notFinite = 0;
  std::uint64_t notPlaced = 0; ///< runs that never began
  std::uint64_t ticks = 0;
  std::uint64_t held = 0;   ///< the god-object was not at the device
  std::uint64_t capped = 0; ///< excused from `glued`, `adrift` and `beyond`, as those over budget are
  std::uint64_t overBudget = 0;
  double mostBeyond = 0.0; ///< of all ticks, in lengths of the pull
  std::string first;       ///< the first of all findings in words

  [[nodiscard]] bool clean() const noexcept;
  TickFigures& operator+=(const TickFigures& more);
  [[nodiscard]] std::string text() const;
};

/// Judges every tick by itself, by brute force over the near triangles of a grid, in exact arithmetic where the answer
/// is yes or no; nothing of the code under test is used. A tick may end in two ways only: at the device, or at the
/// surface with something in the way to the device, pulled no more than the touched faces and friction can hold.
class TickJudge final : public PathSink
{
public:
  /// `surface`: a checker over the mesh as the scene has it. `size_u`: its largest extent.
  TickJudge(const PathChecker& surface, const ContactPlan& plan, double size_u);

  /// To be called with the path of the tick (hand this to moveGodObject()).
  void segment(const Vec3& from_W, const Vec3& to_W) noexcept override;
  /// After each tick but the first, which only places the god-object.
  void judge(const Vec3& before_W, const Vec3& p_W, const ContactResult& result, const Vec3& after_W);
  [[nodiscard]] const TickFigures& figures() const noexcept { return this->figures_; }

private:
  void judgePath(const Vec3& before_W, const Vec3& after_W);
  void judgeRest(const Vec3& p_W, const Vec3& after_W);
  void judgeHold(const Vec3& p_W, const Vec3& after_W);
  [[nodiscard]] bool couldCome(const Vec3& p_W, const Vec3& after_W) const;
  void note(std::uint64_t& count, const std::string& what, const Vec3& p_W, const Vec3& after_W);

  ContactPlan plan_;
  double size_u_;
  std::shared_ptr<const TriangleGrid> grid_;
  PathChecker path_;
  Vec3 pathEnd_W_ = Vec3::Zero();
  TickFigures figures_;
};

} // namespace palpate::test
