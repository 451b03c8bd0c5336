// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/snapshot/SnapshotMaker.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <queue>

#include "haptics/compliance/body/KeptInverse.h"
#include "haptics/compliance/snapshot/PointCompliance.h"
#include "haptics/compliance/snapshot/SecantStep.h"

namespace palpate
{
namespace
{

/// Width of a patch over that of the contact: with it the depth of the ball beyond the patch never falls with force,
/// and a quarter of the width is left for the change of the force until the next snapshot.
constexpr double patchOverContact = 1.5;

/// Tangential over normal compliance of a contact on a half space (Mindlin 1949).
double acrossOver(double poisson)
{
  return (2.0 - poisson) / (2.0 * (1.0 - poisson));
}

/// Normals weighted by the triangles' areas. Triangles have no outer side of their own: at a vertex all are oriented as
/// its first one.
std::vector<Vec3> normalsOf(const SoftSurface& surface, const std::vector<Vec3>& places_W)
{
  std::vector<Vec3> normals(places_W.size(), Vec3::Zero());
  for (const auto& [a, b, c] : surface.triangles)
  {
    const Vec3 across = (places_W[b] - places_W[a]).cross(places_W[c] - places_W[a]);
    for (const std::uint32_t v : { a, b, c })
    {
      normals[v] += normals[v].dot(across) < 0.0 ? Vec3(-across) : across;
    }
  }
  for (Vec3& n : normals)
  {
    n.normalize();
  }
  return normals;
}

/// Dijkstra's distances along edges from some vertices; `from`: number of the nearest one of them.
struct EdgeDistances
{
  std::vector<double> distance_u;
  std::vector<std::uint32_t> from;
};

EdgeDistances distancesFrom(
  const SoftSurface& surface, const std::vector<Vec3>& places_W, const std::vector<std::uint32_t>& starts)
{
  EdgeDistances found{ std::vector<double>(places_W.size(), std::numeric_limits<double>::infinity()),
    std::vector<std::uint32_t>(places_W.size(), 0) };
  using Open = std::pair<double, std::uint32_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  for (std::uint32_t i = 0; i < starts.size(); ++i)
  {
    found.distance_u[starts[i]] = 0.0;
    found.from[starts[i]] = i;
    open.emplace(0.0, starts[i]);
  }
  while (!open.empty())
  {
    const auto [distance, v] = open.top();
    open.pop();
    if (distance > found.distance_u[v])
    {
      continue;
    }
    for (const std::uint32_t next : surface.neighbours[v])
    {
      const double way = distance + (places_W[next] - places_W[v]).norm();
      if (way < found.distance_u[next])
      {
        found.distance_u[next] = way;
        found.from[next] = found.from[v];
        open.emplace(way, next);
      }
    }
  }
  return found;
}

/// How many vertices a snapshot may compute anew: with a large factor so few that they cost some four times as much as
/// the rest of the snapshot. The nearest ones come first.
std::size_t newVertices(std::size_t factorBytes)
{
  constexpr std::size_t least = 8;
  constexpr std::size_t bytesOfAll = 16'000'000;
  return std::max(least, SnapshotMaker::usualVertices * bytesOfAll / std::max(factorBytes, bytesOfAll));
}

std::uint32_t nearestVertex(const std::vector<Vec3>& places_W, const Vec3& p_W)
{
  const auto nearer = [&p_W](const Vec3& a, const Vec3& b)
  { return (a - p_W).squaredNorm() < (b - p_W).squaredNorm(); };
  return static_cast<std::uint32_t>(std::min_element(places_W.begin(), places_W.end(), nearer) - places_W.begin());
}

/// Adds the corners of points, however far they are, and first in order: the last of the others make room.
void addCorners(const std::vector<SurfacePoint>& points, std::vector<std::uint32_t>& near)
{
  const auto isNear = [&near](std::uint32_t v) { return std::find(near.begin(), near.end(), v) != near.end(); };
  std::vector<std::uint32_t> far;
  for (const SurfacePoint& point : points)
  {
    std::copy_if(point.vertices.begin(), point.vertices.end(), std::back_inserter(far),
      [&](std::uint32_t v) { return !isNear(v) && std::find(far.begin(), far.end(), v) == far.end(); });
  }
  near.resize(std::min(near.size(), ComplianceSnapshot::mostVertices - far.size()));
  near.insert(near.begin(), far.begin(), far.end());
}

/// f C f for the forces at which a snapshot was linearised: the forces times their displacements.
double forceYieldOf(const ComplianceSnapshot& snapshot)
{
  std::vector<CompliantPoint> points;
  std::ranges::transform(snapshot.forceAt, std::back_inserter(points),
    [&snapshot](const SurfacePoint& at) { return compliantPoint(snapshot, at); });
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      sum += snapshot.force_N[i].dot(complianceBetween(snapshot, points[i], points[j]) * snapshot.force_N[j]);
    }
  }
  return sum;
}

} // namespace

