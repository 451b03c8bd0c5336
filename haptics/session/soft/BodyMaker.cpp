// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/soft/BodyMaker.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <Eigen/Geometry>

#include "haptics/compliance/body/NaturalPeriod.h"
#include "haptics/compliance/mesh/FilledTwice.h"
#include "haptics/compliance/snapshot/PointCompliance.h"

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

/// Where its way ends.
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
  (void)this->surfacesWith(this->surface_.rest_W, false); // numbered as the snapshots are
}

void BodyMaker::touch(std::shared_ptr<const Scene> beside)
{
  if (beside != this->beside_)
  {
    this->beside_ = std::move(beside);
    this->scene_.reset();
  }
}

/// None where the body has lost vertices that its snapshots number: where they are not numbers any more, or meet.
/// Those beside it are on the way that they have in their scene once, and stand where it ended afterwards.
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

/// The free surface is always the untouched one. What is beside a body that begins has gone its way before.
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
  const auto snapshot = this->snapshots_.make(request, newtonSteps);
  const auto scene = snapshot ? this->sceneOf(*snapshot) : nullptr;
  if (!scene)
  {
    return nullptr;
  }
  this->struck_ = snapshot->struck;
  this->throughItself_u_ = this->throughItself_u(*snapshot);
  this->wentThroughItself_ = this->wentThroughItself_ || this->throughItself_u_ > 0.0;
  this->hand_W_ = hand.device_W;
  this->last_ = hand.radius_u > 0.0 ? nullptr : snapshot; // what a ball presses on is shown dented by the ball
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

/// A place under a force goes with its patch, and between vertices further (PointCompliance.h), not with the nodes of
/// its triangle. Of each vertex of the surface, how much further than its node it is shown, so that such places are
/// where they are felt to be.
std::vector<Vec3> BodyMaker::dents_u() const
{
  std::vector<Vec3> dents(this->surface_.vertices.size(), Vec3::Zero());
  const std::size_t count = this->last_ ? this->last_->forceAt.size() : 0;
  std::vector<CompliantPoint> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back(compliantPoint(*this->last_, this->last_->forceAt[i]));
  }
  const std::vector<Vec3> places_W = count > 0 ? this->surface_.placesOf(*this->body_) : std::vector<Vec3>();
  for (const CompliantPoint& point : points)
  {
    Vec3 left = Vec3::Zero();
    for (std::size_t j = 0; j < count; ++j)
    {
      left += complianceBetween(*this->last_, point, points[j]) * this->last_->force_N[j];
    }
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t v = point.at.vertices[c];
      left += point.at.weights[c] * (this->last_->free_W[v] - places_W[v] - dents[v]);
    }
    for (int c = 0; c < 3; ++c)
    {
      dents[point.at.vertices[c]] += point.at.weights[c] / point.at.weights.squaredNorm() * left;
    }
  }
  return dents;
}

/// From where the ball presses most, the way that it pushes. A body does not meet itself: below a fold that is pressed
/// shut it goes on through itself.
double BodyMaker::throughItself_u(const ComplianceSnapshot& snapshot) const
{
  constexpr double rounding = 1e-9; // of the line
  const auto most = std::ranges::max_element(snapshot.force_N, {}, [](const Vec3& f) { return f.squaredNorm(); });
  if (most == snapshot.force_N.end() || most->squaredNorm() == 0.0)
  {
    return 0.0;
  }
  const TetraMesh& mesh = this->checked_.mesh;
  std::vector<Vec3> places_W;
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < mesh.vertices_W.size(); ++v)
  {
    places_W.emplace_back(
      mesh.vertices_W[v] + this->body_->displacement().segment<3>(3 * static_cast<Eigen::Index>(v)));
    box.extend(places_W.back());
  }
  const SurfacePoint& at = snapshot.forceAt[static_cast<std::size_t>(most - snapshot.force_N.begin())];
  LinePiece below{ Vec3::Zero(), most->normalized(), box.diagonal().norm() };
  for (int c = 0; c < 3; ++c)
  {
    below.from_W += at.weights[c] * places_W[this->surface_.vertices[at.vertices[c]]];
  }
  const double twice_u = filledTwice(mesh, places_W, below);
  return twice_u > rounding * below.length_u ? twice_u : 0.0;
}

void BodyMaker::addStrain(BodyShape& shape) const
{
  const StrainPoints& points = this->body_->points();
  const Eigen::VectorXd& u = this->body_->displacement();
  std::vector<Mat3> deformation;
  for (const StrainPoint& p : points.points)
  {
    deformation.push_back(points.deformationAt(p, { u.data(), static_cast<std::size_t>(u.size()) }));
    const double gradient = (deformation.back() - Mat3::Identity()).norm();
    if (gradient > shape.mostGradient)
    {
      shape.mostGradient = gradient;
      shape.worst_W = points.rest_W[points.nodesOf(p).front()];
    }
  }
  shape.deformation = points.deformationOfTetras(deformation);
}

BodyShape BodyMaker::shape() const
{
  BodyShape shape;
  shape.struck = this->struck_;
  shape.hand_W = this->hand_W_;
  shape.throughItself_u = this->throughItself_u_;
  for (std::size_t v = 0; v < this->checked_.mesh.vertices_W.size(); ++v)
  {
    shape.displacement_u.emplace_back(this->body_->displacement().segment<3>(3 * static_cast<Eigen::Index>(v)));
  }
  shape.dent_u.assign(shape.displacement_u.size(), Vec3::Zero());
  const std::vector<Vec3> dents = this->dents_u();
  for (std::size_t i = 0; i < this->surface_.vertices.size(); ++i)
  {
    if (const std::uint32_t node = this->surface_.vertices[i]; !this->checked_.fixed[node])
    {
      shape.dent_u[node] = dents[i]; // what is held is shown where it is held
    }
  }
  this->addStrain(shape);
  return shape;
}

} // namespace palpate
