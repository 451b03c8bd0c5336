// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/body/SoftBody.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "haptics/compliance/body/SurfaceLoads.h"
#include "haptics/compliance/solve/OldFactor.h"
#include "haptics/core/InTwo.h"

namespace palpate
{
namespace
{

/// Numbers of the free nodes. A mid-edge node is fixed where both ends of its edge are.
std::vector<std::int32_t> numberFree(const StrainPoints& points, const std::vector<bool>& fixed)
{
  std::vector<std::int32_t> numbers;
  std::int32_t next = 0;
  const auto number = [&](bool isFixed) { numbers.push_back(isFixed ? StiffnessPattern::fixedNode : next++); };
  std::for_each(fixed.begin(), fixed.end(), number);
  for (const auto& [a, b] : points.halves)
  {
    number(fixed[a] && fixed[b]);
  }
  return numbers;
}

/// Nodes: above this number an old factor reaches the equilibrium in less time than new ones, and as accurately.
constexpr std::size_t mostFactoredEachStep = 2000;

/// Bytes of as many numbers as an int counts, as CHOLMOD and the pattern do.
constexpr std::size_t mostCounted = sizeof(double) * std::numeric_limits<int>::max();

/// A sentence if the bytes are more than allowed.
std::string refuseBytes(std::size_t bytes, std::size_t most)
{
  if (bytes <= most)
  {
    return {};
  }
  return "the body needs about " + std::to_string(bytes >> 20) + " MB, more than the " + std::to_string(most >> 20) +
         " MB allowed: mesh it coarser";
}

/// Points of strain: above this number a second thread takes one half.
constexpr std::size_t mostAlone = 4000;

/// The sum of part(begin, end) over points. The result does not depend on which half is computed first.
template<class Part>
auto sumOf(std::size_t count, const Part& part)
{
  if (count <= mostAlone)
  {
    return part(0, count);
  }
  decltype(part(0, count)) sum, rest;
  inTwo(
    2, [&] { sum = part(0, count / 2); }, [&] { rest = part(count / 2, count); });
  sum += rest;
  return sum;
}

} // namespace

SoftBody::SoftBody(StrainPoints points, ElasticModel model, const std::vector<bool>& fixed)
  : points_(std::move(points)), model_(model), pattern_(points_, numberFree(points_, fixed)),
    stiffness_(pattern_.zeros()), factor_(stiffness_),
    factoring_(points_.rest_W.size() > mostFactoredEachStep ? Factoring::WhenOld : Factoring::EachStep),
    displacement_(Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(points_.rest_W.size()))),
    always_N_(Eigen::VectorXd::Zero(displacement_.size())), atRest_(displacement_)
{
}

std::size_t SoftBody::bytes() const
{
  const bool keepsSingle = this->stiffnessChanges() && this->factoring_ == Factoring::WhenOld;
  const std::size_t half = this->stiffness_.values.size() * sizeof(double);
  const std::size_t halves = this->points_.points.size() > mostAlone ? 2 * half : 0;
  return this->factorBytes() + (keepsSingle ? this->factorBytes() / 2 : 0) + halves;
}

Eigen::VectorXd SoftBody::gather(const Eigen::VectorXd& ofNodes) const
{
  Eigen::VectorXd ofFree(this->pattern_.order());
  for (std::size_t n = 0; n < this->points_.rest_W.size(); ++n)
  {
    if (const std::int32_t number = this->pattern_.numbers()[n]; number >= 0)
    {
      ofFree.segment<3>(3 * number) = ofNodes.segment<3>(3 * static_cast<Eigen::Index>(n));
    }
  }
  return ofFree;
}

Eigen::VectorXd SoftBody::scatter(const Eigen::VectorXd& ofFree) const
{
  Eigen::VectorXd ofNodes = Eigen::VectorXd::Zero(this->displacement_.size());
  for (std::size_t n = 0; n < this->points_.rest_W.size(); ++n)
  {
    if (const std::int32_t number = this->pattern_.numbers()[n]; number >= 0)
    {
      ofNodes.segment<3>(3 * static_cast<Eigen::Index>(n)) = ofFree.segment<3>(3 * number);
    }
  }
  return ofNodes;
}

