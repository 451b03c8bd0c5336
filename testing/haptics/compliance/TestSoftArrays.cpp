// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement, strain and stress of a soft body as data: against exact solutions and an independent quadratic solver.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include <gtest/gtest.h>

#include "Blocks.h"
#include "haptics/compliance/element/Materials.h"
#include "haptics/compliance/snapshot/SoftSurface.h"
#include "testing/oracles/quadratic/QuadraticSolid.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

using Where = std::function<bool(const Vec3&)>;

/// Moves vertices within the block, but on no plane of a constant z in `kept`, by up to a fifth of a cell.
void jiggle(TetraMesh& mesh, const Vec3& size, double cell, const std::vector<double>& kept = {})
{
  Random random(testSeed(281));
  for (Vec3& p : mesh.vertices_W)
  {
    const bool inside = (p.array() > 1e-9).all() && (p.array() < size.array() - 1e-9).all();
    const bool stays = std::ranges::any_of(kept, [&p](double z) { return std::abs(p.z() - z) < 1e-9; });
    p += inside && !stays ? Vec3(0.2 * cell * random.direction()) : Vec3(Vec3::Zero());
  }
}

/// A traction on a side, as forces on its corners: a third of each triangle's on each.
std::vector<Vec3> tractionOn(const TetraMesh& mesh, const Where& where, const Vec3& traction)
{
  std::vector<Vec3> load_N(mesh.vertices_W.size(), Vec3::Zero());
  for (const auto& t : borderOf(mesh))
  {
    const auto at = [&mesh, &t](int i) -> const Vec3& { return mesh.vertices_W[t[i]]; };
    if (where(at(0)) && where(at(1)) && where(at(2)))
    {
      const double area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
      for (const std::uint32_t v : t)
      {
        load_N[v] += area / 3.0 * traction;
      }
    }
  }
  return load_N;
}

std::vector<Mat3> deformationOf(const SoftBody& body)
{
  const Eigen::VectorXd& u = body.displacement();
  std::vector<Mat3> ofPoints;
  for (const StrainPoint& p : body.points().points)
  {
    ofPoints.push_back(body.points().deformationAt(p, { u.data(), static_cast<std::size_t>(u.size()) }));
  }
  return body.points().deformationOfTetras(ofPoints);
}

std::vector<Mat3> stressOf(const SoftBody& body, const SoftBodyInput& input)
{
  std::vector<Mat3> stress;
  for (const Mat3& f : deformationOf(body))
  {
    const double young_Pa = input.young_Pa[input.young_Pa.size() == 1 ? 0 : stress.size()];
    stress.push_back(palpate::stressOf(input.model, moduliOf(young_Pa, input.poisson, 1.0).value, f));
  }
  return stress;
}

Vec3 middleOf(const TetraMesh& mesh, const Tetra& t)
{
  return 0.25 * (mesh.vertices_W[t[0]] + mesh.vertices_W[t[1]] + mesh.vertices_W[t[2]] + mesh.vertices_W[t[3]]);
}

/// At rest under its loads.
SoftBodyResult loaded(const SoftBodyInput& input)
{
  SoftBodyResult made = makeSoftBody(input);
  EXPECT_TRUE(made.body) << made.refusal;
  return made;
}

TEST(SoftArrays, InPureTensionEveryNodeEveryPlaceOfTheSurfaceAndEveryStressIsExact)
{
  for (const ElementKind element : { ElementKind::EdgeSmoothed, ElementKind::Quadratic })
  {
    for (const int n : { 3, 5 })
    {
      SoftBodyInput input;
      const Vec3 size(0.06, 0.05, 0.06);
      input.mesh = blockOf({ n, n - 1, n }, size);
      jiggle(input.mesh, size, 0.06 / n);
      input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.z() == 0.0; });
      input.young_Pa = { 20e3 };
      input.poisson = 0.0; // nothing narrows: the strain is one all over though an end is fixed
      input.model = ElasticModel::Linear;
      input.element = element;
      const auto onTop = [&size](const Vec3& p) { return p.z() > size.z() - 1e-9; };
      input.load_N = tractionOn(input.mesh, onTop, Vec3(0, 0, 0.1 * 20e3));
      const SoftBodyResult made = loaded(input);
      const std::vector<Vec3>& rest_W = made.body->points().rest_W;
      const double within_u = 1e-12 * 0.1 * size.z();
      for (std::size_t v = 0; v < rest_W.size(); ++v)
      {
        const Vec3 gone_u = made.body->displacement().segment<3>(3 * static_cast<Eigen::Index>(v));
        EXPECT_LE((gone_u - 0.1 * rest_W[v].z() * Vec3::UnitZ()).norm(), within_u);
      }
      const SoftSurface surface = makeSoftSurface(*made.body, made.checked.mesh);
      const std::vector<Vec3> places_W = surface.placesOf(*made.body);
      for (std::size_t i = 0; i < places_W.size(); ++i)
      {
        EXPECT_LE((places_W[i] - surface.rest_W[i].cwiseProduct(Vec3(1, 1, 1.1))).norm(), within_u + 1e-16);
      }
      for (const Mat3& stress : stressOf(*made.body, input))
      {
        EXPECT_LE((stress - Mat3(Vec3(0, 0, 2e3).asDiagonal())).norm(), 1e-12 * 20e3);
      }
    }
  }
}

