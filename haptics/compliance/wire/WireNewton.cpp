// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/wire/WireNewton.h"

#include <algorithm>

#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

/// How much of a step is taken.
double shareOf(const Wire& wire, const WireVector& motion) noexcept
{
  constexpr double mostTurn_rad = 0.5; // of a node, or a chord, in a step
  double most = mostTurn_rad;
  for (int i = 0; i < wire.nodes(); ++i)
  {
    most = std::max(most, motion[i].tail<3>().norm());
    if (i < wire.count)
    {
      most = std::max(most, (motion[i + 1] - motion[i]).head<3>().norm() / wire.beams[i].length_u);
    }
  }
  return mostTurn_rad / most;
}

/// Projection across a wire at a node: across the chord between its neighbours.
Mat3 acrossWire(const Wire& wire, const WirePlaces& places_W, int node) noexcept
{
  const Vec3 along_W = (places_W[std::min(node + 1, wire.count)].p - places_W[std::max(node - 1, 0)].p).normalized();
  return Mat3::Identity() - along_W * along_W.transpose();
}

bool isHeld(std::uint8_t held, int motion) noexcept
{
  return (held >> motion & 1) != 0;
}

/// Leaves held motions of a node at 0.
void holdOwn(std::uint8_t held, NodeBlock& own) noexcept
{
  for (int m = 0; m < 6; ++m)
  {
    if (isHeld(held, m))
    {
      own.row(m).setZero();
      own.col(m).setZero();
      own(m, m) = 1.0;
    }
  }
}

} // namespace

WireLoads::WireLoads() noexcept
{
  this->force.fill(NodeVector::Zero());
  this->falls.fill(NodeVector::Zero());
  this->pulledTo_W.fill(Vec3::Zero());
}

void WireNewton::assemble(const Wire& wire, const WirePlaces& places_W) noexcept
{
  this->energy_Nu_ = 0.0;
  this->stiffness_.nodes = wire.nodes();
  this->inner_[0].setZero();
  this->stiffness_.own[0].setZero();
  BeamAnswer answer;
  for (int i = 0; i < wire.count; ++i)
  {
    bendBeam(wire.beams[i], places_W[i], places_W[i + 1], answer);
    this->energy_Nu_ += answer.energy_Nu;
    this->inner_[i] += answer.gradient[0];
    this->inner_[i + 1] = answer.gradient[1];
    this->stiffness_.own[i] += answer.firstFirst;
    this->stiffness_.own[i + 1] = answer.secondSecond;
    this->stiffness_.after[i] = answer.firstSecond;
  }
}

void WireNewton::addLoads(const Wire& wire, const WirePlaces& places_W, const WireLoads& loads) noexcept
{
  for (int i = 0; i < wire.nodes(); ++i)
  {
    this->open_[i] = loads.force[i] - this->inner_[i];
    this->open_[i].head<3>() += loads.spring_N_per_u[i] * (loads.pulledTo_W[i] - places_W[i].p);
    auto own = this->stiffness_.own[i].diagonal();
    own += loads.falls[i];
    own.head<3>().array() += loads.spring_N_per_u[i] + loads.placeDrag_N_per_u;
    own.tail<3>().array() += loads.turnDrag_Nu_per_rad;
    this->stiffness_.own[i].topLeftCorner<3, 3>() += loads.acrossDrag_N_per_u[i] * acrossWire(wire, places_W, i);
  }
  if (loads.ring.beam >= 0)
  {
    this->addRing(places_W, loads.ring);
  }
}

void WireNewton::addRing(const WirePlaces& places_W, const WireRing& ring) noexcept
{
  const int first = ring.beam, second = first + 1;
  const double ofFirst = 1.0 - ring.share, ofSecond = ring.share;
  for (const int axis : { 1, 2 })
  {
    const double off_u = ofFirst * places_W[first].p[axis] + ofSecond * places_W[second].p[axis];
    this->open_[first][axis] -= ofFirst * ring.hold_N_per_u * off_u;
    this->open_[second][axis] -= ofSecond * ring.hold_N_per_u * off_u;
    this->stiffness_.own[first](axis, axis) += ofFirst * ofFirst * ring.hold_N_per_u;
    this->stiffness_.own[second](axis, axis) += ofSecond * ofSecond * ring.hold_N_per_u;
    this->stiffness_.after[first](axis, axis) += ofFirst * ofSecond * ring.hold_N_per_u;
  }
}