void SoftBody::addForces(const StrainPoint& p, const Mat3& f, Eigen::VectorXd& ofNodes) const
{
  const Mat3 stress = p.volume_u3 * stressOf(this->model_, p.moduli, f);
  for (std::size_t a = p.first; a < p.first + p.count; ++a)
  {
    ofNodes.segment<3>(3 * static_cast<Eigen::Index>(this->points_.nodes[a])) -= stress * this->points_.gradients[a];
  }
}

Eigen::VectorXd SoftBody::forcesAt(const Eigen::VectorXd& displacement) const
{
  const std::span<const double> at(displacement.data(), static_cast<std::size_t>(displacement.size()));
  return sumOf(this->points_.points.size(),
    [this, at](std::size_t begin, std::size_t end)
    {
      Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(at.size()));
      for (std::size_t i = begin; i < end; ++i)
      {
        const StrainPoint& p = this->points_.points[i];
        this->addForces(p, this->points_.deformationAt(p, at), forces);
      }
      return forces;
    });
}

double SoftBody::energyAt(const Eigen::VectorXd& displacement) const
{
  const std::span<const double> at(displacement.data(), static_cast<std::size_t>(displacement.size()));
  const double energy = sumOf(this->points_.points.size(),
    [this, at](std::size_t begin, std::size_t end)
    {
      double sum = 0.0;
      for (std::size_t i = begin; i < end; ++i)
      {
        const StrainPoint& p = this->points_.points[i];
        sum += p.volume_u3 * energyDensity(this->model_, p.moduli, this->points_.deformationAt(p, at));
      }
      return sum;
    });
  return energy - this->always_N_.dot(displacement);
}

bool SoftBody::bear(const Eigen::VectorXd& always_N, const std::stop_token& stop)
{
  constexpr int mostSteps = 50;
  constexpr double openShare = 1e-6;
  this->always_N_ = always_N;
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(always_N.size());
  const bool rests = this->settle(nothing, mostSteps, stop) &&
                     this->stateUnder(nothing).residual_N <= openShare * always_N.lpNorm<Eigen::Infinity>();
  this->energyAtRest_Nu_ = this->energyAt(this->displacement_);
  this->atRest_ = this->displacement_;
  return rests;
}

SoftBodyState SoftBody::stateUnder(const Eigen::VectorXd& load_N) const
{
  const std::span<const double> at(this->displacement_.data(), static_cast<std::size_t>(this->displacement_.size()));
  SoftBodyState state;
  state.energy_Nu = -this->always_N_.dot(this->displacement_) - this->energyAtRest_Nu_;
  Eigen::VectorXd open = load_N + this->always_N_;
  for (const StrainPoint& p : this->points_.points)
  {
    const Mat3 f = this->points_.deformationAt(p, at);
    state.energy_Nu += p.volume_u3 * energyDensity(this->model_, p.moduli, f);
    state.mostGradient = std::max(state.mostGradient, (f - Mat3::Identity()).norm());
    this->addForces(p, f, open);
  }
  open = this->gather(open);
  state.residual_N = open.size() > 0 ? open.lpNorm<Eigen::Infinity>() : 0.0;
  return state;
}

void SoftBody::addPoints(std::size_t begin, std::size_t end, SparseLower& k) const
{
  const std::span<const double> at(this->displacement_.data(), static_cast<std::size_t>(this->displacement_.size()));
  for (std::size_t i = begin; i < end; ++i)
  {
    const StrainPoint& p = this->points_.points[i];
    this->pattern_.add(
      k, this->points_, i, stressDerivative(this->model_, p.moduli, this->points_.deformationAt(p, at)));
  }
}

/// Each half of many points is added up in a matrix of its own.
void SoftBody::assemble()
{
  const auto clear = [this](SparseLower& k)
  {
    if (k.values.empty())
    {
      k = this->pattern_.zeros();
      return;
    }
    std::ranges::fill(k.values, 0.0);
  };
  const std::size_t count = this->points_.points.size();
  clear(this->stiffness_);
  if (count <= mostAlone)
  {
    this->addPoints(0, count, this->stiffness_);
    return;
  }
  clear(this->otherHalf_);
  inTwo(
    2, [&] { this->addPoints(0, count / 2, this->stiffness_); },
    [&] { this->addPoints(count / 2, count, this->otherHalf_); });
  std::ranges::transform(
    this->stiffness_.values, this->otherHalf_.values, this->stiffness_.values.begin(), std::plus<>());
}