/// Of the stress along a cantilever in tetrahedra a side's length off its ends, and of those that should be 0 there.
struct BendingError
{
  double rms = 0.0;  ///< of that along it, over its own
  double side = 0.0; ///< largest one across it over the largest one along it
};

/// Of the usual element or another one. .1 x .02 x .02 m, a force across the free end: Saint-Venant's stress along it
/// is (L - x) (h / 2 - z) F / I.
BendingError bendingError(int across, double poisson, bool jiggled, std::optional<ElementKind> element = {})
{
  const Vec3 size(0.1, 0.02, 0.02);
  SoftBodyInput input;
  input.mesh = blockOf({ 5 * across, across, across }, size);
  if (jiggled)
  {
    jiggle(input.mesh, size, 0.02 / across);
  }
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
  input.young_Pa = { 1e6 };
  input.poisson = poisson;
  input.model = ElasticModel::Linear;
  input.element = element.value_or(usualElement(input.mesh, input.young_Pa, poisson, input.model));
  const double h = size.z(), force_N = 0.01;
  const auto atEnd = [&size](const Vec3& p) { return p.x() > size.x() - 1e-9; };
  input.load_N = tractionOn(input.mesh, atEnd, Vec3(0, 0, force_N / (h * h)));
  const SoftBodyResult made = loaded(input);
  const std::vector<Mat3> stress = stressOf(*made.body, input);
  double error = 0.0, exact = 0.0, side = 0.0, most = 0.0;
  for (std::size_t i = 0; i < stress.size(); ++i)
  {
    const Vec3 at = middleOf(made.checked.mesh, made.checked.mesh.tetras[i]);
    if (at.x() < h || at.x() > size.x() - h)
    {
      continue;
    }
    const double along = (size.x() - at.x()) * (0.5 * h - at.z()) * force_N / (std::pow(h, 4) / 12.0);
    error += std::pow(stress[i](0, 0) - along, 2);
    exact += along * along;
    most = std::max(most, std::abs(along));
    side = std::max({ side, std::abs(stress[i](1, 1)), std::abs(stress[i](2, 2)) });
  }
  return { std::sqrt(error / exact), side / most };
}

TEST(SoftArrays, TheStressOfACantileverWithSmoothedEdgesConvergesAndIsWithinFivePercent)
{
  constexpr auto smoothed = ElementKind::EdgeSmoothed;
  for (const double poisson : { 0.3, 0.4 })
  {
    const BendingError coarse = bendingError(2, poisson, false, smoothed);
    const BendingError fine = bendingError(4, poisson, false, smoothed);
    EXPECT_LE(fine.rms, 0.05) << poisson;
    EXPECT_LE(fine.rms, 0.5 * coarse.rms) << poisson;
    EXPECT_LE(fine.side, 0.1) << poisson;
  }
  EXPECT_LE(bendingError(4, 0.3, true, smoothed).rms, 0.05) << "of tetrahedra none of which is like another";
}

TEST(SoftArrays, TheStressOfACantileverOfALinearModelIsWithinTwoPercent)
{
  for (const double poisson : { 0.0, 0.3, 0.4 })
  {
    for (const bool jiggled : { false, true })
    {
      const BendingError error = bendingError(4, poisson, jiggled);
      EXPECT_LE(error.rms, 0.02) << poisson << (jiggled ? ", jiggled" : "");
      EXPECT_LE(error.side, 0.05) << poisson << (jiggled ? ", jiggled" : "");
    }
  }
}

TEST(SoftArrays, TheStressOfWhatNearlyKeepsItsVolumeIsWithinTenPercent)
{
  for (const double poisson : { 0.45, 0.49 })
  {
    for (const int across : { 2, 4 })
    {
      const BendingError error = bendingError(across, poisson, true);
      EXPECT_LE(error.rms, 0.1) << poisson << ", " << across << " across";
      EXPECT_LE(error.side, 0.1) << poisson << ", " << across << " across";
    }
  }
}