void WireNewton::hold(const WireLoads& loads) noexcept
{
  WireMatrix& k = this->stiffness_;
  for (int i = 0; i < k.nodes; ++i)
  {
    holdOwn(loads.held[i], k.own[i]);
    for (int m = 0; m < 6; ++m)
    {
      if (isHeld(loads.held[i], m))
      {
        this->open_[i][m] = 0.0;
        if (i > 0)
        {
          k.after[i - 1].col(m).setZero();
        }
        if (i + 1 < k.nodes)
        {
          k.after[i].row(m).setZero();
        }
      }
    }
  }
}

bool WireNewton::linearise(const Wire& wire, const WirePlaces& places_W, const WireLoads& loads) noexcept
{
  constexpr int mostTries = 16;
  constexpr double firstShare = 1e-7, growth = 4.0; // of a beam's own stiffness
  this->assemble(wire, places_W);
  this->addLoads(wire, places_W, loads);
  this->hold(loads);
  const double length_u = wire.beams[0].length_u;
  this->residual_N_ = 0.0;
  for (int i = 0; i < wire.nodes(); ++i)
  {
    this->residual_N_ = std::max({ this->residual_N_, this->open_[i].head<3>().cwiseAbs().maxCoeff(),
      this->open_[i].tail<3>().cwiseAbs().maxCoeff() / length_u });
  }
  this->firm_ = this->factor_.factor(this->stiffness_);
  this->factors_ = 1;
  bool firm = this->firm_;
  double added = 0.0;
  for (int i = 0; i < mostTries && !firm; ++i)
  {
    const double share = added > 0.0 ? (growth - 1.0) * added : firstShare;
    added += share;
    for (int node = 0; node < wire.nodes(); ++node)
    {
      const WireBeam& beam = wire.beams[std::min(node, wire.count - 1)];
      const double turning_Nu = share * beam.section.bend_Nu2 / beam.length_u;
      NodeBlock& own = this->stiffness_.own[node];
      own.topLeftCorner<3, 3>() +=
        12.0 * turning_Nu / (beam.length_u * beam.length_u) * acrossWire(wire, places_W, node);
      own.diagonal().tail<3>().array() += turning_Nu;
      holdOwn(loads.held[node], own);
    }
    firm = this->factor_.factor(this->stiffness_);
    ++this->factors_;
  }
  return firm;
}

void WireNewton::step(WireVector& motion) const noexcept
{
  motion = this->open_;
  this->factor_.solve(motion);
}

void WireNewton::step(const WireVector& further, WireVector& motion) const noexcept
{
  for (int i = 0; i < this->stiffness_.nodes; ++i)
  {
    motion[i] = this->open_[i] + further[i];
  }
  this->factor_.solve(motion);
}

WireRest WireNewton::toRest(
  const Wire& wire, const WireLoads& loads, int mostSteps, double tolerance_N, WirePlaces& places_W) noexcept
{
  WireRest rest;
  bool able = this->linearise(wire, places_W, loads);
  while (able && rest.steps < mostSteps && !(this->residual_N_ <= tolerance_N))
  {
    this->step(this->motion_);
    moveWire(wire, this->motion_, places_W);
    ++rest.steps;
    able = this->linearise(wire, places_W, loads);
  }
  rest.residual_N = this->residual_N_;
  rest.met = this->residual_N_ <= tolerance_N;
  return rest;
}

double moveWire(const Wire& wire, const WireVector& motion, WirePlaces& places_W) noexcept
{
  const double share = shareOf(wire, motion);
  for (int i = 0; i < wire.nodes(); ++i)
  {
    places_W[i].p += share * motion[i].head<3>();
    places_W[i].q = turnBy(share * motion[i].tail<3>()) * places_W[i].q;
    places_W[i].q.normalize();
  }
  return share;
}

} // namespace palpate
