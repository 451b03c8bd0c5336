// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/body/SoftBody.h"

#include <algorithm>
#include <limits>

#include "haptics/compliance/solve/OldFactor.h"

namespace palpate
{
namespace
{

/// Numbers of the free nodes. A node halfway is fixed where both ends of its edge are.
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

/// Of numbers that an int counts, as CHOLMOD and the pattern do.
constexpr std::size_t mostCounted = sizeof(double) * std::numeric_limits<int>::max();

/// A sentence where that much is more than allowed.
std::string refuseBytes(std::size_t bytes, std::size_t most)
{
  if (bytes <= most)
  {
    return {};
  }
  return "the body needs about " + std::to_string(bytes >> 20) + " MB, more than the " + std::to_string(most >> 20) +
         " MB allowed: mesh it coarser";
}

} // namespace

SoftBody::SoftBody(StrainPoints points, ElasticModel model, const std::vector<bool>& fixed)
  : points_(std::move(points)), model_(model), pattern_(points_, numberFree(points_, fixed)),
    stiffness_(pattern_.zeros()), factor_(stiffness_),
    displacement_(Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(points_.rest_W.size())))
{
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

Eigen::VectorXd SoftBody::forcesAt(const Eigen::VectorXd& displacement) const
{
  const std::span<const double> at(displacement.data(), static_cast<std::size_t>(displacement.size()));
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(displacement.size());
  for (const StrainPoint& p : this->points_.points)
  {
    const Mat3 stress = p.volume_u3 * stressOf(this->model_, p.moduli, this->points_.deformationAt(p, at));
    for (std::size_t a = p.first; a < p.first + p.count; ++a)
    {
      forces.segment<3>(3 * static_cast<Eigen::Index>(this->points_.nodes[a])) -= stress * this->points_.gradients[a];
    }
  }
  return forces;
}

double SoftBody::energyAt(const Eigen::VectorXd& displacement) const
{
  const std::span<const double> at(displacement.data(), static_cast<std::size_t>(displacement.size()));
  double energy = 0.0;
  for (const StrainPoint& p : this->points_.points)
  {
    energy += p.volume_u3 * energyDensity(this->model_, p.moduli, this->points_.deformationAt(p, at));
  }
  return energy;
}

SoftBodyState SoftBody::stateUnder(const Eigen::VectorXd& load_N) const
{
  const std::span<const double> at(this->displacement_.data(), static_cast<std::size_t>(this->displacement_.size()));
  SoftBodyState state;
  state.energy_Nu = this->energyAt(this->displacement_);
  const Eigen::VectorXd open = this->gather(load_N + this->innerForces());
  state.residual_N = open.size() > 0 ? open.lpNorm<Eigen::Infinity>() : 0.0;
  for (const StrainPoint& p : this->points_.points)
  {
    const Mat3 gradient = this->points_.deformationAt(p, at) - Mat3::Identity();
    state.mostGradient = std::max(state.mostGradient, gradient.norm());
  }
  return state;
}

void SoftBody::assemble()
{
  const std::span<const double> at(this->displacement_.data(), static_cast<std::size_t>(this->displacement_.size()));
  std::fill(this->stiffness_.values.begin(), this->stiffness_.values.end(), 0.0);
  for (std::size_t i = 0; i < this->points_.points.size(); ++i)
  {
    const StrainPoint& p = this->points_.points[i];
    this->pattern_.add(
      this->stiffness_, this->points_, i, stressDerivative(this->model_, p.moduli, this->points_.deformationAt(p, at)));
  }
}

bool SoftBody::factorAssembled()
{
  ++this->factorings_;
  return this->factor_.factor(this->stiffness_);
}

bool SoftBody::refactor()
{
  this->assemble();
  return this->factorAssembled();
}

std::optional<Eigen::VectorXd> SoftBody::newtonStep(const Eigen::VectorXd& open)
{
  // What Hooke's law makes of it does not change with the state.
  if (this->model_ == ElasticModel::Linear && this->factor_.ready())
  {
    return this->factor_.solve(open);
  }
  this->assemble();
  if (this->factoring_ == Factoring::WhenOld && this->factor_.ready())
  {
    constexpr double share = 1e-3;
    constexpr int mostIterations = 8; // as many solves cost about a factor
    if (OldFactorAnswer answer = solveByOldFactor(this->stiffness_, this->factor_, open, share, mostIterations);
        answer.reached)
    {
      return std::move(answer.x);
    }
  }
  return this->factorAssembled() ? std::optional(this->factor_.solve(open)) : std::nullopt;
}

bool SoftBody::settle(const Eigen::VectorXd& load_N, int steps)
{
  for (int i = 0; i < steps; ++i)
  {
    const Eigen::VectorXd inner = this->innerForces();
    const Eigen::VectorXd open = this->gather(load_N + inner);
    const double rounding = std::numeric_limits<double>::epsilon() * inner.lpNorm<Eigen::Infinity>();
    if (open.lpNorm<Eigen::Infinity>() <= rounding)
    {
      return true;
    }
    const std::optional<Eigen::VectorXd> step = this->newtonStep(open);
    if (!step)
    {
      return false;
    }
    this->stepDown(load_N, this->scatter(*step), open.dot(*step));
  }
  return true;
}

void SoftBody::stepDown(const Eigen::VectorXd& load_N, const Eigen::VectorXd& step, double slope)
{
  constexpr double enough = 1e-4; // Armijo's share of what the slope promises.
  constexpr int mostHalvings = 20;
  const double before = this->energyAt(this->displacement_);
  const double work = load_N.dot(step);
  // Below what rounding leaves of the energy nothing can be judged: the step is as good as its length is small.
  const double rounding = 1e-14 * (std::abs(before) + std::abs(work));
  double length = 1.0;
  for (int i = 0; i < mostHalvings; ++i, length *= 0.5)
  {
    const double now = this->energyAt(this->displacement_ + length * step) - length * work;
    if (now <= before - enough * length * slope + rounding)
    {
      break;
    }
  }
  this->displacement_ += length * step;
}

Eigen::MatrixXd SoftBody::compliance(const SparseColumns& h) const
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
  return this->factor_.sharedCompliance(free);
}