/// Two layers of one height, the upper one `ratio` times as stiff, on a floor.
SoftBodyInput layers(int across, double ratio)
{
  const Vec3 size(0.04, 0.04, 0.04);
  SoftBodyInput input;
  input.mesh = blockOf({ across, across, 2 * across }, size);
  jiggle(input.mesh, size, 0.02 / across, { 0.5 * size.z() });
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.z() == 0.0; });
  input.young_Pa.clear();
  for (const Tetra& t : input.mesh.tetras)
  {
    input.young_Pa.push_back(middleOf(input.mesh, t).z() < 0.5 * size.z() ? 1e4 : 1e4 * ratio);
  }
  input.model = ElasticModel::Linear;
  return input;
}

TEST(SoftArrays, TwoLayersBearOneStressAndGiveWayAsTwoSpringsInSeries)
{
  for (const double ratio : { 10.0, 100.0 })
  {
    for (const int across : { 2, 3 })
    {
      SoftBodyInput input = layers(across, ratio);
      input.poisson = 0.0;
      input.load_N = tractionOn(
        input.mesh, [](const Vec3& p) { return p.z() > 0.04 - 1e-9; }, Vec3(0, 0, -200.0));
      const SoftBodyResult made = loaded(input);
      const double top_u = -200.0 * 0.02 * (1.0 + 1.0 / ratio) / 1e4;
      for (std::size_t v = 0; v < made.checked.mesh.vertices_W.size(); ++v)
      {
        const double gone_u = made.body->displacement()[3 * static_cast<Eigen::Index>(v) + 2];
        const bool atTop = made.checked.mesh.vertices_W[v].z() > 0.04 - 1e-9;
        EXPECT_LE(atTop ? std::abs(gone_u - top_u) : 0.0, 1e-12 * std::abs(top_u));
      }
      for (const Mat3& stress : stressOf(*made.body, input))
      {
        EXPECT_LE((stress - Mat3(Vec3(0, 0, -200.0).asDiagonal())).norm(), 1e-9 * 200.0);
      }
    }
  }
}

TEST(SoftArrays, OfTwoConfinedLayersNoNodeFeelsAForceUnderTheirExactStrains)
{
  // Sides that may not bulge: strain along z alone, stress (lambda + 2 mu) times it, the same in both layers.
  SoftBodyInput input = layers(3, 10.0);
  input.poisson = 0.3;
  const SoftBodyResult made = loaded(input);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(made.body->displacement().size());
  for (std::size_t v = 0; v < made.body->points().rest_W.size(); ++v)
  {
    const double z = made.body->points().rest_W[v].z();
    u[3 * static_cast<Eigen::Index>(v) + 2] = -0.01 * std::min(z, 0.02) - 0.001 * std::max(z - 0.02, 0.0);
  }
  made.body->place(u);
  const ElasticModuli soft = moduliOf(1e4, 0.3, 1.0).value;
  const double along = -0.01 * (soft.lambda + 2.0 * soft.mu);
  for (const Mat3& stress : stressOf(*made.body, input))
  {
    EXPECT_NEAR(stress(2, 2), along, 1e-11 * std::abs(along));
  }
  const Eigen::VectorXd forces = made.body->innerForces();
  for (std::size_t v = 0; v < made.body->points().rest_W.size(); ++v)
  {
    const Vec3& p = made.body->points().rest_W[v];
    const bool within = (p.array() > 1e-9).all() && (p.array() < 0.04 - 1e-9).all();
    // Between the layers stress across differs: forces there balance along z, and sideways within each layer.
    EXPECT_LE(within ? forces.segment<3>(3 * static_cast<Eigen::Index>(v)).norm() : 0.0, 1e-12 * 1e-4 * 1e4);
  }
}

/// A cantilever of .1 x .02 x .02 m of the modulus that `young_Pa` says, its free end pulled across.
struct Cantilever
{
  SoftBodyInput input;
  oracle::QuadraticSolid solid; ///< of the same cells, solved
};