bool SoftBody::factorAssembled()
{
  ++this->factorings_;
  const bool factored = this->factor_.factor(this->stiffness_);
  if (!this->stiffnessChanges())
  {
    this->stiffness_ = {}; // not needed again
    this->otherHalf_ = {};
  }
  return factored;
}

bool SoftBody::refactor()
{
  this->assemble();
  return this->factorAssembled();
}

std::optional<Eigen::VectorXd> SoftBody::newtonStep(const Eigen::VectorXd& open, double share)
{
  this->assemble();
  if (this->factoring_ == Factoring::WhenOld && this->factor_.ready())
  {
    constexpr int mostIterations = 8; // as many solves cost about as much as a factor
    this->factor_.keepSingle();
    if (OldFactorAnswer answer =
          solveByOldFactor(this->stiffness_, this->factor_.single(), open, share, mostIterations);
        answer.reached)
    {
      return std::move(answer.x);
    }
  }
  return this->factorAssembled() ? std::optional(this->factor_.solve(open)) : std::nullopt;
}

bool SoftBody::settle(const Eigen::VectorXd& load_N, int steps, const std::stop_token& stop)
{
  if (!this->stiffnessChanges())
  {
    this->displacement_ = this->restUnder(load_N);
    return true;
  }
  // The stiffness of the first state leaves a larger error than this after a change of load, so that more is in vain.
  constexpr double firstShare = 0.03, laterShare = 1e-3;
  double energy = this->energyAt(this->displacement_);
  for (int i = 0; i < steps && !stop.stop_requested(); ++i)
  {
    const Eigen::VectorXd inner = this->innerForces();
    const Eigen::VectorXd open = this->gather(load_N + this->always_N_ + inner);
    const double rounding = std::numeric_limits<double>::epsilon() * inner.lpNorm<Eigen::Infinity>();
    if (open.lpNorm<Eigen::Infinity>() <= rounding)
    {
      return true;
    }
    const std::optional<Eigen::VectorXd> step = this->newtonStep(open, i == 0 && steps > 1 ? firstShare : laterShare);
    if (!step)
    {
      return false;
    }
    energy = this->stepDown(load_N, this->scatter(*step), open.dot(*step), energy);
  }
  return true;
}

double SoftBody::stepDown(const Eigen::VectorXd& load_N, const Eigen::VectorXd& step, double slope, double before)
{
  constexpr double enough = 1e-4; // Armijo's share of the decrease that the slope predicts.
  constexpr int mostHalvings = 20;
  const double work = load_N.dot(step);
  // Below the rounding error of the energy no change can be judged: such a step is accepted, for it is short.
  const double rounding = 1e-14 * (std::abs(before) + std::abs(work));
  const Eigen::VectorXd from = this->displacement_;
  double length = 1.0;
  double after = 0.0;
  for (int i = 0; i <= mostHalvings; ++i, length *= 0.5)
  {
    this->displacement_ = from + length * step;
    after = this->energyAt(this->displacement_);
    if (after - length * work <= before - enough * length * slope + rounding)
    {
      break;
    }
  }
  return after;
}

SparseColumns SoftBody::ofFree(const SparseColumns& h) const
{
  SparseColumns free;
  for (std::size_t c = 0; c < h.count(); ++c)
  {
    for (std::size_t i = h.start[c]; i < h.start[c + 1]; ++i)
    {
      if (const std::int32_t number = this->pattern_.numbers()[h.rows[i] / 3]; number >= 0)
      {
        free.rows.push_back(3 * number + h.rows[i] % 3);
        free.values.push_back(h.values[i]);
      }
    }
    free.start.push_back(free.rows.size());
  }
  return free;
}

Eigen::MatrixXd SoftBody::compliance(const SparseColumns& h) const
{
  return this->factor_.sharedCompliance(this->ofFree(h));
}

Eigen::VectorXd SoftBody::ownCompliance(const SparseColumns& h) const
{
  return this->factor_.ownCompliance(this->ofFree(h));
}

Eigen::MatrixXd SoftBody::compliance(const SparseColumns& h, const SparseColumns& n) const
{
  return this->factor_.sharedCompliance(this->ofFree(h), this->ofFree(n));
}