std::vector<std::uint32_t> nearVerticesOf(
  const SoftSurface& surface, const std::vector<Vec3>& places_W, const Vec3& center_W, double reach_u, std::size_t most)
{
  const EdgeDistances ways = distancesFrom(surface, places_W, { nearestVertex(places_W, center_W) });
  std::vector<std::uint32_t> near;
  for (std::uint32_t v = 0; v < places_W.size(); ++v)
  {
    if (ways.distance_u[v] <= reach_u)
    {
      near.push_back(v);
    }
  }
  std::sort(near.begin(), near.end(),
    [&ways](std::uint32_t a, std::uint32_t b)
    { return std::pair(ways.distance_u[a], a) < std::pair(ways.distance_u[b], b); });
  near.resize(std::min(near.size(), most));
  return near;
}

/// Radius of the contact that the hand makes, or will make by the next snapshot.
double SnapshotMaker::contactAhead_u(const SnapshotRequest& request) const
{
  const std::uint32_t at = nearestVertex(this->untouched_W_, request.ball_W);
  const Vec3& n = this->normals_W_[at];
  Vec3 force_N = Vec3::Zero();
  for (const Vec3& f : request.force_N)
  {
    force_N += f;
  }
  // Before there is a snapshot of the ball: as on a half space.
  const double pressed_u = this->under_ ? this->under_->contactUnder(force_N.norm())
                                        : std::cbrt(force_N.norm() * request.radius_u / this->surface_.stiffness[at]);
  const double above_u = n.dot(request.ball_W - this->untouched_W_[at]);
  const double height_u = std::max(std::abs(above_u) - request.radius_u, 0.0);
  const double towards_u_per_s = above_u > 0.0 ? -n.dot(request.velocity_u_per_s) : n.dot(request.velocity_u_per_s);
  const double into_u = std::max(2.0 * request.period_s * towards_u_per_s - height_u, 0.0);
  return std::sqrt(pressed_u * pressed_u + request.radius_u * into_u);
}

/// Data for contacts of another ball or tip are of no more use, except those for patches of the mesh's own width,
/// which are the same for all. Each width keeps up to 7 MB (ComplianceCache).
void SnapshotMaker::pressWith(double radius_u, double tip_u)
{
  if (radius_u == this->radius_u_ && tip_u == this->tip_u_)
  {
    return;
  }
  std::erase_if(this->spreads_, [](const auto& spread) { return spread.first > 0.0; });
  this->under_.reset();
  this->level_ = mostHalvings;
  this->radius_u_ = radius_u;
  this->tip_u_ = tip_u;
}

/// Patches grow with the contact at once, and shrink when it has become much smaller.
SnapshotMaker::Spread& SnapshotMaker::spreadFor(const SnapshotRequest& request)
{
  this->pressWith(request.radius_u, request.tip_u);
  double spread_u = request.tip_u;
  if (request.radius_u > 0.0)
  {
    if (this->normals_W_.empty())
    {
      this->normals_W_ = normalsOf(this->surface_, this->untouched_W_);
    }
    const double wanted_u = patchOverContact * this->contactAhead_u(request);
    int level = mostHalvings;
    while (level > 0 && std::ldexp(request.radius_u, -level) < wanted_u)
    {
      --level;
    }
    this->level_ = level < this->level_ || level > this->level_ + 1 ? level : this->level_;
    spread_u = std::ldexp(request.radius_u, -this->level_);
  }
  // Where no patch would be wider than the mesh's own width, that width is enough.
  const double least_u = *std::ranges::min_element(this->surface_.patch_u);
  const double key_u = spread_u > least_u ? spread_u : 0.0;
  const auto found = this->spreads_.find(key_u);
  return found != this->spreads_.end()
           ? found->second
           : this->spreads_.try_emplace(key_u, this->body_, this->surface_, key_u).first->second;
}

void SnapshotMaker::choose(const SnapshotRequest& request, ComplianceSnapshot& snapshot) const
{
  const std::uint32_t at = nearestVertex(snapshot.free_W, request.ball_W);
  const double speed = request.velocity_u_per_s.norm();
  const double reach =
    this->surface_.patch_u[at] + request.radius_u + 2.0 * speed * request.period_s + this->surface_.edge_u[at];
  // Ahead by the age at which it is half used; further than half the reach the hand itself would be left out.
  const double ahead = std::min(1.5 * speed * request.period_s, 0.5 * reach);
  const Vec3 center = speed > 0.0 ? Vec3(request.ball_W + ahead / speed * request.velocity_u_per_s) : request.ball_W;
  snapshot.near = nearVerticesOf(this->surface_, snapshot.free_W, center, reach, usualVertices);
  addCorners(request.watched, snapshot.near);
  addCorners(request.forceAt, snapshot.near);
  // A strike lasts about as long as the hand takes to cross a patch; and a snapshot is no older than that either.
  snapshot.struck = speed * std::max(this->naturalPeriod_s_, request.period_s) > this->surface_.patch_u[at];
}

