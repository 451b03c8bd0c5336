// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "SoftPads.h"
#include "haptics/compliance/servo/SoftTick.h"
#include "haptics/geometry/scene/Scene.h"
#include "testing/oracles/axisymmetric/BallOnLayer.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

/// Places from 0 on, `edge` apart up to `even`, then further and further apart until `end`.
std::vector<double> gradedPlaces(double edge, double even, double end)
{
  std::vector<double> places{ 0.0 };
  for (double step = edge; places.back() < end - 1e-12;)
  {
    step = places.back() < even - 1e-12 ? edge : 1.4 * step;
    const double rest = end - places.back();
    places.push_back(rest < 1.5 * step ? end : places.back() + step);
  }
  return places;
}

/// A layer, held below and far wider than thick, whose edges are even around the middle of its top.
SoftBodyInput layerOf(const oracle::Layer& layer, double edge, double even)
{
  const double h = layer.thickness_m;
  const std::vector<double> aside = gradedPlaces(edge, even, std::max(2.5 * h, 2.5 * even) + 4.0 * edge);
  const std::vector<double> down = gradedPlaces(edge, std::min(even, h), h);
  const int half = static_cast<int>(aside.size()) - 1;
  const int deep = static_cast<int>(down.size()) - 1;
  SoftBodyInput input;
  input.mesh = blockOf({ 2 * half, 2 * half, deep }, Vec3(2 * half, 2 * half, deep));
  const auto placeOf = [&](double cell)
  {
    const int i = static_cast<int>(std::lround(cell)) - half;
    return (i < 0 ? -1.0 : 1.0) * aside[static_cast<std::size_t>(std::abs(i))];
  };
  for (Vec3& p : input.mesh.vertices_W)
  {
    p = Vec3(placeOf(p.x()), placeOf(p.y()), -down[static_cast<std::size_t>(deep - std::lround(p.z()))]);
  }
  input.fixed = fixedWhere(input.mesh, [h](const Vec3& p) { return p.z() <= -h + 1e-12; });
  input.young_Pa = { layer.young_Pa };
  input.poisson = layer.poisson;
  input.model = ElasticModel::Linear;
  return input;
}

/// Presses a ball into a body's top, by turns of a tick and a packet as at rate 0.
class Presser
{
public:
  Presser(const SoftBodyInput& input, double ball_m) : room_(std::make_unique<SoftRoom>())
  {
    SoftBodyResult made = makeSoftBody(input);
    EXPECT_TRUE(made.body) << made.refusal;
    this->body_ = std::move(made.body);
    this->surface_ = makeSoftSurface(*this->body_, made.checked.mesh);
    Surface surface;
    surface.tree = std::make_shared<const SurfaceTree>(TriangleMesh{ this->surface_.rest_W, this->surface_.triangles });
    this->scene_ = std::make_unique<Scene>(1, std::vector<Surface>{ surface });
    this->maker_ = std::make_unique<PacketMaker>(*this->body_, this->surface_);
    this->plan_.radius_u = ball_m;
    this->plan_.coupling_N_per_m = 1e4;
    this->plan_.friction = { 5.0, 5.0 };
    this->request_.radius_u = ball_m;
    this->request_.period_s = 0.001;
  }

  /// The force on a ball so deep below a place.
  double press(double depth_m, const Vec3& at_W = Vec3::Zero())
  {
    this->state_ = {};
    (void)this->tick(at_W + Vec3(0.0, 0.0, 1.5 * this->plan_.radius_u));
    Vec3 target_W = at_W + Vec3(0.0, 0.0, this->plan_.radius_u - depth_m);
    SoftResult found;
    for (int turn = 0; turn < 12; ++turn)
    {
      found = this->tick(target_W - found.force_N / this->plan_.coupling_N_per_m);
    }
    EXPECT_NEAR(found.proxy_W.z(), target_W.z(), 1e-4 * depth_m);
    this->pressed_ = found;
    return found.force_N.z();
  }

