// SPDX-License-Identifier: GPL-3.0-or-later
#include <condition_variable>
#include <limits>
#include <mutex>

#include <gtest/gtest.h>

#include "haptics/session/scene/FeltField.h"

namespace palpate
{
namespace
{

/// A block of 2 x 2 x 2 points wherever it is asked for; a place left of 0 has none. May block until it is released.
class FakeSource : public FieldSource
{
public:
  [[nodiscard]] MadeFieldBlock brickAround(const FieldBlockWish& wish) const override
  {
    const Vec3& centre_W = wish.centre_W;
    const double reach_u = wish.reach_u;
    std::unique_lock lock(this->mutex_);
    this->free_.wait(lock, [this] { return !this->held_; });
    ++this->asked;
    if (centre_W.x() < 0.0)
    {
      return { nullptr, centre_W, reach_u, "" };
    }
    const FieldBlockGrid grid{ { 2, 2, 2 }, Vec3::Constant(2 * reach_u),
      { centre_W - Vec3::Constant(reach_u), Quat::Identity() } };
    return { std::make_shared<const FieldBlock>(wish.revision, grid,
               std::vector<FieldBlockArray>{ { FieldBlockRole::Scalar, "f", std::vector<float>(8, 1.0F) } }),
      centre_W, reach_u, "" };
  }
  void hold(bool on)
  {
    const std::lock_guard lock(this->mutex_);
    this->held_ = on;
    this->free_.notify_all();
  }

  mutable int asked = 0;

private:
  mutable std::mutex mutex_;
  mutable std::condition_variable free_;
  bool held_ = false;
};

constexpr double reach_u = 10.0;

TEST(FeltField, MakesAnotherBrickOnceTheHandHasUsedHalfOfItsRoomAndNotBefore)
{
  const auto source = std::make_shared<FakeSource>();
  FeltField field;
  field.setSource(source);
  const auto first = field.follow(Vec3(100, 0, 0), reach_u, {}, true);
  ASSERT_TRUE(first && *first);
  EXPECT_FALSE(field.follow(Vec3(104.9, 4.9, -4.9), reach_u, {}, true));
  EXPECT_EQ(source->asked, 1);
  const auto second = field.follow(Vec3(100, 5.1, 0), reach_u, {}, true);
  ASSERT_TRUE(second && *second);
  EXPECT_EQ((*second)->grid().toWorld(Vec3::Constant(0.5)), Vec3(100, 5.1, 0));
}

TEST(FeltField, KeepsTheOldBrickWhileTheNextIsMade)
{
  const auto source = std::make_shared<FakeSource>();
  FeltField field;
  field.setSource(source);
  ASSERT_TRUE(field.follow(Vec3(0, 0, 0), reach_u, {}, true));
  source->hold(true);
  EXPECT_FALSE(field.follow(Vec3(6, 0, 0), reach_u, {}));  // asks
  EXPECT_FALSE(field.follow(Vec3(60, 0, 0), reach_u, {})); // one at a time
  source->hold(false);
  const auto next = field.follow(Vec3(60, 0, 0), reach_u, {}, true);
  ASSERT_TRUE(next && *next);
  EXPECT_EQ(source->asked, 3); // that of 6, which came too late, and that of 60
  EXPECT_EQ(field.made().centre_W, Vec3(60, 0, 0));
}

TEST(FeltField, WhereNothingIsToBeFeltThereIsNoBrickAndNoneIsAskedForAgainAndAgain)
{
  const auto source = std::make_shared<FakeSource>();
  FeltField field;
  field.setSource(source);
  const auto none = field.follow(Vec3(-50, 0, 0), reach_u, {}, true);
  ASSERT_TRUE(none);
  EXPECT_EQ(*none, nullptr);
  EXPECT_FALSE(field.follow(Vec3(-51, 0, 0), reach_u, {}, true));
  EXPECT_EQ(source->asked, 1);
  EXPECT_TRUE(field.follow(Vec3(1, 0, 0), reach_u, {}, true).value());
}

TEST(FeltField, ABrickOfASourceThatWasLeftIsThrownAway)
{
  const auto old = std::make_shared<FakeSource>(), next = std::make_shared<FakeSource>();
  FeltField field;
  field.setSource(old);
  old->hold(true);
  EXPECT_FALSE(field.follow(Vec3::Zero(), reach_u, {}));
  field.setSource(next);
  old->hold(false);
  const auto brick = field.follow(Vec3(1, 2, 3), reach_u, {}, true);
  ASSERT_TRUE(brick && *brick);
  EXPECT_EQ(next->asked, 1);
  EXPECT_EQ(field.made().centre_W, Vec3(1, 2, 3));
  field.setSource(nullptr);
  const auto none = field.follow(Vec3::Zero(), reach_u, {});
  ASSERT_TRUE(none);
  EXPECT_EQ(*none, nullptr);
  EXPECT_FALSE(field.follow(Vec3::Zero(), reach_u, {}));
}

/// Measures noise beside the level that it is asked for, and says that it holds for one on.
class NoisySource : public FakeSource
{
public:
  [[nodiscard]] MadeFieldBlock brickAround(const FieldBlockWish& wish) const override
  {
    MadeFieldBlock made = this->FakeSource::brickAround(wish);
    made.smoothness = { 0, 0.0, wish.level, 1.0 };
    return made;
  }
};

FieldPlan surfaceAt(double value)
{
  FieldPlan plan;
  plan.isosurface = true;
  plan.isovalue = value;
  return plan;
}

TEST(FeltField, LooksAtTheNoiseAgainOnceTheValueOfTheSurfaceHasGoneFar)
{
  const auto source = std::make_shared<NoisySource>();
  FeltField field;
  field.setSource(source);
  ASSERT_TRUE(field.follow(Vec3::Zero(), reach_u, {}, true));
  EXPECT_FALSE(field.follow(Vec3::Zero(), reach_u, {}, true)) << "no surface is felt";
  EXPECT_TRUE(field.follow(Vec3::Zero(), reach_u, surfaceAt(5.0), true)) << "one is felt now";
  EXPECT_FALSE(field.follow(Vec3::Zero(), reach_u, surfaceAt(5.9), true));
  EXPECT_TRUE(field.follow(Vec3::Zero(), reach_u, surfaceAt(6.1), true));
  EXPECT_EQ(source->asked, 3);
}

TEST(FeltField, AHandThatIsNowhereAsksForNothing)
{
  const auto source = std::make_shared<FakeSource>();
  FeltField field;
  field.setSource(source);
  EXPECT_FALSE(field.follow(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), reach_u, {}, true));
  EXPECT_EQ(source->asked, 0);
}

} // namespace
} // namespace palpate
