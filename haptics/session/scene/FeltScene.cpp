// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/FeltScene.h"

#include "haptics/session/HapticSession.h"
#include <algorithm>
#include <utility>

#include "haptics/geometry/scene/SceneMotion.h"
#include "haptics/session/LoopReport.h"
#include "haptics/session/PlanText.h"

namespace palpate
{
namespace
{

/// A longer time between two snapshots was a rest, not a motion.
constexpr double longestMotion_s = 0.2;

/// A surface that moves again within that time was not at rest.
constexpr double rest_s = 1.0;

bool searched(const SurfaceChoice& choice)
{
  return choice.reason.empty();
}

/// The known part of a scene that comes after another.
LoadedRegion knownOf(const BuiltScene& now, const BuiltScene& before)
{
  if (!now.scene || now.part.whole == 0)
  {
    return {};
  }
  const bool same = before.scene && before.part.whole == now.part.whole;
  return { now.scene->geometryHash(), same ? before.scene->geometryHash() : 0, now.part.centre_W, now.part.reach_u };
}

} // namespace

void FeltScene::beforeCommit()
{
  this->search_.cancel();
  this->worker_.follow(this->session_.running() ? this->full_.scene : nullptr);
}

bool FeltScene::takeBuilt(const SimplifyPlan& plan, double now_s, bool wait)
{
  std::optional<BuiltScene> built = wait ? this->worker_.wait() : this->worker_.poll();
  if (!built)
  {
    return false;
  }
  if (this->session_.running() && this->built_.scene)
  {
    const HapticState& felt = this->session_.state();
    const Scene& now = *this->full_.scene; // moving surfaces are felt with all their triangles
    const double share = felt.sceneRevision == now.revision() ? felt.sceneShare : 0.0;
    const double motion_s = std::clamp(built->stamp_s - this->built_.stamp_s, this->period_s_, longestMotion_s);
    built->scene = movingFrom(now, share, built->scene, motion_s);
  }
  this->lookAround(built->scene.get());
  built->known = knownOf(*built, this->built_);
  const bool parts = built->known.geometry != 0 || this->built_.known.geometry != 0;
  this->built_ = std::move(*built);
  if (parts)
  {
    this->tellKnown();
  }
  this->handOver_s_ = std::max(0.0, now_s - this->built_.stamp_s);
  this->session_.setScene(this->built_.scene, this->around_ ? std::optional(this->around_->from_W) : std::nullopt);
  this->full_ = this->built_;
  this->worker_.follow(this->session_.running() ? this->full_.scene : nullptr);
  this->plan(plan);
  return true;
}

/// Before it has the scene, which it takes in the same tick or later.
void FeltScene::tellKnown()
{
  HapticParameters told = this->session_.parameters();
  told.known = this->built_.known;
  static_cast<void>(this->session_.setParameters(told)); // finite, for the places of data are
}

void FeltScene::ask(std::uint64_t request)
{
  if (this->built_.known.geometry != 0 && this->built_.known.asked != request)
  {
    this->built_.known.asked = request;
    this->tellKnown();
  }
}

/// A scene that the servo has not taken yet has changed nothing: the scene around the hand counts.
void FeltScene::lookAround(const Scene* next)
{
  this->around_.reset();
  if (!this->session_.running())
  {
    this->lastFelt_.reset();
    this->within_.clear();
    return;
  }
  const HapticState& felt = this->session_.state();
  const std::uint64_t newest = this->session_.scene() ? this->session_.scene()->revision() : 0; // of nothing: 0
  if (felt.sceneRevision == newest)
  {
    this->lastFelt_ = this->session_.scene();
  }
  if (this->hasMoved())
  {
    this->pinned_ = this->session_.report().pinnedTicks;
    this->within_ = surfacesAround(*this->session_.scene(), this->session_.parameters().contact, felt.proxy_W.p);
  }
  const bool hasHand = felt.tick > 0 && !felt.held && felt.proxy_W.p.allFinite();
  if (next != nullptr && hasHand)
  {
    this->around_ = palpate::cameAround(
      this->lastFelt_.get(), *next, this->session_.parameters().contact, felt.proxy_W.p, this->eye_W_);
  }
}

/// The servo has the newest scene, and its moving surfaces have arrived.
bool FeltScene::hasMoved() const
{
  const Scene* const scene = this->session_.scene().get();
  const HapticState& felt = this->session_.state();
  return scene != nullptr && felt.sceneRevision == scene->revision() && felt.sceneShare >= 1.0;
}

bool FeltScene::takeOutSqueezed()
{
  if (!this->session_.running() || this->session_.report().pinnedTicks == this->pinned_ || !this->hasMoved())
  {
    return false;
  }
  this->pinned_ = this->session_.report().pinnedTicks;
  const HapticParameters& parameters = this->session_.parameters();
  const std::optional<CameAround> into =
    squeezedInto(*this->session_.scene(), parameters.contact, this->within_, this->session_.state().proxy_W.p);
  if (!into || !this->session_.setParameters(parameters, into->from_W).empty())
  {
    return false;
  }
  this->around_ = into;
  return true;
}

void FeltScene::plan(const SimplifyPlan& plan)
{
  this->search_.cancel();
  this->choices_.clear();
  this->plan_ = plan;
  if (!this->full_.scene)
  {
    return;
  }
  this->choices_ = chooseAtFirst(*this->full_.scene, this->full_.traits, plan.rules);
  const bool part = this->full_.part.whole != 0;
  if (plan.off || part)
  {
    std::for_each(this->choices_.begin(), this->choices_.end(),
      [part](SurfaceChoice& choice)
      { choice.reason = part ? "it is the part around the hand" : "simpler surfaces are off"; });
  }
  if (std::any_of(this->choices_.begin(), this->choices_.end(), searched) &&
      this->search_.follow(this->full_.scene, this->choices_, plan.rules, this->worker_.takeRevision()))
  {
    this->swapIn(this->search_.poll());
  }
}

void FeltScene::follow(const SimplifyPlan& plan)
{
  if (plan == this->plan_)
  {
    return;
  }
  if (this->isSimpler())
  {
    this->built_ = this->full_;
    this->session_.setScene(this->built_.scene);
  }
  this->plan(plan);
}

void FeltScene::takeSimpler(bool wait)
{
  this->swapIn(wait ? this->search_.wait() : this->search_.poll());
}

void FeltScene::swapIn(std::optional<FoundScene> found)
{
  if (!found)
  {
    return;
  }
  this->choices_ = std::move(found->choices);
  if (!found->scene)
  {
    return;
  }
  for (const SurfaceChoice& choice : this->choices_)
  {
    if (choice.felt < choice.triangles)
    {
      this->built_.report += choice.name + ": " + planText(choice) + "\n";
    }
  }
  this->built_.scene = std::move(found->scene);
  this->built_.largestRadius_u = found->largestRadius_u;
  this->session_.setScene(this->built_.scene);
}

bool FeltScene::isTaken()
{
  return !this->session_.running() || !this->built_.scene ||
         this->session_.state().sceneRevision == this->built_.scene->revision();
}

bool FeltScene::rests()
{
  const Scene* const scene = this->built_.scene.get();
  return this->session_.running() && scene && scene->moves() && this->isTaken() &&
         this->session_.state().sceneAge_s > scene->motion_s() + rest_s;
}

} // namespace palpate