  /// How far a pressed ball goes along the surface under a force along it [m/N].
  double givesAlong(double aside_m)
  {
    const Vec3 device_W = this->pressed_.proxy_W - this->pressed_.force_N / this->plan_.coupling_N_per_m;
    const SoftResult found = this->tick(device_W + Vec3(aside_m, 0.0, 0.0));
    return (found.proxy_W.x() - this->pressed_.proxy_W.x()) / (this->pressed_.force_N.x() - found.force_N.x());
  }

private:
  SoftResult tick(const Vec3& device_W)
  {
    this->request_.ball_W = this->state_.core.placed ? this->state_.core.x_W : device_W;
    this->request_.forceAt.clear();
    this->request_.force_N.clear();
    for (int c = 0; c < this->state_.count; ++c)
    {
      this->request_.forceAt.push_back(this->state_.contacts[c].point.at);
      this->request_.force_N.push_back(-this->state_.contacts[c].force_N);
    }
    const auto before = std::exchange(this->packet_, this->maker_->make(this->request_, 1));
    this->touch_ = { 0, this->packet_.get() };
    changePackets(std::span(&this->touch_, 1), this->state_);
    this->state_.offset_W.setZero(); // as when what a change would have done has faded
    return moveOnSoft(*this->scene_, this->plan_, std::span(&this->touch_, 1), device_W, this->state_, *this->room_);
  }

  std::unique_ptr<SoftBody> body_;
  SoftSurface surface_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<PacketMaker> maker_;
  std::unique_ptr<SoftRoom> room_;
  PacketRequest request_;
  ContactPlan plan_;
  std::shared_ptr<const CompliancePacket> packet_;
  SoftTouch touch_;
  SoftState state_;
  SoftResult pressed_;
};

/// A ball pressed so deep into a layer, on edges finer and finer.
struct Study
{
  double ball_m;
  double depth_m;
  double thickness_m;
  std::vector<double> edges_m;
};

/// Each within 3 % of the truth, and no finer mesh further from it than a coarser one but for 1 %.
void expectTruth(const Study& study)
{
  const oracle::Layer layer{ 20e3, 0.4, study.thickness_m };
  const oracle::BallContact truth = oracle::contactOfDepth(layer, study.ball_m, study.depth_m);
  double leastOff = 0.03;
  for (const double edge : study.edges_m)
  {
    Presser presser(layerOf(layer, edge, 1.2 * truth.radius_m + edge), study.ball_m);
    const double off = std::abs(presser.press(study.depth_m) / truth.force_N - 1.0);
    EXPECT_LE(off, std::max(leastOff, 0.01)) << "ball " << study.ball_m << ", layer " << study.thickness_m << ", edge "
                                             << edge << ", of " << truth.force_N << " N";
    leastOff = std::min(leastOff, off);
    const double between = presser.press(study.depth_m, Vec3(0.37 * edge, 0.21 * edge, 0.0)) / truth.force_N;
    EXPECT_NEAR(between, 1.0, 0.03) << "between vertices, edge " << edge;
  }
}

/// The finest ones take a minute each: where more cases than usual are asked for.
std::vector<double> edges(std::vector<double> usual, const std::vector<double>& fine)
{
  if (testCount(1) > 1)
  {
    usual.insert(usual.end(), fine.begin(), fine.end());
  }
  return usual;
}

TEST(MeshStudy, AWideContactIsTheTrueOneOnEveryMesh)
{
  expectTruth({ 0.02, 0.003, 0.05, edges({ 0.017, 0.00625, 0.0029 }, { 0.0021, 0.0012 }) });
  expectTruth({ 0.05, 0.003, 0.05, edges({ 0.017 }, { 0.0125, 0.00625, 0.004 }) });
}

TEST(MeshStudy, AContactOfMillimetresIsTheTrueOneOnEveryMesh)
{
  expectTruth({ 0.01, 0.001, 0.05, edges({ 0.0125, 0.004 }, { 0.0021, 0.0012, 0.0008 }) });
  expectTruth({ 0.002, 0.0003, 0.05, edges({ 0.017 }, { 0.0029, 0.0012, 0.0008 }) });
}

