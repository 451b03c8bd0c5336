// SPDX-License-Identifier: GPL-3.0-or-later
// A thin sheet that is bent back on itself, pressed by a ball or a point on its upper leaf.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "SoftBlock.h"
#include "haptics/session/path/PathTouch.h"
#include "testing/oracles/finite/NeoHookeanSolid.h"
#include "testing/support/LongForm.h"

namespace palpate::test
{
namespace
{

constexpr double leafOfSheet_m = 0.06, widthOfSheet_m = 0.03, thickOfSheet_m = 0.004, gapOfSheet_m = 0.012;
constexpr double sheetSpring_N_per_m = 1000.0;
constexpr double sheetTick_s = 1e-3;

/// Of a hairpin: its lower leaf lies on z = 0, its upper one above it, both end at x = leafOfSheet_m; the bend is at x
/// < 0.
SoftBodyInput hairpin(ElasticModel model, double young_Pa)
{
  constexpr int alongLeaf = 20, alongBend = 10;
  constexpr double inner_m = 0.5 * gapOfSheet_m;
  SoftBodyInput input;
  input.mesh =
    blockOf({ 2 * alongLeaf + alongBend, 8, 2 }, { 2.0 * alongLeaf + alongBend, widthOfSheet_m, thickOfSheet_m });
  input.fixed.clear();
  for (Vec3& p : input.mesh.vertices_W)
  {
    const double along = p.x(), below = p.z(); // from the outer side of the sheet
    input.fixed.push_back(along <= alongLeaf && below == 0.0);
    if (along <= alongLeaf)
    {
      p = Vec3(leafOfSheet_m * (1.0 - along / alongLeaf), p.y(), below);
    }
    else if (along >= alongLeaf + alongBend)
    {
      p = Vec3(leafOfSheet_m * (along - alongLeaf - alongBend) / alongLeaf, p.y(),
        gapOfSheet_m + 2.0 * thickOfSheet_m - below);
    }
    else
    {
      const double turned = M_PI * (along - alongLeaf) / alongBend;
      const double r = inner_m + thickOfSheet_m - below;
      p = Vec3(-r * std::sin(turned), p.y(), inner_m + thickOfSheet_m - r * std::cos(turned));
    }
  }
  input.model = model;
  input.young_Pa = { young_Pa };
  return input;
}

constexpr double topOfSheet_m = gapOfSheet_m + 2.0 * thickOfSheet_m;
constexpr int ticksOnSheet = 425;

/// Down onto the upper leaf in the first quarter of the ticks, until the ball is `deep_m` deep, and along it.
Vec3 handOnSheet(int tick, double radius_u, double deep_m)
{
  const double share = static_cast<double>(tick) / ticksOnSheet;
  const double down = std::min(1.0, 4.0 * share);
  return { 0.005 + 0.045 * share, 0.5 * widthOfSheet_m + 0.001,
    topOfSheet_m + radius_u + 0.002 - down * (0.002 + deep_m) };
}

/// Fails at each tick, until the body goes through itself, in which the hand is deeper than .1 mm without a force
/// outward. How many ticks were as deep.
int ticksPushedOutward(ElasticModel model, double young_Pa, double radius_u, double deep_m)
{
  constexpr double below_m = 1e-4;
  HapticParameters parameters;
  parameters.stiffness_N_per_m = sheetSpring_N_per_m;
  parameters.contact.radius_u = radius_u;
  PathTouch touch(nullptr, parameters, sheetTick_s);
  std::string refusal;
  auto maker = BodyMaker::make(hairpin(model, young_Pa), "sheet", 0, refusal);
  EXPECT_EQ(refusal, "");
  touch.press(std::move(maker), 30.0);
  int below = 0;
  for (int i = 0; i < ticksOnSheet; ++i)
  {
    const Vec3 hand = handOnSheet(i, radius_u, deep_m);
    const HapticState state = touch.next(sheetTick_s * i, { hand, Quat::Identity() });
    if (touch.body()->shape().throughItself_u > 0.0)
    {
      EXPECT_TRUE(touch.body()->wentThroughItself());
      return below;
    }
    if (hand.z() < topOfSheet_m + radius_u - below_m)
    {
      ++below;
      EXPECT_GT(state.force_W.z(), 0.0) << young_Pa << " Pa, " << radius_u << " m, " << deep_m << " m, tick " << i;
    }
  }
  return below;
}

TEST(FoldedSheet, InEveryTickBelowItsSurfaceTheBallIsPushedOutward)
{
  using Sheet = std::pair<ElasticModel, double>;
  const Sheet soft(ElasticModel::NeoHookean, 50e3), hard(ElasticModel::Linear, 500e3);
  const Sheet other(ElasticModel::NeoHookean, 500e3), another(ElasticModel::Linear, 50e3);
  for (const auto& [model, young_Pa] : casesOf<Sheet>({ soft, hard, other, another }, { soft, hard }))
  {
    for (const double radius_u : { 0.005, 0.0 })
    {
      // 4 mm do not press the leaves together: none of the ticks after the first millimetres is left out.
      EXPECT_GT(ticksPushedOutward(model, young_Pa, radius_u, 0.004), 370);
      EXPECT_GT(ticksPushedOutward(model, young_Pa, radius_u, 0.016), 30);
    }
  }
}

/// A hairpin in equilibrium under a force into a vertex in the middle of its upper leaf, by an oracle: where the patch
/// of that vertex has gone. The sheet is made of linear tetrahedra, as the oracle has them. The patch's nodes and
/// weights are the product's own, and tested elsewhere (ComplianceSnapshot).
class PressedSheet
{
public:
  explicit PressedSheet(double young_Pa) : input_(hairpin(ElasticModel::NeoHookean, young_Pa))
  {
    this->input_.element = ElementKind::Linear;
    SoftBodyResult made = makeSoftBody(this->input_);
    EXPECT_EQ(made.refusal, "");
    this->surface_ = makeSoftSurface(*made.body, made.checked.mesh);
    std::vector<std::array<int, 4>> tetrahedra;
    for (const Tetra& t : made.checked.mesh.tetras)
    {
      tetrahedra.push_back(
        { static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2]), static_cast<int>(t[3]) });
    }
    this->solid_ = std::make_unique<oracle::NeoHookeanSolid>(
      made.checked.mesh.vertices_W, tetrahedra, young_Pa, this->input_.poisson);
    const std::vector<bool> fixed = made.checked.fixed;
    this->solid_->fix([&fixed](int node) { return fixed[static_cast<std::size_t>(node)]; });
    this->nodes_ = made.checked.mesh.vertices_W.size();
    const Vec3 place(0.5 * leafOfSheet_m, 0.5 * widthOfSheet_m, topOfSheet_m);
    for (std::size_t v = 0; v < this->surface_.rest_W.size(); ++v)
    {
      const auto off = [&](std::size_t i) { return (this->surface_.rest_W[i] - place).norm(); };
      this->vertex_ = off(v) < off(this->vertex_) ? v : this->vertex_;
    }
  }