Cantilever cantilever(int across, const std::function<double(const Vec3&)>& young_Pa)
{
  const Vec3 size(0.1, 0.02, 0.02);
  SoftBodyInput input;
  input.mesh = blockOf({ 5 * across, across, across }, size);
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
  input.young_Pa.clear();
  std::vector<std::array<int, 4>> tetrahedra;
  std::vector<oracle::QuadraticSolid::Hooke> materials;
  for (const Tetra& t : input.mesh.tetras)
  {
    input.young_Pa.push_back(young_Pa(middleOf(input.mesh, t)));
    tetrahedra.push_back(
      { static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2]), static_cast<int>(t[3]) });
    materials.push_back({ input.young_Pa.back(), 0.3 });
  }
  input.poisson = 0.3;
  input.model = ElasticModel::Linear;
  const auto atEnd = [&size](const Vec3& p) { return p.x() > size.x() - 1e-9; };
  const Vec3 traction(0, 0, 25.0);
  input.load_N = tractionOn(input.mesh, atEnd, traction);
  oracle::QuadraticSolid solid(input.mesh.vertices_W, tetrahedra, materials);
  solid.fix([](const Vec3& p) { return p.x() < 1e-12; });
  solid.pull(atEnd, traction);
  solid.solve();
  return { input, solid };
}

/// Work of the load on the product's body.
double workOn(const SoftBody& body, const SoftBodyInput& input)
{
  double work = 0.0;
  for (std::size_t v = 0; v < input.load_N.size(); ++v)
  {
    work += input.load_N[v].dot(body.displacement().segment<3>(3 * static_cast<Eigen::Index>(v)));
  }
  return work;
}

/// Smoothed edges: tip over the oracle's of the same cells, and the error of the stress along it against the oracle's.
std::array<double, 2> beside(int across, const std::function<double(const Vec3&)>& young_Pa)
{
  const auto [input, solid] = cantilever(across, young_Pa);
  const SoftBodyResult made = loaded(input);
  double error = 0.0, exact = 0.0;
  const std::vector<Mat3> stress = stressOf(*made.body, input);
  for (std::size_t i = 0; i < stress.size(); ++i)
  {
    const double x = middleOf(input.mesh, input.mesh.tetras[i]).x();
    const double along = solid.stressIn(static_cast<int>(i))(0, 0);
    const bool away = x > 0.02 && x < 0.08;
    error += away ? std::pow(stress[i](0, 0) - along, 2) : 0.0;
    exact += away ? along * along : 0.0;
  }
  return { workOn(*made.body, input) / solid.workOfLoad(), std::sqrt(error / exact) };
}

double inTwoLayers(const Vec3& p)
{
  return p.z() < 0.01 ? 1e6 : 1e7;
}

TEST(SoftArrays, AGradedModulusBendsAsAQuadraticSolidOfTheSameCellsDoesAndSoDoTwoMaterials)
{
  // Cells that each smooth nothing over their faces give .80 and .33 here (linear tetrahedra).
  const auto [graded, ofGraded] = beside(4, [](const Vec3& p) { return 1e6 * std::pow(10.0, p.z() / 0.02); });
  EXPECT_GE(graded, 0.95);
  EXPECT_LE(ofGraded, 0.1);
  const auto [coarse, ofCoarse] = beside(2, inTwoLayers);
  const auto [fine, ofFine] = beside(4, inTwoLayers);
  const auto [finest, ofFinest] = beside(6, inTwoLayers);
  EXPECT_LE(finest, 1.0);
  EXPECT_GE(finest, 0.99); // with three cells through each layer
  EXPECT_LE(1.0 - fine, 0.5 * (1.0 - coarse));
  EXPECT_LE(1.0 - finest, 0.5 * (1.0 - fine));
  EXPECT_LE(ofFine, 0.5 * ofCoarse);
  EXPECT_LE(ofFinest, 0.67 * ofFine); // by 4 / 6 at least
}

TEST(SoftArrays, TwoLayersOfOneOrTwoCellsEachBendAsAQuadraticSolidOfThreeCellsEachDoes)
{
  const double truth = cantilever(6, inTwoLayers).solid.workOfLoad();
  for (const int across : { 2, 4 })
  {
    auto [input, solid] = cantilever(across, inTwoLayers);
    input.element = usualElement(input.mesh, input.young_Pa, input.poisson, ElasticModel::NeoHookean);
    EXPECT_EQ(input.element, ElementKind::Quadratic) << across;
    const double usual = workOn(*loaded(input).body, input);
    // The rest is that of ten-node tetrahedra of these cells; smoothed edges give .77 with one cell, .98 with two.
    EXPECT_NEAR(usual / solid.workOfLoad(), 1.0, 1e-3) << across;
    EXPECT_NEAR(usual / truth, 1.0, across == 2 ? 0.011 : 0.01) << across;
  }
}

