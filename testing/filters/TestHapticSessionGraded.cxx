// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of graded meshes under a hand in virtual time. The judges are the profile's formula and VTK's probe.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "FieldSession.h"
#include "GradedMeshes.h"
#include "testing/support/LongForm.h"
#include "testing/support/Says.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
constexpr double graded_u_per_m = 40.0; ///< 25 mm of the hand are a unit

class HapticSessionGraded : public FieldSession
{
protected:
  /// A surface of u, felt from a free place on.
  void feel(vtkDataObject* data, double value, const Vec3& from)
  {
    this->session_->SetSetting("FieldArray", "u");
    this->session_->SetSetting("FieldIsosurface", true);
    this->session_->SetSetting("FieldIsovalue", value);
    ASSERT_TRUE(this->session_->AddField("graded", data)) << this->session_->GetProblem();
    ASSERT_TRUE(this->session_->FinishField());
    this->start(from);
    this->session_->SetSetting("Scale", graded_u_per_m);
    this->session_->Step(10);
  }
  /// Where the proxy is after a tick with the hand there.
  Vec3 proxyWith(const Vec3& hand)
  {
    this->at(hand);
    this->session_->Step(1);
    this->session_->FinishField();
    return Vec3(this->session_->GetProxyPosition());
  }
};

TEST_F(HapticSessionGraded, OfAChannelHoldsAHandAtThirtyCentimetresASecondThroughItsWallAndAlongIt)
{
  const auto data = channel(25, 13);
  for (const double u : { 0.5, 0.9, 0.99 })
  {
    this->feel(data, u, { 1.1, 0.2, 1.4 });
    const double surface = -layer_u * std::log(1.0 - u), cell = cellAt(channelLayers(), surface);
    const auto expectHeld = [&](const Vec3& hand) {
      ASSERT_NEAR(this->proxyWith(hand).y(), std::max(surface, hand.y()), 0.25 * cell) << u << ", " << hand.transpose();
    };
    for (double at = 0.2; at > -0.2; at -= handStep_u)
    {
      expectHeld({ 1.1, at, 1.4 });
    }
    for (double way = 0.0; way < 0.8; way += handStep_u)
    {
      expectHeld({ 1.1 + way, -0.2, 1.4 });
    }
    EXPECT_EQ(this->session_->GetContacts(), 1);
    EXPECT_NEAR(Vec3(this->session_->GetProxyPosition()).x(), 1.9, 2.0 * handStep_u);
    EXPECT_GT(this->force().y(), 0.0);
    EXPECT_THAT(this->session_->GetFieldText(), HasSubstr("cells of the data"));
    this->session_->TouchingOff();
  }
}

TEST_F(HapticSessionGraded, OfAnOGridHoldsAHandWithinAQuarterOfTheLocalCellOverItsSeam)
{
  const auto data = oGrid();
  const auto at = [](double turn) { return Vec3(std::cos(turn), 0.8 * std::sin(turn), 0.6 * std::sin(turn)); };
  // OwnCells feels the other two along a path.
  for (const double u : test::casesOf<double>({ 0.5, 0.9, 0.99 }, { 0.9 }))
  {
    this->feel(data, u, 1.15 * at(-0.5));
    for (double r = 1.15; r > 0.95; r -= handStep_u)
    {
      this->proxyWith(r * at(-0.5));
    }
    std::vector<Vec3> felt_W;
    for (double turn = -0.5; turn < 0.7; turn += handStep_u)
    {
      felt_W.push_back(this->proxyWith(0.95 * at(turn)));
    }
    const std::vector<double> surface = radiiOf(u, felt_W, data);
    for (std::size_t i = 0; i < felt_W.size(); ++i)
    {
      ASSERT_NEAR(felt_W[i].norm(), surface[i], 0.25 * cellAt(oGridLayers(), surface[i] - 1.0)) << u << ", row " << i;
    }
    this->session_->TouchingOff();
  }
}

TEST_F(HapticSessionGraded, ThatAreNotFeltInTheirCellsAreSaidWithTheSpacingOfWhatIsFelt)
{
  this->session_->SetSetting("FieldSmoothing", 1);
  this->feel(channel(25, 13), 0.9, { 1.1, 0.2, 1.4 });
  EXPECT_TRUE(test::says(this->session_->GetFieldText(), { "isosurfaces", "samples 0." }));
  EXPECT_TRUE(test::says(this->session_->GetFieldText(), { "not from its own cells", "smoothed" }));
}
} // namespace
