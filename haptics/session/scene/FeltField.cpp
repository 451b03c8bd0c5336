// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/FeltField.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "haptics/field/Smoothing.h"
#include "haptics/field/UsualGradient.h"

namespace palpate
{
namespace
{

bool asksForLevels(const FieldPlan& plan) noexcept
{
  return plan.detent.strength_N > 0.0 && !plan.detent.click;
}

/// To two digits, and never less.
double roundedUp(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::ceil(value / unit) * unit;
}

/// A block that is all of the data knows how steep they are.
MadeFieldBlock withLevels(MadeFieldBlock made, const FieldBlockWish& wish)
{
  const bool all = made.brick && std::isinf(made.reach_u);
  if (!wish.smoothLevels || made.levels != unknownLevels || !all)
  {
    return made;
  }
  for (const FieldBlockArray& array : made.brick->arrays())
  {
    const FieldBlockGrid& grid = made.brick->grid();
    made.levels =
      array.role == FieldBlockRole::Scalar ? levelBounds(array.values, grid.size, grid.spacing_u) : made.levels;
  }
  return made;
}

} // namespace

void FeltField::setSource(std::shared_ptr<const FieldSource> source)
{
  if (source != this->source_)
  {
    this->source_ = std::move(source);
    this->changed_ = true;
    this->task_.cancel();
    this->askedLevels_ = false;
    this->made_.levels = unknownLevels;
  }
}

/// Half of the margin: the other half is for the hand's motion until the next block is there.
bool FeltField::needsAnother(const FieldBlockWish& wish) const noexcept
{
  const std::optional<double>& level = wish.level;
  const FieldSmoothness& smooth = this->made_.smoothness;
  const bool otherLevel =
    level && std::isfinite(smooth.until) && !(smooth.level && std::fabs(*level - *smooth.level) <= smooth.until);
  return this->changed_ || otherLevel || (wish.smoothLevels && !this->askedLevels_) ||
         !((wish.centre_W - this->made_.centre_W).cwiseAbs().maxCoeff() <=
           0.5 * std::min(this->made_.reach_u, this->made_.finerReach_u));
}

void FeltField::ask(FieldBlockWish wish)
{
  this->changed_ = false;
  this->askedLevels_ = this->askedLevels_ || wish.smoothLevels;
  wish.revision = ++this->revision_;
  this->task_.want(
    [source = this->source_, wish](const std::stop_token&)
    {
      return LatestTask<MadeFieldBlock>::Work{ [source, wish] { return withLevels(source->brickAround(wish), wish); },
        !source->answersAnyThread() };
    });
}

std::optional<std::shared_ptr<const FieldBlock>> FeltField::take(bool wait)
{
  std::optional<MadeFieldBlock> made = wait ? this->task_.wait() : this->task_.poll();
  if (!made)
  {
    return std::nullopt;
  }
  made->levels = made->levels != unknownLevels ? made->levels : this->made_.levels;
  this->made_ = std::move(*made);
  this->taken_ = std::chrono::steady_clock::now();
  return this->made_.brick;
}

std::optional<std::shared_ptr<const FieldBlock>> FeltField::follow(
  const Vec3& hand_W, double reach_u, const FieldPlan& plan, bool wait)
{
  std::optional<std::shared_ptr<const FieldBlock>> next = this->take(wait);
  if (!this->source_)
  {
    if (std::exchange(this->changed_, false))
    {
      this->made_ = {};
      next = std::shared_ptr<const FieldBlock>();
    }
    return next;
  }
  const FieldBlockWish wish{ hand_W, reach_u, 0, plan.isosurface ? std::optional(plan.isovalue) : std::nullopt,
    asksForLevels(plan) };
  if (!this->task_.running() && hand_W.allFinite() && this->needsAnother(wish))
  {
    this->ask(wish);
    if (wait || !this->source_->answersAnyThread())
    {
      next = this->take(wait);
    }
  }
  return next;
}

double FeltField::age_s() const noexcept
{
  return this->made_.brick ? std::chrono::duration<double>(std::chrono::steady_clock::now() - this->taken_).count()
                           : 0.0;
}

HapticState ofFieldAlone(HapticState state) noexcept
{
  state.proxy_W.p = state.field.proxy_W;
  state.contacts = state.field.contacts;
  return state;
}

std::string pointText(const FieldPlan& plan, double radius_u)
{
  return plan.isosurface && radius_u > 0.0 ? "an isosurface is touched by a point at the centre of the proxy sphere"
                                           : "";
}

std::string latticeText(const FieldPlan& plan, const MadeFieldBlock& made, const Vec3& hand_W)
{
  const bool surfaces = plan.isosurface || (plan.detent.strength_N > 0.0 && plan.detent.click);
  if (!surfaces || made.whyNoCells.empty() || !made.brick)
  {
    return "";
  }
  std::ostringstream text;
  text << "its isosurfaces are rendered from samples " << made.brick->finestAt(hand_W).grid().spacing_u.maxCoeff()
       << " u apart there, not from its own cells: " << made.whyNoCells;
  return text.str();
}

void takeFromData(FieldPlan& plan, const MadeFieldBlock& made, bool first)
{
  const double slope_per_u = first && made.brick ? usualGradient(*made.brick) : 0.0;
  plan.detent.slope_per_u = slope_per_u > 0.0 ? slope_per_u : plan.detent.slope_per_u;
  plan.detent.bounds = made.levels;
}

std::string detentText(const FieldPlan& plan, double stiffness_N_per_u)
{
  const double most_N = mostSmooth_N(plan.detent, stiffness_N_per_u);
  if (plan.detent.click || !(plan.detent.strength_N > most_N))
  {
    return "";
  }
  if (!(most_N > 0.0))
  {
    return "smooth levels cannot hold the hand: the largest gradient is still unknown, or there are too many values, "
           "or only two samples along an axis; use Levels click";
  }
  std::ostringstream text;
  text
    << std::setprecision(2) << "smooth levels hold with " << most_N << " N at the usual gradient, and with at most "
    << roundedUp(mostFelt_N(plan.detent, stiffness_N_per_u))
    << " N at the steepest place: a larger force would make the hand jump between levels; increase Between levels, or "
       "use Levels click";
  return text.str();
}

FieldPlan withinEnds(FieldPlan plan, const FieldEnds& ends) noexcept
{
  const auto isThere = [&ends](double value) { return value >= ends[0] && value <= ends[1]; };
  if (!(ends[0] <= ends[1]))
  {
    return plan;
  }
  const DetentPlan& detent = plan.detent;
  const double first = detent.origin + detent.spacing * std::ceil((ends[0] - detent.origin) / detent.spacing);
  const bool level = detent.levelCount > 0
                       ? std::any_of(detent.levels.begin(), detent.levels.begin() + detent.levelCount, isThere)
                       : isThere(first);
  plan.detent.strength_N = level ? detent.strength_N : 0.0;
  plan.isosurface = plan.isosurface && isThere(plan.isovalue);
  return plan;
}

std::string levelText(const FieldPlan& plan, const FieldEnds& ends)
{
  const FieldPlan within = withinEnds(plan, ends);
  const bool surface = plan.isosurface && !within.isosurface;
  const bool levels = plan.detent.strength_N > 0.0 && !(within.detent.strength_N > 0.0);
  if (!surface && !levels)
  {
    return "";
  }
  std::ostringstream text;
  text << "its values range from " << ends[0] << " to " << ends[1] << ": ";
  if (surface)
  {
    text << "they do not contain the isovalue " << plan.isovalue;
  }
  text << (surface && levels ? ", and " : "") << (levels ? "they contain no level" : "");
  return text.str();
}

std::string levelProblem(const FieldPlan& plan, const FieldEnds& ends)
{
  return isOn(withinEnds(plan, ends)) ? "" : levelText(plan, ends);
}

std::string fieldText(const std::string& name, const MadeFieldBlock& made, double scale_u_per_m, double ahead_s)
{
  if (!made.brick && made.reach_u == 0.0)
  {
    return name + ": the samples around the hand are being loaded";
  }
  if (!made.brick)
  {
    return name + ": " + (made.problem.empty() ? "the hand is outside of the field" : made.problem);
  }
  const FieldBlockGrid& grid = made.brick->grid();
  std::string felt;
  for (const FieldBlockArray& array : made.brick->arrays())
  {
    felt += (felt.empty() ? "" : ", ") + array.name;
  }
  std::ostringstream text;
  text << name << ": " << felt << " on " << grid.size[0] << " x " << grid.size[1] << " x " << grid.size[2]
       << " points, " << grid.spacing_u.maxCoeff() << " u apart";
  if (const std::shared_ptr<const FieldBlock>& finer = made.brick->finer())
  {
    text << ", and " << finer->grid().spacing_u.maxCoeff() << " u where the cells are smaller";
  }
  if (const std::shared_ptr<const FieldCells>& cells = made.brick->cells())
  {
    text << ", isosurfaces in " << cells->parts().corners.size() << " cells of the data";
    if (std::isfinite(cells->parts().reach_u))
    {
      text << ", " << cells->parts().reach_u << " u around the hand";
    }
  }
  if (std::isfinite(made.reach_u))
  {
    text << ", " << made.reach_u << " u around the hand: sufficient for hand speeds of up to "
         << made.reach_u / scale_u_per_m / ahead_s << " m/s";
  }
  if (made.error > 0.0)
  {
    text << ", within " << std::setprecision(2) << 100.0 * made.error
         << " % of the data range of the values in the cells" << std::setprecision(6);
  }
  if (made.smoothness.passes > 0)
  {
    text << ", smoothed " << (made.smoothness.passes == 1 ? "once" : std::to_string(made.smoothness.passes) + " times");
  }
  if (made.smoothness.noise > trappingNoise && !made.brick->cells())
  {
    text << ": noise of " << made.smoothness.noise
         << " of a spacing would trap a hand, so that the smoothed isosurface is rendered";
  }
  return text.str();
}

} // namespace palpate