void SnapshotMaker::answerBy(std::shared_ptr<const KeptInverse> kept)
{
  this->kept_ = this->body_.stiffnessChanges() ? nullptr : std::move(kept);
}

void SnapshotMaker::addCompliance(Spread& spread, ComplianceSnapshot& snapshot)
{
  this->byKept_ = this->kept_ && this->kept_->knows(spread.patches.columnsOf(snapshot.near));
  if (spread.factoring != this->body_.factorings())
  {
    spread.factoring = this->body_.factorings();
    spread.known.forget();
    spread.rungs.clear();
    spread.depths.clear();
  }
  // To put vertices off does not pay for a factor that changes soon.
  const std::size_t most =
    this->body_.stiffnessChanges() ? ComplianceSnapshot::mostVertices : newVertices(this->body_.factorBytes());
  snapshot.near = spread.known.learn(snapshot.near, most, this->byKept_ ? this->kept_.get() : nullptr);
  snapshot.compliance = spread.known.between(snapshot.near);
  snapshot.placeOf = distancesFrom(this->surface_, snapshot.free_W, snapshot.near).from;
}

void SnapshotMaker::learnRungs(Spread& spread, const ComplianceSnapshot& snapshot) const
{
  std::vector<std::uint32_t> unknown;
  std::ranges::copy_if(snapshot.near, std::back_inserter(unknown),
    [&spread](std::uint32_t v) { return !spread.rungs.contains(v) && !spread.patches.radiiWithin(v).empty(); });
  if (unknown.empty())
  {
    return;
  }
  std::vector<Vec3> normals;
  std::ranges::transform(unknown, std::back_inserter(normals), [this](std::uint32_t v) { return this->normals_W_[v]; });
  const SparseColumns within = spread.patches.columnsWithin(unknown, normals);
  const Eigen::VectorXd own = this->byKept_ && this->kept_->knows(within)
                                ? Eigen::VectorXd(this->kept_->compliance(within, within).diagonal())
                                : this->body_.ownCompliance(within);
  Eigen::Index column = 0;
  for (const std::uint32_t v : unknown)
  {
    for (const double radius_u : spread.patches.radiiWithin(v))
    {
      spread.rungs[v].push_back({ radius_u, own[column++] });
    }
  }
}

BallDepth SnapshotMaker::depthAt(
  const ComplianceSnapshot& snapshot, std::size_t place, double ball_u, const std::vector<PatchRung>& within) const
{
  const std::uint32_t v = snapshot.near[place];
  const Vec3& n = this->normals_W_[v];
  const auto row = static_cast<Eigen::Index>(3 * place);
  std::vector<PatchRung> rungs = within;
  rungs.push_back({ snapshot.patchRadius_u[place], n.dot(snapshot.compliance.block<3, 3>(row, row) * n) });
  return { *this->layer_, ball_u, this->surface_.stiffness[v], this->edgeThatLacks_u(v), rungs };
}

/// The length of edge by which a patch lacks compliance (LayerCompliance). Mid-edge nodes halve the distance
/// between nodes.
double SnapshotMaker::edgeThatLacks_u(std::uint32_t vertex) const
{
  return (this->body_.points().halves.empty() ? 1.0 : 0.5) * this->surface_.edge_u[vertex];
}

void SnapshotMaker::prepareSurface(const ComplianceSnapshot& snapshot)
{
  if (!this->layer_)
  {
    this->layer_.emplace(this->surface_.poisson);
  }
  if (this->normals_W_.empty())
  {
    this->normals_W_ = normalsOf(this->surface_, snapshot.free_W);
  }
}

/// A tip that is narrower than its patch makes a dent below it: along the normal as on the layer with the same
/// compliance of the patch, along the surface by Mindlin's ratio further than on a half space. A part is as wide as its
/// contact.
void SnapshotMaker::addTips(const SnapshotRequest& request, ComplianceSnapshot& snapshot)
{
  const double tip_u = request.tip_u;
  this->prepareSurface(snapshot);
  const double nu = this->surface_.poisson;
  for (std::size_t i = 0; i < snapshot.near.size(); ++i)
  {
    const std::uint32_t v = snapshot.near[i];
    const double patch_u = snapshot.patchRadius_u[i];
    const double modulus = this->surface_.stiffness[v];
    const Vec3& n = this->normals_W_[v];
    const auto row = static_cast<Eigen::Index>(3 * i);
    Mat3 tip = Mat3::Zero();
    if (tip_u < patch_u && this->partAt(request, v) == nullptr)
    {
      const double found = n.dot(snapshot.compliance.block<3, 3>(row, row) * n);
      const double stiffening = this->layer_->stiffeningOf(patch_u, modulus * found, this->edgeThatLacks_u(v));
      const double in = std::max(this->layer_->of(tip_u, stiffening) / modulus - found, 0.0);
      const double aside = acrossOver(nu) * halfSpaceOfPatch * (1.0 / tip_u - 1.0 / patch_u) / modulus;
      tip = aside * Mat3::Identity() + (in - aside) * n * n.transpose();
    }
    snapshot.compliance.block<3, 3>(row, row) += tip;
  }
}

