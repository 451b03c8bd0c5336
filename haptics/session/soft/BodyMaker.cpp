// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/soft/BodyMaker.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "haptics/compliance/body/KeptInverse.h"
#include "haptics/compliance/body/NaturalPeriod.h"
#include "haptics/session/soft/BodySight.h"

namespace palpate
{
namespace
{

SnapshotRequest requestOf(const BodyHand& hand, double period_s)
{
  SnapshotRequest request;
  request.tick = hand.tick;
  request.ball_W = hand.ball_W;
  request.velocity_u_per_s = hand.velocity_u_per_s;
  request.radius_u = hand.radius_u;
  request.tip_u = hand.tip_u;
  request.period_s = period_s;
  request.forceAt.assign(hand.forceAt.begin(), hand.forceAt.begin() + hand.count);
  request.force_N.assign(hand.force_N.begin(), hand.force_N.begin() + hand.count);
  return request;
}

/// The surface at rest at the end of its motion.
Surface standing(Surface surface)
{
  surface.motion.begin_WS = surface.motion.end_WS;
  surface.from.reset();
  return surface;
}

} // namespace

std::unique_ptr<BodyMaker> BodyMaker::make(const SoftBodyInput& input, const std::string& name, std::uint64_t revision,
  std::string& refusal, const std::stop_token& stop)
{
  SoftBodyResult made = makeSoftBody(input, stop);
  refusal = made.refusal;
  return made.body ? std::unique_ptr<BodyMaker>(new BodyMaker(std::move(made), input, name, revision)) : nullptr;
}

BodyMaker::BodyMaker(SoftBodyResult made, const SoftBodyInput& input, std::string name, std::uint64_t revision)
  : checked_(std::move(made.checked)), name_(std::move(name)), body_(std::move(made.body)),
    surface_(makeSoftSurface(*this->body_, this->checked_.mesh)),
    snapshots_(*this->body_, this->surface_, naturalPeriod_s(*this->body_, input.density_kg_per_m3, input.unit_m)),
    first_(revision), revision_(revision)
{
  std::vector<bool> held;
  std::ranges::transform(this->surface_.vertices, std::back_inserter(held),
    [this](std::uint32_t node) { return static_cast<bool>(this->checked_.fixed[node]); });
  this->heldFaces_ = heldFaces({ this->surface_.rest_W, this->surface_.triangles }, held);
  this->held_ = this->heldFaces_ ? sceneOfHeld(*this->heldFaces_) : nullptr;
  (void)this->surfacesWith(this->surface_.rest_W, false); // so that the builder numbers vertices as the snapshots do
}

void BodyMaker::touch(std::shared_ptr<const Scene> beside)
{
  if (beside != this->beside_)
  {
    this->beside_ = std::move(beside);
    this->scene_.reset();
  }
}

/// Empty where the built surface lacks vertices that the snapshots number: coordinates are not finite, or vertices
/// meet. The other surfaces move once along the path that their scene gives them, and stand at its end afterwards.
std::vector<Surface> BodyMaker::surfacesWith(const std::vector<Vec3>& free_W, bool standingBeside)
{
  std::vector<Surface> surfaces = this->beside_ ? this->beside_->surfaces() : std::vector<Surface>();
  std::erase_if(surfaces, [this](const Surface& surface) { return surface.name == this->name_; });
  if (standingBeside)
  {
    std::transform(surfaces.begin(), surfaces.end(), surfaces.begin(), standing);
  }
  SurfaceInput input;
  input.name = this->name_;
  input.mesh = std::make_shared<TriangleMesh>(TriangleMesh{ free_W, this->surface_.triangles });
  const auto own = this->builder_.build({ input }, this->scene_.get()).scene;
  const bool numbered = own && own->surfaces().front().tree->mesh().vertices_W.size() == this->surface_.rest_W.size();
  if (!numbered)
  {
    return {};
  }
  surfaces.push_back(own->surfaces().front());
  return surfaces;
}

/// The body's own surface is always the free one. At its first snapshot the other surfaces have ended their motion.
std::shared_ptr<const Scene> BodyMaker::sceneOf(const ComplianceSnapshot& snapshot)
{
  if (this->scene_)
  {
    return this->scene_;
  }
  const std::uint64_t revision = this->beside_ ? this->beside_->revision() : 1;
  const bool arrived = this->revision_ == this->first_;
  std::vector<Surface> surfaces = this->surfacesWith(snapshot.free_W, arrived);
  if (surfaces.empty())
  {
    return nullptr;
  }
  const double motion_s = this->beside_ && !arrived ? this->beside_->motion_s() : 0.0;
  this->scene_ = std::make_shared<const Scene>(revision, std::move(surfaces), motion_s);
  return this->scene_;
}

std::shared_ptr<const PressedBody> BodyMaker::press(const BodyHand& hand, double period_s, int newtonSteps)
{
  SnapshotRequest request = requestOf(hand, period_s);
  if (hand.revision <= this->first_)
  {
    request.forceAt.clear();
    request.force_N.clear();
  }
  request.watched = this->watched_;
  request.parts = this->parts_;
  const auto snapshot = this->snapshots_.make(request, newtonSteps);
  const auto scene = snapshot ? this->sceneOf(*snapshot) : nullptr;
  if (!scene)
  {
    return nullptr;
  }
  this->hand_W_ = hand.device_W;
  this->last_ = snapshot;
  this->underPoints_ = hand.radius_u <= 0.0;
  auto pressed = std::make_shared<PressedBody>();
  pressed->revision = ++this->revision_;
  pressed->period_s = period_s;
  pressed->scene = scene;
  pressed->beside = this->beside_ ? this->beside_->geometryHash() : 0;
  pressed->snapshot = snapshot;
  pressed->heldFaces = this->heldFaces_;
  pressed->held = this->held_;
  pressed->touch = { static_cast<std::uint32_t>(pressed->scene->surfaces().size() - 1), snapshot.get() };
  return pressed;
}

bool BodyMaker::wentThroughItself() const
{
  if (this->wentThroughItself_ || !this->last_)
  {
    return this->wentThroughItself_;
  }
  const BodySight sight = this->sight();
  return throughItself_u(sight, displacementOf(sight)) > 0.0;
}

BodySight BodyMaker::sight() const
{
  BodySight sight;
  sight.body = this->body_.get();
  sight.surface = &this->surface_;
  sight.checked = &this->checked_;
  if (this->last_ && !this->snapshots_.isSettled())
  {
    sight.load_N = this->snapshots_.load_N();
  }
  else
  {
    sight.displacement_u = this->body_->displacement();
  }
  sight.snapshot = this->last_;
  sight.underPoints = this->underPoints_;
  sight.hand_W = this->hand_W_;
  return sight;
}

BodyShape BodyMaker::shape() const
{
  return shapeOf(this->sight());
}

std::shared_ptr<KeptInverse> BodyMaker::keepAround(const Vec3& place_W)
{
  constexpr double staysWithin = 0.25; // of its reach: an inverse around nearly the same point would answer no more
  const double off_u = (place_W - this->keptAround_W_).norm();
  // A hand that strokes to and fro must not begin a new inverse at every turn.
  const bool mayAnswer =
    this->kept_ && (this->snapshots_.answeredByKept() ||
                     off_u <= (this->kept_->known() < this->kept_->size() ? 1.0 : staysWithin) * this->keptReach_u_);
  if (this->body_->stiffnessChanges() || mayAnswer)
  {
    return nullptr;
  }
  const std::vector<std::uint32_t> nodes = borderNodesFrom(this->surface_, place_W);
  this->snapshots_.answerBy(nullptr); // first, so that the old inverse leaves its memory to the new one
  this->kept_.reset();
  this->kept_ = std::make_shared<KeptInverse>(*this->body_, nodes);
  this->snapshots_.answerBy(this->kept_);
  this->keptAround_W_ = place_W;
  this->keptReach_u_ = nodes.size() <= KeptInverse::mostNodes
                         ? std::numeric_limits<double>::infinity() // all nodes of the border are in it
                         : (this->body_->points().rest_W[nodes[KeptInverse::mostNodes - 1]] - place_W).norm();
  return this->kept_;
}

} // namespace palpate
