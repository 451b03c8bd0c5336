// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/packet/PacketMaker.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <queue>

#include "haptics/compliance/packet/PointCompliance.h"

namespace palpate
{
namespace
{

/// Of 1 / (E* a): compliance of a half space under the patch's paraboloid of force, in the patch's own mean.
constexpr double halfSpaceOfPatch = 0.6587;

/// Dijkstra's distances along edges from some vertices; `from` says which of them is nearest.
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

/// How many vertices a packet may ask for that were never computed: of a large factor so few that they cost some four
/// times what the packet needs anyway. The nearest ones come first.
std::size_t newVertices(std::size_t factorBytes)
{
  constexpr std::size_t least = 8;
  constexpr std::size_t bytesOfAll = 16'000'000;
  return std::max(least, PacketMaker::usualVertices * bytesOfAll / std::max(factorBytes, bytesOfAll));
}

std::uint32_t nearestVertex(const std::vector<Vec3>& places_W, const Vec3& p_W)
{
  const auto nearer = [&p_W](const Vec3& a, const Vec3& b)
  { return (a - p_W).squaredNorm() < (b - p_W).squaredNorm(); };
  return static_cast<std::uint32_t>(std::min_element(places_W.begin(), places_W.end(), nearer) - places_W.begin());
}

/// However far they are, and asked for first: the last of the others make room.
void addCorners(const std::vector<SurfacePoint>& points, std::vector<std::uint32_t>& near)
{
  const auto isNear = [&near](std::uint32_t v) { return std::find(near.begin(), near.end(), v) != near.end(); };
  std::vector<std::uint32_t> far;
  for (const SurfacePoint& point : points)
  {
    std::copy_if(point.vertices.begin(), point.vertices.end(), std::back_inserter(far),
      [&](std::uint32_t v) { return !isNear(v) && std::find(far.begin(), far.end(), v) == far.end(); });
  }
  near.resize(std::min(near.size(), CompliancePacket::mostVertices - far.size()));
  near.insert(near.begin(), far.begin(), far.end());
}

/// f C f of the forces that a packet was linearised at: what they make yield, times them.
double forceYieldOf(const CompliancePacket& packet)
{
  std::vector<CompliantPoint> points;
  std::ranges::transform(packet.forceAt, std::back_inserter(points),
    [&packet](const SurfacePoint& at) { return compliantPoint(packet, at); });
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      sum += packet.force_N[i].dot(complianceBetween(packet, points[i], points[j]) * packet.force_N[j]);
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

Eigen::VectorXd PacketMaker::loadOf(const PacketRequest& request) const
{
  Eigen::VectorXd load = Eigen::VectorXd::Zero(this->body_.displacement().size());
  for (std::size_t i = 0; i < request.forceAt.size(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      this->surface_.map.addForce(
        request.forceAt[i].vertices[corner], request.forceAt[i].weights[corner] * request.force_N[i], load);
    }
  }
  return load;
}

void PacketMaker::choose(const PacketRequest& request, CompliancePacket& packet) const
{
  const std::uint32_t at = nearestVertex(packet.free_W, request.ball_W);
  const double speed = request.velocity_u_per_s.norm();
  const double reach =
    this->surface_.patch_u[at] + request.radius_u + 2.0 * speed * request.period_s + this->surface_.edge_u[at];
  // Ahead by what it will be old when it is half used; further than half the reach the hand itself would be left out.
  const double ahead = std::min(1.5 * speed * request.period_s, 0.5 * reach);
  const Vec3 center = speed > 0.0 ? Vec3(request.ball_W + ahead / speed * request.velocity_u_per_s) : request.ball_W;
  packet.near = nearVerticesOf(this->surface_, packet.free_W, center, reach, usualVertices);
  addCorners(request.forceAt, packet.near);
  // A strike lasts about as long as the hand takes for a patch; and a packet is no older than that either.
  packet.struck = speed * std::max(this->naturalPeriod_s_, request.period_s) > this->surface_.patch_u[at];
}

void PacketMaker::addCompliance(CompliancePacket& packet)
{
  if (this->body_.stiffnessChanges())
  {
    packet.compliance = this->body_.compliance(this->surface_.map.columnsOf(packet.near));
  }
  else
  {
    packet.near = this->known_.learn(packet.near, newVertices(this->body_.factorBytes()));
    packet.compliance = this->known_.between(packet.near);
  }
  packet.placeOf = distancesFrom(this->surface_, packet.free_W, packet.near).from;
}

void PacketMaker::addSprings(double radius_u, CompliancePacket& packet) const
{
  for (const std::uint32_t v : packet.near)
  {
    const double e = this->surface_.stiffness[v];
    const double a = this->surface_.patch_u[v];
    packet.patchRadius_u.push_back(a);
    packet.springs.push_back(radius_u > 0.0
                               ? SubgridSpring{ std::cbrt(9.0 / (16.0 * e * e * radius_u)), halfSpaceOfPatch / (e * a) }
                               : SubgridSpring{});
  }
}

std::shared_ptr<const CompliancePacket> PacketMaker::make(const PacketRequest& request, int newtonSteps)
{
  const Eigen::VectorXd load = this->loadOf(request);
  if (!this->body_.settle(load, newtonSteps))
  {
    return nullptr;
  }
  auto packet = std::make_shared<CompliancePacket>();
  packet->version = ++this->version_;
  packet->builtFromTick = request.tick;
  // What does not change with strain is, without the tool, where it was when its maker was made.
  packet->free_W =
    this->body_.stiffnessChanges()
      ? this->surface_.placesOf(Eigen::VectorXd(this->body_.displacement() - this->body_.linearAnswer(load)))
      : this->untouched_W_;
  this->choose(request, *packet);
  this->addCompliance(*packet);
  this->addSprings(request.radius_u, *packet);
  packet->forceAt = request.forceAt;
  packet->force_N = request.force_N;
  const SoftBodyState state = this->body_.stateUnder(load);
  packet->energy_Nu = state.energy_Nu - 0.5 * forceYieldOf(*packet);
  packet->residual_N = state.residual_N;
  packet->mostGradient = state.mostGradient;
  return packet;
}

} // namespace palpate