void SnapshotMaker::addSprings(const SnapshotRequest& request, Spread& spread, ComplianceSnapshot& snapshot)
{
  std::ranges::transform(snapshot.near, std::back_inserter(snapshot.patchRadius_u),
    [&spread](std::uint32_t v) { return spread.patches.radiusOf(v); });
  snapshot.springs.resize(snapshot.near.size());
  if (request.radius_u <= 0.0)
  {
    return;
  }
  this->prepareSurface(snapshot);
  this->learnRungs(spread, snapshot);
  if (spread.ball_u != request.radius_u)
  {
    spread.depths.clear();
    spread.ball_u = request.radius_u;
  }
  std::vector<double> lastRoots;
  for (std::size_t i = 0; i < snapshot.near.size(); ++i)
  {
    const std::uint32_t v = snapshot.near[i];
    if (!spread.depths.contains(v))
    {
      spread.depths.emplace(v, this->depthAt(snapshot, i, request.radius_u, spread.rungs[v]));
    }
    lastRoots.push_back(spread.depths.at(v).lastRoot());
  }
  this->under_ = spread.depths.at(snapshot.near[snapshot.placeOf[nearestVertex(snapshot.free_W, request.ball_W)]]);
  // One step for all: a stiff place, which takes more force for a contact of the same width, counts with at most twice
  // the median.
  const auto middle = lastRoots.begin() + static_cast<std::ptrdiff_t>(lastRoots.size() / 2);
  const double most = *std::ranges::max_element(lastRoots);
  std::ranges::nth_element(lastRoots, middle);
  const double step = std::min(most, 2.0 * *middle) / static_cast<double>(SubgridSpring::knots - 1);
  for (std::size_t i = 0; i < snapshot.near.size(); ++i)
  {
    snapshot.springs[i] = spread.depths.at(snapshot.near[i]).springOf(step);
    snapshot.springs[i].across = acrossOver(this->surface_.poisson);
  }
}

/// The stored energy is half of the forces times their displacements; the residual is zero, and the strain inside
/// is not computed.
SoftBodyState SnapshotMaker::stateOf(const ComplianceSnapshot& snapshot) const
{
  if (this->isSettled())
  {
    return this->body_.stateUnder(this->load_N_);
  }
  const Eigen::VectorXd load = loadOnPlaces(snapshot);
  SoftBodyState state;
  state.energy_Nu = 0.5 * load.dot(snapshot.compliance * load);
  return state;
}

std::shared_ptr<const ComplianceSnapshot> SnapshotMaker::make(const SnapshotRequest& request, int newtonSteps)
{
  Spread& spread = this->spreadFor(request);
  this->load_N_ = this->loadOf(request, spread);
  if (this->isSettled() && !this->body_.settle(this->load_N_, newtonSteps))
  {
    return nullptr;
  }
  auto snapshot = std::make_shared<ComplianceSnapshot>();
  snapshot->version = ++this->version_;
  snapshot->builtFromTick = request.tick;
  // For every model: continued along the tangent of a body that bends, the surface without the tool would lie far off,
  // on the other side of the tool even.
  snapshot->free_W = this->untouched_W_;
  this->choose(request, *snapshot);
  this->addCompliance(spread, *snapshot);
  this->addParts(request, spread, *snapshot);
  snapshot->forceAt = request.forceAt;
  snapshot->force_N = request.force_N;
  this->addSprings(request, spread, *snapshot);
  if (this->body_.stiffnessChanges())
  {
    takeSecant(
      timesColumns(this->columnsOf(request, spread, snapshot->near), this->body_.displacement() - this->body_.atRest()),
      *snapshot);
  }
  const SoftBodyState state = this->stateOf(*snapshot);
  snapshot->energy_Nu = state.energy_Nu - 0.5 * forceYieldOf(*snapshot);
  if (request.tip_u > 0.0 && request.radius_u <= 0.0)
  {
    this->addTips(request, *snapshot); // the servo counts the energy of the tips beside that of the body's state
  }
  snapshot->residual_N = state.residual_N;
  snapshot->mostGradient = state.mostGradient;
  return snapshot;
}

} // namespace palpate
