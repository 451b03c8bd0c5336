// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/recording/inputs/FieldBlocks.h"
#include "haptics/session/scene/ComparedField.h"
#include "haptics/session/scene/FeltField.h"
#include "testing/support/Fields.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

/// A grid of its own with a function of W, which is there wherever it is asked for.
class GridSource : public FieldSource
{
public:
  GridSource(FieldBlockGrid grid, std::function<double(const Vec3&)> function)
    : grid_(std::move(grid)), function_(std::move(function))
  {
  }
  [[nodiscard]] MadeFieldBlock brickAround(const FieldBlockWish& wish) const override
  {
    const auto value = [this](const Vec3& index) { return this->function_(this->grid_.toWorld(index)); };
    return { std::make_shared<const FieldBlock>(wish.revision, this->grid_,
               std::vector<FieldBlockArray>{
                 { FieldBlockRole::Scalar, "f", test::sampledValues(this->grid_.size, value) } }),
      wish.centre_W, std::numeric_limits<double>::infinity(), "" };
  }

private:
  FieldBlockGrid grid_;
  std::function<double(const Vec3&)> function_;
};

const FieldBlockGrid coarseGrid{ { 9, 9, 9 }, Vec3::Ones() };
const FieldBlockGrid finerGrid{ { 12, 17, 17 }, Vec3::Constant(0.5), { Vec3(0.25, 0.0, 0.0) } };

TEST(ComparedField, IsComparedAtThePointsOfTheFieldAndOnlyWhereBothAre)
{
  const auto one = std::make_shared<GridSource>(coarseGrid, [](const Vec3& p) { return p.z(); });
  const auto other = std::make_shared<GridSource>(finerGrid, [](const Vec3& p) { return p.z() + 0.25 * p.x(); });
  const MadeFieldBlock made = comparedWith(one, other)->brickAround({ Vec3(4, 4, 4), 4.0, 7 });
  ASSERT_TRUE(made.brick);
  EXPECT_EQ(made.brick->revision(), 7U);
  for (double x = 1.0; x < 5.0; x += 0.5) // trilinear values of a linear field are exact
  {
    const auto sample = made.brick->sample(FieldBlockRole::Other, { x, 2.5, 3.25 });
    ASSERT_TRUE(sample) << x;
    EXPECT_NEAR(sample->value, 3.25 + 0.25 * x, 1e-5);
  }
  EXPECT_TRUE(made.brick->sample(FieldBlockRole::Scalar, { 7.0, 4, 4 }));
  EXPECT_FALSE(made.brick->sample(FieldBlockRole::Other, { 7.0, 4, 4 }))
    << "the other ends at 5.75, in the cell from 5 to 6";
  EXPECT_FALSE(made.brick->sample(FieldBlockRole::Other, { 0.1, 4, 4 })) << "and begins at 0.25";
}

TEST(ComparedField, IsSnappedToAtTheGivenPlacesNearestToTheHandAndARecordingKeepsThem)
{
  SnapPlaces places;
  for (int i = 0; i < 1000; ++i)
  {
    places.points_W.emplace_back(i, 0, 0);
    places.lines_W.push_back({ Vec3(0, i, -50), Vec3(0, i, 50) });
  }
  const auto field = std::make_shared<GridSource>(coarseGrid, [](const Vec3& p) { return p.z(); });
  const MadeFieldBlock made = snappingTo(field, places)->brickAround({ Vec3(500, 300, 3), 4.0, 7 });
  ASSERT_TRUE(made.brick);
  ASSERT_EQ(made.brick->places_W().size(), FieldBlock::mostPlaces);
  ASSERT_EQ(made.brick->lines_W().size(), FieldBlock::mostPlaces);
  // The first place that is left out is 128 from the hand along x, beside the hand's distance from that line. Another
  // block comes in time.
  EXPECT_NEAR(made.reach_u, 0.5 * std::sqrt(128.0 * 128.0 + 300.0 * 300.0 + 3.0 * 3.0), 1e-9);
  for (std::size_t i = 0; i < FieldBlock::mostPlaces; ++i)
  {
    EXPECT_LE(std::fabs(made.brick->places_W()[i].x() - 500.0), 128.0);
    EXPECT_LE(std::fabs(made.brick->lines_W()[i][0].y() - 300.0), 128.0);
  }
  ByteWriter out;
  putFieldBlock(out, *made.brick);
  ByteReader in(out.bytes().data(), out.bytes().size());
  const auto read = readFieldBlock(in);
  ASSERT_TRUE(read && in.ok());
  EXPECT_EQ(read->contentHash(), made.brick->contentHash());
  EXPECT_EQ(read->lines_W(), made.brick->lines_W());
  ByteReader cut(out.bytes().data(), out.bytes().size() - 1);
  static_cast<void>(readFieldBlock(cut));
  EXPECT_FALSE(cut.ok());
}

