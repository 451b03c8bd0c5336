// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

#include "haptics/session/mechanism/MechanismBodies.h"
#include "haptics/session/mechanism/MechanismTouch.h"
#include "testing/haptics/mechanism/WholeBar.h"

namespace palpate::test
{

/// A block of the pair, from z = low to z = high, of so many cells along x, y and z.
struct PairBlock
{
  std::array<int, 3> cells{};
  double low_m = 0.0, high_m = 0.0;
  double young_Pa = 20e3;
  double fixed_m = 0.0; ///< its nodes at this height are fixed
};

inline constexpr double pairWide_m = 0.08;

/// Square of that width, with its middle at x = y = 0.
inline SoftBodyInput pairBody(const PairBlock& block, double poisson)
{
  SoftBodyInput input;
  input.mesh = blockOf(block.cells, { pairWide_m, pairWide_m, block.high_m - block.low_m });
  for (Vec3& p : input.mesh.vertices_W)
  {
    p += Vec3(-0.5 * pairWide_m, -0.5 * pairWide_m, block.low_m);
  }
  input.fixed = fixedWhere(input.mesh, [&](const Vec3& p) { return std::abs(p.z() - block.fixed_m) < 1e-9; });
  input.young_Pa = { block.young_Pa };
  input.poisson = poisson;
  input.element = ElementKind::Linear;
  input.model = ElasticModel::Linear;
  return input;
}

/// The load of an even traction on the side of a block at a height: a third of each triangle for its corners.
inline std::vector<Vec3> evenLoad_N(const TetraMesh& mesh, double height_m, const Vec3& force_N)
{
  std::vector<Vec3> load_N(mesh.vertices_W.size(), Vec3::Zero());
  const auto isThere = [&](std::uint32_t v) { return std::abs(mesh.vertices_W[v].z() - height_m) < 1e-9; };
  for (const auto& t : borderOf(mesh))
  {
    if (std::ranges::all_of(t, isThere))
    {
      const Vec3& a = mesh.vertices_W[t[0]];
      const double area = 0.5 * (mesh.vertices_W[t[1]] - a).cross(mesh.vertices_W[t[2]] - a).norm();
      for (const std::uint32_t v : t)
      {
        load_N[v] += area / (3.0 * pairWide_m * pairWide_m) * force_N;
      }
    }
  }
  return load_N;
}

/// Soft bodies whose contacts with one another are found, beside a rod in the hand that touches nothing. Its check is
/// left out: it would refuse bodies that their loads bend into one another.
class PairAlone
{
public:
  explicit PairAlone(const std::vector<SoftBodyInput>& bodies, double friction = 0.0)
  {
    MechanismBody rod;
    rod.name = "rod";
    rod.kind = MechanismBodyKind::Held;
    rod.length_u = rod.diameter_u = 0.001;
    Mechanism mechanism;
    mechanism.bodies = { rod };
    std::vector<MechanismSoftInput> inputs;
    for (const SoftBodyInput& body : bodies)
    {
      MechanismBody soft;
      soft.name = "block " + std::to_string(inputs.size());
      soft.kind = MechanismBodyKind::Soft;
      mechanism.bodies.push_back(soft);
      inputs.push_back({ soft.name, std::make_shared<const SoftBodyInput>(body) });
    }
    mechanism.findsContacts = true;
    mechanism.foundFriction = friction;
    std::string refusal;
    this->bodies_ = MechanismBodies::make(inputs, refusal);
    if (!this->bodies_)
    {
      throw std::runtime_error(refusal);
    }
    this->plan_ = planMechanism(mechanism, this->bodies_->atRest(), 1);
    this->bodies_->hold(mechanism, this->plan_);
  }

  /// So many ticks, the bodies at rest in each.
  const MechanismResult& rest(int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      MechanismInput input;
      input.tick = static_cast<std::uint64_t>(i + 1);
      input.plan = &this->plan_;
      input.hand_W.p = Vec3(10.0, 0.0, 0.0);
      input.grip = { 1000.0, 1.0 };
      MechanismHand hand;
      hand.tick = input.tick;
      hand.plan = this->plan_.revision;
      hand.press(this->result_);
      this->bodies_->tell(hand);
      input.soft = this->bodies_->rest(20);
      input.found = &this->bodies_->found();
      this->result_ = this->tick_.step(input);
    }
    return this->result_;
  }

  [[nodiscard]] const MechanismBodies& bodies() const { return *this->bodies_; }

private:
  std::unique_ptr<MechanismBodies> bodies_;
  MechanismPlan plan_;
  MechanismTick tick_;
  MechanismResult result_;
};

/// Of the forces on a soft body, by its place among them.
inline Vec3 sumOn(const MechanismResult& r, int soft)
{
  Vec3 sum_N = Vec3::Zero();
  for (int p = 0; p < r.pressCount; ++p)
  {
    const MechanismPress& press = r.presses[static_cast<std::size_t>(p)];
    sum_N += press.soft == soft ? press.force_N : Vec3(Vec3::Zero());
  }
  return sum_N;
}

/// A bed below the free end of the bar, with vertices below those of the bar; so many cells through the bar.
inline SoftBodyInput bed(int through, double young_Pa = barYoung_Pa)
{
  constexpr double deep_m = 0.03;
  const double edge_m = barSize.z() / through;
  const auto cells = [edge_m](double length_m) { return static_cast<int>(std::lround(length_m / edge_m)); };
  const Vec3 size(0.07, 0.06, deep_m), low(0.05, -0.01, -gap_m - deep_m);
  SoftBodyInput input;
  input.mesh = blockOf({ cells(size.x()), cells(size.y()), cells(size.z()) }, size);
  for (Vec3& p : input.mesh.vertices_W)
  {
    p += low;
  }
  input.fixed = fixedWhere(input.mesh, [&low](const Vec3& p) { return p.z() < low.z() + 1e-9; });
  input.young_Pa = { young_Pa };
  input.poisson = 0.4;
  input.element = ElementKind::Linear;
  input.model = ElasticModel::Linear;
  return input;
}

/// A ball in the hand, and soft bodies in an order.
inline MechanismInputs ballOn(const std::vector<MechanismSoftInput>& bodies, double radius_m, double friction = 0.0)
{
  MechanismInputs inputs;
  MechanismBody tool;
  tool.name = "tool";
  tool.kind = MechanismBodyKind::Held;
  tool.mesh = heldMesh(makeIcosphere(3, radius_m));
  inputs.mechanism.bodies = { tool };
  for (const MechanismSoftInput& body : bodies)
  {
    MechanismBody soft;
    soft.name = body.name;
    soft.kind = MechanismBodyKind::Soft;
    inputs.mechanism.bodies.push_back(soft);
  }
  inputs.mechanism.findsContacts = true;
  inputs.mechanism.foundFriction = friction;
  inputs.soft = bodies;
  return inputs;
}

/// The bar, that bed, and a ball.
inline MechanismInputs onBarAndBed(int through, double friction = 0.0)
{
  return ballOn({ { "bar", std::make_shared<const SoftBodyInput>(bar({ 5 * through, 2 * through, through })) },
                  { "bed", std::make_shared<const SoftBodyInput>(bed(through)) } },
    0.015, friction);
}

} // namespace palpate::test
