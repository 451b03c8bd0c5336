// SPDX-License-Identifier: GPL-3.0-or-later
// A body that bears its weight before the hand comes.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "SoftBlock.h"
#include "haptics/recording/inputs/Bodies.h"
#include "haptics/session/soft/SoftWorker.h"
#include "testing/support/Eventually.h"
#include "testing/support/Says.h"

namespace palpate::test
{
namespace
{

using ::testing::HasSubstr;

constexpr double weight_N_per_m3 = 9810.0;
constexpr double heightOfBlock_m = 0.05;
constexpr double youngOfBlock_Pa = 20e3;

/// A quarter of each tetrahedron's weight on each corner. Without Poisson's ratio nothing bulges: the block is a
/// column.
SoftBodyInput weighingBlock(ElasticModel model, double share = 1.0)
{
  SoftBodyInput input = softBlock(model);
  input.poisson = 0.0;
  input.load_N.assign(input.mesh.vertices_W.size(), Vec3::Zero());
  for (const Tetra& t : input.mesh.tetras)
  {
    for (const std::uint32_t v : t)
    {
      input.load_N[v].z() -= 0.25 * share * weight_N_per_m3 * std::abs(volumeOf(input.mesh, t));
    }
  }
  return input;
}

/// u'' = w / E, 0 below and without strain above: w h^2 / 2 E at the top.
double sagOfTop_m()
{
  return 0.5 * weight_N_per_m3 * heightOfBlock_m * heightOfBlock_m / youngOfBlock_Pa;
}

double heightOfTop_m(const BodyMaker& maker)
{
  const BodyShape shape = maker.shape();
  for (std::size_t v = 0; v < shape.displacement_u.size(); ++v)
  {
    if ((maker.checked().mesh.vertices_W[v] - topOfBlock()).norm() < 1e-9)
    {
      return heightOfBlock_m + shape.displacement_u[v].z();
    }
  }
  return -1.0;
}

TEST(SoftLoads, ABlockSagsUnderItsWeightByHalfOfWhatItsWholeWeightOnTopWouldMake)
{
  std::string refusal;
  const auto maker = BodyMaker::make(weighingBlock(ElasticModel::Linear), "block", 0, refusal);
  ASSERT_TRUE(maker) << refusal;
  ASSERT_TRUE(maker->press({}, 0.04));
  EXPECT_NEAR(heightOfBlock_m - heightOfTop_m(*maker), sagOfTop_m(), 0.02 * sagOfTop_m());
  // Small strains, 2.5 % here: a model of large ones differs by about as much.
  const auto curved = BodyMaker::make(weighingBlock(ElasticModel::NeoHookean), "block", 0, refusal);
  ASSERT_TRUE(curved) << refusal;
  EXPECT_NEAR(heightOfBlock_m - heightOfTop_m(*curved), sagOfTop_m(), 0.06 * sagOfTop_m());
}

TEST(SoftLoads, ThatAreNoLoadsAreRefusedInWords)
{
  std::string refusal;
  SoftBodyInput input = weighingBlock(ElasticModel::Linear);
  input.load_N.front().x() = std::nan("");
  EXPECT_FALSE(BodyMaker::make(input, "block", 0, refusal));
  EXPECT_TRUE(test::says(refusal, { "finite", "number", "newtons" }));
  input.load_N.pop_back();
  EXPECT_FALSE(BodyMaker::make(input, "block", 0, refusal));
  EXPECT_THAT(refusal, HasSubstr("differs in length"));
}

Eigen::VectorXd weightOf(const SoftBody& body)
{
  Eigen::VectorXd load_N = Eigen::VectorXd::Zero(body.displacement().size());
  for (Eigen::Index n = 0; n < load_N.size(); n += 3)
  {
    load_N[n + 2] = -1e-3;
  }
  return load_N;
}

TEST(SoftLoads, AreGivenUpWithTheFactorThatIsUnderWayOnceTheBodyIsNotWanted)
{
  std::stop_source stop;
  const SoftBodyResult made = makeSoftBody(softBlock(ElasticModel::NeoHookean), stop.get_token());
  ASSERT_TRUE(made.body);
  const std::size_t before = made.body->factorings();
  stop.request_stop();
  EXPECT_FALSE(made.body->bear(weightOf(*made.body), stop.get_token()));
  EXPECT_EQ(made.body->factorings(), before);
  EXPECT_TRUE(made.body->bear(weightOf(*made.body)));
  EXPECT_GT(made.body->factorings(), before + 1);
  const SoftBodyResult refused = makeSoftBody(weighingBlock(ElasticModel::NeoHookean), stop.get_token());
  EXPECT_FALSE(refused.body);
  EXPECT_THAT(refused.refusal, HasSubstr("cancelled"));
}

TEST(SoftLoads, OfABodyThatIsNotWantedBeforeItIsThereAreNeverSaidAndTheNextBodyIsFelt)
{
  SoftLinks links;
  BackgroundWorker<SoftTask> worker(links, false);
  SoftBodyInput large = pad(12);
  large.load_N.assign(large.mesh.vertices_W.size(), Vec3(0, 0, -1e-4));
  const SoftChoice unwanted{ std::make_shared<const SoftBodyInput>(large), "large", 25.0 };
  const SoftChoice wanted{ std::make_shared<const SoftBodyInput>(weighingBlock(ElasticModel::NeoHookean)), "small",
    25.0 };
  for (int i = 0; i < 3; ++i)
  {
    worker.order({ unwanted, nullptr });
    worker.order({ wanted, nullptr });
    const auto isFelt = [&]
    {
      const SoftStatus status = worker.status();
      EXPECT_EQ(status.problem, "");
      return !status.building && status.snapshots > 0 && status.asMade &&
             status.asMade->mesh.tetras.size() == wanted.input->mesh.tetras.size();
    };
    EXPECT_TRUE(eventually(isFelt)) << i;
    worker.order({ unwanted, nullptr });
    worker.order({});
    EXPECT_TRUE(eventually([&] { return !worker.status().building && worker.status().snapshots == 0; })) << i;
    EXPECT_EQ(worker.status().problem, "");
  }
}

/// By superposition: its surface is elsewhere, its compliance and the energy that a force leaves in it are the same.
TEST(SoftLoads, OfALinearBodyMoveItsSurfaceAndChangeNothingOfHowItYields)
{
  BodyHand hand;
  hand.revision = 1;
  hand.ball_W = topOfBlock();
  hand.count = 1;
  hand.forceAt[0] = { { 0, 1, 2 }, Vec3(0.2, 0.3, 0.5), Vec3::Zero() };
  hand.force_N[0] = Vec3(0.1, 0.0, -1.0);
  std::shared_ptr<const PressedBody> pressed[2];
  std::unique_ptr<BodyMaker> makers[2];
  for (const int bears : { 0, 1 })
  {
    std::string refusal;
    makers[bears] = BodyMaker::make(weighingBlock(ElasticModel::Linear, bears), "block", 0, refusal);
    ASSERT_TRUE(makers[bears]) << refusal;
    pressed[bears] = makers[bears]->press(hand, 0.04);
    ASSERT_TRUE(pressed[bears]);
  }
  const ComplianceSnapshot &bare = *pressed[0]->snapshot, &loaded = *pressed[1]->snapshot;
  // A snapshot has the vertices that edges lead to within its reach. The weight strains no edge by more than the
  // column's foot: vertices that are nearer by that share are in both snapshots, and a vertex of one of them is not
  // further than that share beyond.
  const SoftBodyResult made = makeSoftBody(softBlock(ElasticModel::Linear));
  const SoftSurface surface = makeSoftSurface(*made.body, made.checked.mesh);
  const auto middle =
    std::ranges::min_element(surface.rest_W, {}, [](const Vec3& p) { return (p - topOfBlock()).squaredNorm(); }) -
    surface.rest_W.begin();
  const double reach_u = surface.patch_u[middle] + surface.edge_u[middle];
  const double strain = weight_N_per_m3 * heightOfBlock_m / youngOfBlock_Pa;
  const auto within = [&](double reach)
  { return nearVerticesOf(surface, surface.rest_W, topOfBlock(), reach, surface.rest_W.size()); };
  const auto has = [](const std::vector<std::uint32_t>& list, std::uint32_t v)
  { return std::ranges::count(list, v) == 1; };
  const std::vector<std::uint32_t> both = within((1.0 - strain) * reach_u), either = within((1.0 + strain) * reach_u);
  EXPECT_GT(both.size(), 9u);
  for (const std::uint32_t a : both)
  {
    ASSERT_TRUE(has(bare.near, a) && has(loaded.near, a)) << a;
    EXPECT_LE((bare.between(a, both[0]) - loaded.between(a, both[0])).norm(), 1e-12 * bare.compliance.norm());
  }
  for (const ComplianceSnapshot* snapshot : { &bare, &loaded })
  {
    EXPECT_TRUE(std::ranges::all_of(snapshot->near, // and the corners that are pressed
      [&](std::uint32_t v) { return has(either, v) || v < 3; }));
  }
  const double work_Nu = -hand.force_N[0].z() * yieldOfTop();
  EXPECT_NEAR(bare.energy_Nu, loaded.energy_Nu, 1e-9 * work_Nu);
  EXPECT_GT((bare.free_W.front() - loaded.free_W.front()).norm() + (bare.free_W.back() - loaded.free_W.back()).norm(),
    0.1 * sagOfTop_m());
  EXPECT_EQ(pressed[1]->scene->surfaces().front().tree->mesh().vertices_W.size(), loaded.free_W.size());
  EXPECT_NEAR(
    (pressed[1]->scene->surfaces().front().tree->mesh().vertices_W.back() - loaded.free_W.back()).norm(), 0.0, 1e-12);
}

} // namespace
} // namespace palpate::test