TEST(SoftArrays, OfLayersOneOrTwoCellsThickTheEdgesAreHalvedAndOfOtherBodiesNot)
{
  const TetraMesh mesh = blockOf({ 4, 4, 8 }, { 4, 4, 8 });
  const auto kindOf = [&mesh](double poisson, const std::function<double(const Vec3&)>& young_Pa)
  {
    std::vector<double> young;
    std::ranges::transform(
      mesh.tetras, std::back_inserter(young), [&](const Tetra& t) { return young_Pa(middleOf(mesh, t)); });
    return usualElement(mesh, young, poisson, ElasticModel::NeoHookean);
  };
  const auto layer = [](double from, double to)
  { return [from, to](const Vec3& p) { return p.z() > from && p.z() < to ? 1e5 : 1e4; }; };
  for (const auto& [from, to] : { std::array{ 0.0, 1.0 }, std::array{ 3.0, 4.0 }, std::array{ 6.0, 8.0 } })
  {
    EXPECT_EQ(kindOf(0.3, layer(from, to)), ElementKind::Quadratic) << from;
  }
  EXPECT_EQ(kindOf(0.3, layer(0.0, 4.0)), ElementKind::EdgeSmoothed);
  EXPECT_EQ(kindOf(0.3, layer(0.0, 3.0)), ElementKind::EdgeSmoothed);
  EXPECT_EQ(kindOf(0.3, layer(0.0, 9.0)), ElementKind::EdgeSmoothed) << "one material";
  EXPECT_EQ(kindOf(0.45, layer(0.0, 9.0)), ElementKind::Quadratic) << "it nearly keeps its volume";
  Random random(testSeed(283));
  EXPECT_EQ(kindOf(0.3, [&random](const Vec3&) { return random.uniform(1e4, 1e5); }), ElementKind::EdgeSmoothed);
  // Of so many edges that its factor would be gigabytes.
  const TetraMesh large = blockOf({ 12, 12, 12 }, { 12, 12, 12 });
  std::vector<double> young;
  std::ranges::transform(
    large.tetras, std::back_inserter(young), [&](const Tetra& t) { return layer(0.0, 1.0)(middleOf(large, t)); });
  for (const ElasticModel model : { ElasticModel::Linear, ElasticModel::NeoHookean })
  {
    EXPECT_EQ(usualElement(large, young, 0.3, model), ElementKind::EdgeSmoothed);
    EXPECT_EQ(usualElement(large, young, 0.45, model), ElementKind::Quadratic);
    EXPECT_EQ(usualElement(mesh, { 1e4 }, 0.3, model),
      model == ElasticModel::Linear ? ElementKind::Quadratic : ElementKind::EdgeSmoothed);
  }
}

std::vector<std::uint32_t> materials(const TetraMesh& mesh, const std::function<double(const Vec3&)>& young_Pa)
{
  std::vector<ElasticModuli> moduli;
  for (const Tetra& t : mesh.tetras)
  {
    moduli.push_back(moduliOf(young_Pa(middleOf(mesh, t)), 0.3, 1.0).value);
  }
  return materialsOf(mesh, moduli);
}

TEST(SoftArrays, AMaterialIsWhatIsAllAlikeAroundAVertexAndOtherCellsAreGraded)
{
  const TetraMesh mesh = blockOf({ 3, 3, 6 }, { 3, 3, 6 });
  const auto count = [](std::vector<std::uint32_t> of)
  {
    std::ranges::sort(of);
    return std::unique(of.begin(), of.end()) - of.begin();
  };
  const auto one = materials(mesh, [](const Vec3& p) { return 1e4 * (1.0 + 1e-3 * p.z()); });
  EXPECT_EQ(count(one), 1);
  EXPECT_NE(one.front(), gradedMaterial);
  const auto two = materials(mesh, [](const Vec3& p) { return p.z() < 3.0 ? 1e4 : 1.03e4; });
  for (std::size_t i = 0; i < two.size(); ++i)
  {
    EXPECT_EQ(two[i] == two.front(), middleOf(mesh, mesh.tetras[i]).z() < 3.0);
    EXPECT_NE(two[i], gradedMaterial);
  }
  Random random(testSeed(282));
  for (const std::uint32_t material : materials(mesh, [&random](const Vec3&) { return random.uniform(1e4, 1e5); }))
  {
    EXPECT_EQ(material, gradedMaterial);
  }
  const auto sheet = [](const Vec3& p) { return p.z() > 3.0 && p.z() < 4.0; }; // one cell thick, inside
  const auto three = materials(mesh, [&sheet](const Vec3& p) { return sheet(p) ? 1e6 : 1e4; });
  for (std::size_t i = 0; i < three.size(); ++i)
  {
    EXPECT_EQ(three[i] == gradedMaterial, sheet(middleOf(mesh, mesh.tetras[i])));
  }
}

} // namespace
} // namespace palpate::test