/// Has a finer grid in it.
class FinerSource : public GridSource
{
public:
  using GridSource::GridSource;
  [[nodiscard]] MadeFieldBlock brickAround(const FieldBlockWish& wish) const override
  {
    MadeFieldBlock made = GridSource::brickAround(wish);
    const auto value = [](const Vec3& index) { return finerGrid.toWorld(index).z(); };
    auto finer = std::make_shared<const FieldBlock>(wish.revision, finerGrid,
      std::vector<FieldBlockArray>{ { FieldBlockRole::Scalar, "f", test::sampledValues(finerGrid.size, value) } });
    made.brick = std::make_shared<const FieldBlock>(wish.revision, made.brick->grid(), made.brick->arrays(),
      std::vector<Vec3>(), std::vector<FieldBlockLine>(), std::move(finer));
    return made;
  }
};

TEST(ComparedField, OfAFinerBrickIsWhatItIsOfTheOther)
{
  const auto height = [](const Vec3& p) { return p.z(); };
  const auto one = std::make_shared<FinerSource>(coarseGrid, height);
  const auto other = std::make_shared<GridSource>(coarseGrid, [](const Vec3& p) { return p.z() + 0.25 * p.x(); });
  SnapPlaces places;
  places.points_W = { Vec3(1, 2, 3) };
  const MadeFieldBlock made = snappingTo(comparedWith(one, other), places)->brickAround({ Vec3(4, 4, 4), 4.0, 7 });
  ASSERT_TRUE(made.brick && made.brick->finer());
  const Vec3 p(3.25, 2.5, 3.25); // trilinear values of a linear field are exact
  EXPECT_EQ(&made.brick->finestAt(p), made.brick->finer().get());
  EXPECT_NEAR(made.brick->finestAt(p).sample(FieldBlockRole::Other, p)->value, 3.25 + 0.25 * 3.25, 1e-5);
  EXPECT_EQ(made.brick->finer()->places_W(), places.points_W);
  EXPECT_EQ(made.brick->places_W(), places.points_W);
}

TEST(FieldLevels, ThatTheDataDoNotHaveAreSaidAndAreAProblemWhereNothingElseIsFelt)
{
  const FieldEnds ends{ 10.0, 20.0 };
  FieldPlan plan;
  plan.isosurface = true;
  plan.isovalue = 20.0;
  EXPECT_EQ(levelText(plan, ends), "");
  plan.isovalue = 25.0;
  EXPECT_TRUE(test::says(levelProblem(plan, ends), { "from 10 to 20", "isovalue 25" }));
  plan.detent.strength_N = 0.5;
  plan.detent.origin = 3.0;
  plan.detent.spacing = 4.0; // 11, 15, 19
  EXPECT_NE(levelText(plan, ends), "");
  EXPECT_EQ(levelProblem(plan, ends), "") << "the levels are felt";
  plan.detent.spacing = 30.0; // 3, 33
  EXPECT_NE(levelProblem(plan, ends).find("and they contain no level"), std::string::npos);
  ASSERT_EQ(setLevels(plan.detent, "1, 12"), "");
  EXPECT_EQ(levelProblem(plan, ends), "");
  ASSERT_EQ(setLevels(plan.detent, "1, 32"), "");
  EXPECT_NE(levelProblem(plan, ends), "");
  plan.drag_N = 0.1;
  EXPECT_EQ(levelProblem(plan, ends), "");
  EXPECT_NE(levelText(plan, ends), "") << "said all the same";
  EXPECT_EQ(levelText(plan, { 1.0, 0.0 }), "") << "directions alone have no values";
}

} // namespace
} // namespace palpate