TEST(MeshStudy, FromTwoElementsThroughItOnALayerIsAsStiffAsItIs)
{
  expectTruth({ 0.01, 0.001, 0.005, edges({ 0.0025, 0.00125 }, { 0.001, 0.0008 }) });
  expectTruth({ 0.01, 0.0002, 0.002, edges({ 0.001, 0.0005 }, { 0.0004 }) });
  expectTruth({ 0.002, 0.0002, 0.002, edges({ 0.001 }, { 0.0005, 0.0004 }) });
  expectTruth({ 0.05, 0.0001, 0.002, edges({ 0.001 }, { 0.0008 }) }); // contacts of many thicknesses
}

TEST(MeshStudy, AlongTheSurfaceAContactGivesWayAsMindlinSays)
{
  // On a half space: 1 / (8 G* a), G* = G / (2 - nu). The base is 60 contacts deep.
  const oracle::Layer layer;
  const double shear = layer.young_Pa / (2.0 * (1.0 + layer.poisson));
  for (const double edge : { 0.017, 0.00625 })
  {
    Presser presser(layerOf(layer, edge, edge), 0.002);
    const double depth_m = 0.0003;
    presser.press(depth_m);
    const double contact_m = oracle::contactOfDepth(layer, 0.002, depth_m).radius_m;
    const double truth = (2.0 - layer.poisson) / (8.0 * shear * contact_m);
    EXPECT_NEAR(presser.givesAlong(1e-6) / truth, 1.0, 0.03) << "edge " << edge;
  }
}

TEST(BallOnLayer, IsSneddonsBallFarFromTheBase)
{
  const oracle::Layer deep{ 20e3, 0.4, 50.0 };
  for (const double contact_m : { 1e-4, 2e-3, 7e-3 })
  {
    const oracle::BallContact found = oracle::contactOfRadius(deep, 0.01, contact_m);
    const oracle::BallContact truth = oracle::onHalfSpace(20e3, 0.4, 0.01, contact_m);
    EXPECT_NEAR(found.depth_m / truth.depth_m, 1.0, 1e-3);
    EXPECT_NEAR(found.force_N / truth.force_N, 1.0, 1e-3);
  }
}

TEST(BallOnLayer, IsABedOfSpringsWhereTheContactIsFarWiderThanTheLayerIsThick)
{
  // Springs of (lambda + 2 mu) / thickness: the force is pi M r depth^2 / thickness.
  const double nu = 0.3;
  const oracle::Layer thin{ 20e3, nu, 1e-3 };
  const oracle::BallContact found = oracle::contactOfRadius(thin, 10.0, 0.005);
  const double modulus = 20e3 * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const double springs_N = 3.141592653589793 * modulus * 10.0 * found.depth_m * found.depth_m / 1e-3;
  EXPECT_NEAR(found.force_N / springs_N, 1.0, 0.01);
}

TEST(BallOnLayer, HasTheFactorOfTheLayerThatIsPublished)
{
  // Dimitriadis et al. 2002, eq. 12, of a bonded layer, chi = sqrt(r depth) / h; for shallow balls.
  const double nu = 0.4;
  const double pi = 3.141592653589793;
  const double a0 = -(1.2876 - 1.4678 * nu + 1.3442 * nu * nu) / (1.0 - nu);
  const double b0 = (0.6387 - 1.0277 * nu + 1.5164 * nu * nu) / (1.0 - nu);
  for (const double chi : { 0.05, 0.1, 0.2 })
  {
    const double ball_m = 1.0;
    const double depth_m = 1e-3;
    const oracle::Layer layer{ 20e3, nu, std::sqrt(ball_m * depth_m) / chi };
    const double hertz_N = 4.0 / 3.0 * 20e3 / (1.0 - nu * nu) * std::sqrt(ball_m) * std::pow(depth_m, 1.5);
    const double factor = 1.0 - 2.0 * a0 / pi * chi + 4.0 * a0 * a0 / (pi * pi) * chi * chi -
                          8.0 / (pi * pi * pi) * (a0 * a0 * a0 + 4.0 * pi * pi / 15.0 * b0) * chi * chi * chi +
                          16.0 * a0 / std::pow(pi, 4) * (a0 * a0 * a0 + 3.0 * pi * pi / 5.0 * b0) * std::pow(chi, 4);
    EXPECT_NEAR(oracle::contactOfDepth(layer, ball_m, depth_m).force_N / (factor * hertz_N), 1.0, 0.01) << chi;
  }
}

} // namespace
} // namespace palpate::test