  [[nodiscard]] const SoftBodyInput& input() const { return this->input_; }
  [[nodiscard]] const Vec3& vertex_W() const { return this->surface_.rest_W[this->vertex_]; }

  [[nodiscard]] Vec3 goneUnder(double force_N) const
  {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(this->nodes_));
    this->surface_.map.addForce(this->vertex_, Vec3(0.0, 0.0, -force_N), load);
    return this->surface_.map.displacementOf(this->vertex_, this->solid_->displacementUnder(load, 2));
  }

private:
  SoftBodyInput input_;
  SoftSurface surface_;
  std::unique_ptr<oracle::NeoHookeanSolid> solid_;
  std::size_t nodes_ = 0;
  std::size_t vertex_ = 0;
};

/// The force on a point that comes straight down to a place and stays there for a second.
Vec3 forceHeldAt(const SoftBodyInput& input, const Vec3& hand_W, double rate_Hz)
{
  constexpr double tick_s = 0.005, held_s = 1.5, above_m = 0.02;
  HapticParameters parameters;
  parameters.stiffness_N_per_m = sheetSpring_N_per_m;
  parameters.contact.radius_u = 0.0;
  PathTouch touch(nullptr, parameters, tick_s);
  std::string refusal;
  auto maker = BodyMaker::make(input, "sheet", 0, refusal);
  EXPECT_EQ(refusal, "");
  touch.press(std::move(maker), rate_Hz);
  Vec3 force_N = Vec3::Zero();
  const int ticks = rate_Hz > 0.0 ? static_cast<int>(held_s / tick_s) : 12;
  const int down = rate_Hz > 0.0 ? 100 : 6;
  for (int i = 0; i < ticks; ++i)
  {
    const Vec3 hand = hand_W + std::max(0.0, 1.0 - static_cast<double>(i) / down) * above_m * Vec3::UnitZ();
    force_N = touch.next(tick_s * i, { hand, Quat::Identity() }).force_W;
  }
  return force_N;
}

TEST(FoldedSheet, HeldAtRestItPushesWithTheForceOfItsEquilibriumAtFiniteStrain)
{
  const PressedSheet sheet(50e3);
  for (const double force_N : { 0.001, 0.003 }) // 2 and 6 mm down
  {
    // The flat leaf pushes along its undeformed normal. The hand is where the spring asks for that force at the
    // vertex that the sheet has let go down so far.
    const Vec3 gone_u = sheet.goneUnder(force_N);
    const Vec3 hand = sheet.vertex_W() + gone_u - force_N / sheetSpring_N_per_m * Vec3::UnitZ();
    for (const double rate_Hz : { 0.0, 30.0 })
    {
      const Vec3 felt_N = forceHeldAt(sheet.input(), hand, rate_Hz);
      EXPECT_LE((felt_N - force_N * Vec3::UnitZ()).norm(), 1e-3 * force_N)
        << rate_Hz << " Hz, " << 1e3 * gone_u.norm() << " mm";
    }
  }
}

} // namespace
} // namespace palpate::test