Eigen::VectorXd SoftBody::linearAnswer(const Eigen::VectorXd& load_N) const
{
  return this->scatter(this->factor_.solve(this->gather(load_N)));
}

namespace
{

constexpr const char* stopped = "the computation was cancelled";

/// Brings a body to equilibrium under its permanent loads; a sentence where it has none.
std::string bearLoads(
  const SoftBodyInput& input, const CheckedTetras& checked, SoftBody& body, const std::stop_token& stop)
{
  Eigen::VectorXd always_N = Eigen::VectorXd::Zero(body.displacement().size());
  for (std::size_t v = 0; !input.load_N.empty() && v < checked.sourceVertex.size(); ++v)
  {
    always_N.segment<3>(3 * static_cast<Eigen::Index>(v)) = input.load_N[checked.sourceVertex[v]];
  }
  if (!always_N.allFinite())
  {
    return "a load on the body is not a finite number of newtons";
  }
  spreadTractions(body.points(), checked.mesh, always_N);
  if (always_N.isZero(0.0) || body.bear(always_N, stop))
  {
    return {};
  }
  return stop.stop_requested()
           ? stopped
           : "the body has no equilibrium under its loads: reduce the loads, or use a stiffer material";
}

std::string refuseCounts(const SoftBodyInput& input)
{
  const std::size_t vertices = input.mesh.vertices_W.size(), moduli = input.young_Pa.size();
  return input.fixed.size() != vertices ? "the list of fixed vertices differs in length from the vertices of the body"
         : !input.load_N.empty() && input.load_N.size() != vertices
           ? "the list of loads differs in length from the vertices of the body"
         : moduli != 1 && moduli != input.mesh.tetras.size()
           ? "the number of Young's moduli is neither 1 nor the number of tetrahedra"
           : "";
}

} // namespace

SoftBodyResult makeSoftBody(const SoftBodyInput& input, const std::stop_token& stop)
{
  SoftBodyResult result;
  result.refusal = refuseCounts(input);
  if (!result.refusal.empty())
  {
    return result;
  }
  result.checked = checkTetras(input.mesh, input.fixed);
  result.refusal = result.checked.refusal;
  std::vector<ElasticModuli> moduli;
  for (std::size_t i = 0; result.refusal.empty() && i < result.checked.sourceTetra.size(); ++i)
  {
    const double young_Pa = input.young_Pa[input.young_Pa.size() == 1 ? 0 : result.checked.sourceTetra[i]];
    const Outcome<ElasticModuli> one = moduliOf(young_Pa, input.poisson, input.unit_m);
    const std::string modulus = refuseModulus(young_Pa);
    result.refusal = modulus.empty() ? one.problem : modulus;
    moduli.push_back(one.value);
  }
  const std::vector<bool>& fixed = result.checked.fixed;
  if (result.refusal.empty() && std::all_of(fixed.begin(), fixed.end(), [](bool held) { return held; }))
  {
    result.refusal = "all vertices of the body are fixed: leave some vertices free";
  }
  if (!result.refusal.empty())
  {
    return result;
  }
  StrainPoints points = makeStrainPoints(result.checked.mesh, input.element, moduli);
  result.refusal = refuseBytes(points.mostStiffnessBytes(), std::min(input.mostBytes, mostCounted));
  if (!result.refusal.empty())
  {
    return result;
  }
  auto body = std::make_unique<SoftBody>(std::move(points), input.model, fixed);
  // Without bytes there is no factor: its numbers are more than CHOLMOD counts.
  const std::size_t bytes = body->factorBytes() > 0 ? body->bytes() : mostCounted + 1;
  result.refusal = refuseBytes(bytes, std::min(input.mostBytes, mostCounted));
  if (!result.refusal.empty())
  {
    return result;
  }
  if (stop.stop_requested())
  {
    result.refusal = stopped;
    return result;
  }
  if (!body->refactor())
  {
    result.refusal = "The stiffness matrix is singular: parts of the mesh are connected only by a vertex or an edge, "
                     "or the moduli differ too much";
    return result;
  }
  result.refusal = bearLoads(input, result.checked, *body, stop);
  result.body = result.refusal.empty() ? std::move(body) : nullptr;
  return result;
}

} // namespace palpate