Eigen::VectorXd SoftBody::linearAnswer(const Eigen::VectorXd& load_N) const
{
  return this->scatter(this->factor_.solve(this->gather(load_N)));
}

SoftBodyResult makeSoftBody(const SoftBodyInput& input)
{
  SoftBodyResult result;
  if (input.fixed.size() != input.mesh.vertices_W.size())
  {
    result.refusal = "what is fixed has another number of vertices than the body";
    return result;
  }
  if (input.young_Pa.size() != 1 && input.young_Pa.size() != input.mesh.tetras.size())
  {
    result.refusal = "the moduli are neither one for all nor one a tetrahedron";
    return result;
  }
  result.checked = checkTetras(input.mesh, input.fixed);
  result.refusal = result.checked.refusal;
  std::vector<ElasticModuli> moduli;
  for (std::size_t i = 0; result.refusal.empty() && i < result.checked.sourceTetra.size(); ++i)
  {
    const double young_Pa = input.young_Pa[input.young_Pa.size() == 1 ? 0 : result.checked.sourceTetra[i]];
    const ModuliResult one = moduliOf(young_Pa, input.poisson, input.unit_m);
    result.refusal = one.refusal;
    moduli.push_back(one.moduli);
  }
  const std::vector<bool>& fixed = result.checked.fixed;
  if (result.refusal.empty() && std::all_of(fixed.begin(), fixed.end(), [](bool held) { return held; }))
  {
    result.refusal = "all of the body is fixed: nothing gives way";
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
  // No factor at all: its numbers are more than CHOLMOD counts.
  const std::size_t bytes = body->factorBytes();
  result.refusal = refuseBytes(bytes > 0 ? bytes : mostCounted + 1, std::min(input.mostBytes, mostCounted));
  if (!result.refusal.empty())
  {
    return result;
  }
  if (!body->refactor())
  {
    result.refusal =
      "the body's stiffness cannot be factored: parts of it hang together by a corner or an edge only, or "
      "its moduli differ too much";
    return result;
  }
  result.body = std::move(body);
  return result;
}

} // namespace palpate
