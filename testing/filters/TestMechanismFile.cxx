// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files of mechanisms: their content is read, and text without a meaning is refused with its place.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/support/Random.h"
#include "vtkDataSet.h"
#include "vtkHapticMechanismFile.h"

using namespace palpate;
using namespace palpate::test;
using ::testing::HasSubstr;

namespace
{
/// A needle through a wall, with a plate that leans on a spring.
const std::string whole = R"({
  "format": "palpate mechanism", "version": 1, "unit_m": 0.001,
  "bodies": [
    { "name": "needle", "kind": "held", "length": 150, "diameter": 1.2 },
    { "name": "wall", "kind": "soft", "box": [40, 40, 10], "at": [0, 0, -5], "edge": 10, "fixed": "zmin",
      "young_Pa": 50000, "poisson": 0.3, "model": "linear" },
    { "name": "plate", "kind": "rigid", "half_size": [5, 5, 1], "at": [1, 2, 3], "turn": [0, 1, 0, 0],
      "load_N": [0, 0, -0.5] },
    { "name": "table", "kind": "world" }
  ],
  "laws": [
    { "name": "skin", "kind": "puncture", "a": "needle", "b": "wall", "strength_N": 1.5, "dry_friction_N": 0.4,
      "tear_N": 9 },
    { "name": "rest", "kind": "spring", "a": "plate", "b": "table", "point_a": [0, 0, -1], "point_b": [1, 2, 0],
      "axis_b": [0, 0, 1], "stiffness_N_per_m": 400, "rest": 2 },
    { "name": "stop", "kind": "limit", "a": "plate", "b": "table", "least": -1, "most": 4 }
  ]
})";

/// The whole file with one text in place of another, which must be in it.
std::string with(const std::string& text, const std::string& other)
{
  std::string changed = whole;
  const std::size_t at = changed.find(text);
  EXPECT_NE(at, std::string::npos) << text;
  return changed.replace(at, text.size(), other);
}

std::string problemOf(const std::string& text)
{
  const vtkHapticMechanismResult read = vtkHapticParseMechanism(text, ".");
  EXPECT_EQ(read.Inputs == nullptr, !read.Problem.empty());
  return read.Problem;
}
} // namespace

TEST(MechanismFile, WhatAFileSaysIsWhatIsRead)
{
  const vtkHapticMechanismResult read = vtkHapticParseMechanism(whole, ".");
  ASSERT_TRUE(read.Inputs) << read.Problem;
  const Mechanism& mechanism = read.Inputs->mechanism;
  ASSERT_EQ(mechanism.bodies.size(), 4u);
  EXPECT_EQ(mechanism.bodies[0].kind, MechanismBodyKind::Held);
  EXPECT_EQ(mechanism.bodies[0].length_u, 150.0);
  EXPECT_EQ(mechanism.bodies[0].diameter_u, 1.2);
  EXPECT_EQ(mechanism.bodies[2].pose_W.p, Vec3(1, 2, 3));
  EXPECT_EQ(mechanism.bodies[2].pose_W.q.x(), 1.0);
  EXPECT_EQ(mechanism.bodies[2].load_W, Vec3(0, 0, -0.5));
  ASSERT_EQ(mechanism.laws.size(), 3u);
  const MechanismConstraint &skin = mechanism.laws[0], &rest = mechanism.laws[1], &stop = mechanism.laws[2];
  EXPECT_EQ(skin.kind, ConstraintKind::Puncture);
  EXPECT_EQ(std::tie(skin.a, skin.b), std::make_tuple("needle", "wall"));
  EXPECT_EQ(skin.strength_N, 1.5);
  EXPECT_EQ(skin.tear_N, 9.0);
  EXPECT_EQ(skin.dryFriction_N, 0.4);
  EXPECT_EQ(rest.point_B, Vec3(1, 2, 0));
  EXPECT_DOUBLE_EQ(rest.stiffness_N_per_u, 0.4) << "a unit is a millimetre";
  EXPECT_EQ(rest.rest_u, 2.0);
  EXPECT_EQ(skin.stiffness_N_per_u, MechanismConstraint::unlimited) << "nobody has named one";
  EXPECT_EQ(std::pair(stop.least_u, stop.most_u), std::pair(-1.0, 4.0));
}

TEST(MechanismFile, ABoxOfASoftBodyIsWhereAndAsLargeAsItIsSaidToBeAndHeldWhereItIsSaid)
{
  const vtkHapticMechanismResult read = vtkHapticParseMechanism(whole, ".");
  ASSERT_EQ(read.SoftGrids.size(), 1u) << read.Problem;
  const std::array<double, 6> box{ -20, 20, -20, 20, -10, 0 };
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_DOUBLE_EQ(read.SoftGrids[0]->GetBounds()[i], box[i]) << i;
  }
  const SoftBodyInput& wall = *read.Inputs->soft[0].input;
  double volume = 0.0;
  for (const auto& tetra : wall.mesh.tetras)
  {
    Mat3 sides;
    for (int i = 0; i < 3; ++i)
    {
      sides.col(i) = wall.mesh.vertices_W[tetra[i + 1]] - wall.mesh.vertices_W[tetra[0]];
    }
    volume += std::abs(sides.determinant()) / 6.0;
  }
  EXPECT_NEAR(volume, 40.0 * 40.0 * 10.0, 1e-6);
  ASSERT_EQ(wall.fixed.size(), wall.mesh.vertices_W.size());
  for (std::size_t v = 0; v < wall.fixed.size(); ++v)
  {
    EXPECT_EQ(wall.fixed[v], wall.mesh.vertices_W[v].z() < -9.9) << v;
  }
  EXPECT_EQ(wall.poisson, 0.3);
  EXPECT_EQ(wall.young_Pa.front(), 50000.0);
  EXPECT_EQ(wall.unit_m, 0.001);
}

TEST(MechanismFile, WhatItDoesNotMeanIsRefusedInWordsThatNameThePlace)
{
  const std::array<std::pair<std::string, std::string>, 18> cases = { {
    { "{", "not JSON: byte" },
    { "[]", "must be an object" },
    { with("palpate mechanism", "a drawing"), "format: must be \"palpate mechanism\"" },
    { with("\"version\": 1", "\"version\": 2"), "version: this program reads version 1; the file has a later version" },
    { with("\"version\": 1", "\"version\": 0"), "version: this program reads version 1" },
    { with("\"unit_m\": 0.001", "\"unit_m\": 0"), "unit_m" },
    { with("\"diameter\"", "\"diametre\""), "bodies[0].diametre: unknown key" },
    { with("\"least\": -1", "\"leest\": -1"), "laws[2].leest: unknown key" },
    { with("\"held\"", "\"hold\""), "bodies[0].kind: unknown kind \"hold\"; valid kinds: held" },
    { with("\"puncture\"", "\"pierce\""), "laws[0].kind: unknown kind \"pierce\"" },
    { with("\"name\": \"rest\", ", ""), "laws[1].name: this key is missing" },
    { with("\"length\": 150", "\"length\": \"150\""), "bodies[0].length: must be a finite number" },
    { with("\"length\": 150", "\"length\": 1e999"), "JSON" },
    { with("[0, 1, 0, 0]", "[0, 0, 0, 0]"), "bodies[2].turn: a rotation must be a quaternion" },
    { with("[1, 2, 3]", "[1, 2]"), "bodies[2].at: must be a list of 3 numbers" },
    { with("\"box\": [40, 40, 10], ", ""), "bodies[1]: a soft body needs either a \"file\" or a \"box\"" },
    { with("\"box\": [40, 40, 10]", "\"box\": [40, 0, 10]"), "bodies[1]: wall cannot be a soft body" },
    { with("\"box\": [40, 40, 10], \"at\": [0, 0, -5], ", "\"file\": \"nowhere.vtu\", "), "nowhere.vtu" },
  } };
  for (const auto& [text, problem] : cases)
  {
    EXPECT_THAT(problemOf(text), HasSubstr(problem));
  }
}

TEST(MechanismFile, ABodysFileIsLookedForBesideTheSceneFileAndAProblemNamesTheSceneFile)
{
  const std::string folder = std::string(::testing::TempDir()) + "palpate-mechanism";
  std::filesystem::create_directories(folder);
  const std::string file = folder + "/scene.json";
  std::ofstream(file) << with("\"box\": [40, 40, 10], \"at\": [0, 0, -5], ", "\"file\": \"wall.vtu\", ");
  const vtkHapticMechanismResult read = vtkHapticReadMechanism(file);
  EXPECT_THAT(read.Problem, HasSubstr(file + ": "));
  EXPECT_THAT(read.Problem, HasSubstr(folder + "/wall.vtu"));
  EXPECT_THAT(vtkHapticReadMechanism(folder + "/none.json").Problem, HasSubstr("none.json: cannot be read"));
  std::filesystem::remove_all(folder);
}

namespace
{
/// The whole file without its soft body, which takes long to read, and with a loose one in its place.
std::string looseFile()
{
  const std::string load = "\"load_N\": [0, 0, -0.5]", head = "\"unit_m\": 0.001,";
  std::string text = with(
    R"({ "name": "wall", "kind": "soft", "box": [40, 40, 10], "at": [0, 0, -5], "edge": 10, "fixed": "zmin",
      "young_Pa": 50000, "poisson": 0.3, "model": "linear" },)",
    "");
  text.replace(text.find(load), load.size(), load + ", \"density\": 2500");
  return text.replace(text.find(head), head.size(), head + " \"gravity\": [0, 0, -9.81],");
}
} // namespace

TEST(MechanismFile, ADensityGivesABoxTheMassAndTheWeightOfItsVolume)
{
  const vtkHapticMechanismResult read = vtkHapticParseMechanism(looseFile(), ".");
  ASSERT_TRUE(read.Inputs) << read.Problem;
  const MechanismBody& plate = read.Inputs->mechanism.bodies[1];
  const double mass_kg = 2500.0 * 0.010 * 0.010 * 0.002;
  EXPECT_TRUE(isLoose(plate));
  EXPECT_NEAR(plate.mass.mass_Ns2_per_u, mass_kg * 0.001, 1e-12 * mass_kg);
  EXPECT_NEAR(plate.load_W.z(), -0.5 - 9.81 * mass_kg, 1e-12);
  EXPECT_EQ(plate.pose_W.p, Vec3(1, 2, 3));
  const vtkHapticMechanismResult light = vtkHapticParseMechanism(whole, ".");
  EXPECT_FALSE(isLoose(light.Inputs->mechanism.bodies[2])) << "without density it is at rest in each tick";
  EXPECT_EQ(light.Inputs->mechanism.bodies[2].mesh, nullptr);
}

TEST(MechanismFile, AMassThatIsNoneIsRefusedByItsDensity)
{
  const auto changed = [](const std::string& from, const std::string& to)
  {
    std::string text = looseFile();
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string density = "\"density\": 2500";
  EXPECT_THAT(problemOf(changed(density, "\"density\": 0")), HasSubstr("bodies[1].density: must be above 0"));
  EXPECT_THAT(problemOf(changed(density, "\"density\": \"heavy\"")), HasSubstr("bodies[1].density: must be a finite"));
  EXPECT_THAT(problemOf(changed("[5, 5, 1]", "[5, 5, 0]")), HasSubstr("bodies[1].density: gives no mass"));
  EXPECT_THAT(problemOf(changed(", " + density, "")), HasSubstr("gravity: acts on bodies with a \"density\""));
  EXPECT_THAT(problemOf(changed("\"length\": 150", "\"density\": 1")), HasSubstr("bodies[0].density: unknown key"));
}

TEST(MechanismFile, AnyBytesAreAMechanismOrOneLineThatSaysWhyNot)
{
  const std::string start = looseFile();
  const std::uint64_t seed = testSeed(20);
  Random random(seed);
  const std::size_t count = testCount(20000);
  const auto any = [&random](int least, int most)
  { return least + static_cast<int>(random.below(static_cast<std::uint32_t>(most - least + 1))); };
  int read = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::string text = start;
    for (int change = any(1, 3); change > 0 && !text.empty(); --change)
    {
      const auto at = static_cast<std::size_t>(any(0, static_cast<int>(text.size()) - 1));
      switch (any(0, 3))
      {
        case 0:
          text[at] = static_cast<char>(any(-128, 127));
          break;
        case 1:
          text.insert(at, 1, "{}[],:\"0e-"[any(0, 9)]);
          break;
        case 2:
          text.erase(at, static_cast<std::size_t>(any(1, 20)));
          break;
        default:
          text.resize(at);
      }
    }
    const vtkHapticMechanismResult result = vtkHapticParseMechanism(text, ".");
    ASSERT_NE(result.Inputs == nullptr, result.Problem.empty()) << seed << ": " << text;
    ASSERT_EQ(result.Problem.find('\n'), std::string::npos) << seed << ": " << text;
    read += result.Inputs ? 1 : 0;
  }
  EXPECT_GT(read, 0) << "a number may change";
}

TEST(MechanismFile, LawsAreAddedReplacedAndTakenAwayAndTheRestStaysAsItIs)
{
  std::string problem;
  const std::string more = R"({ "name": "glue", "kind": "break", "a": "plate", "b": "table", "strength_N": 2 })";
  const std::string four = vtkHapticWithConstraint(whole, "", more, problem);
  ASSERT_EQ(problem, "");
  const auto lawsOf = [](const std::string& laws)
  {
    const vtkHapticMechanismResult read = vtkHapticParseMechanism(whole, ".", laws);
    EXPECT_TRUE(read.Inputs) << read.Problem;
    return read.Inputs ? read.Inputs->mechanism.laws : std::vector<MechanismConstraint>();
  };
  std::vector<MechanismConstraint> expected = lawsOf("");
  const std::vector<MechanismConstraint> now = lawsOf(four);
  ASSERT_EQ(now.size(), 4u);
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), now.begin()));
  EXPECT_EQ(now.back().kind, ConstraintKind::Break);
  EXPECT_EQ(now.back().strength_N, 2.0);
  const std::string three = vtkHapticWithoutConstraint(whole, four, "rest", problem);
  ASSERT_EQ(problem, "");
  EXPECT_EQ(lawsOf(three).size(), 3u);
  EXPECT_EQ(lawsOf(three)[1].name, "stop");
  const std::string again = vtkHapticWithConstraint(
    whole, three, R"({ "name": "glue", "kind": "break", "a": "plate", "b": "table", "strength_N": 7 })", problem);
  EXPECT_EQ(lawsOf(again).size(), 3u) << "in the place of the one of its name";
  EXPECT_EQ(lawsOf(again).back().strength_N, 7.0);
  EXPECT_EQ(vtkHapticWithoutConstraint(whole, four, "nobody", problem), "");
  EXPECT_THAT(problem, HasSubstr("no constraint \"nobody\""));
  EXPECT_EQ(vtkHapticWithConstraint(whole, four, R"({ "kind": "break" })", problem), "");
  EXPECT_THAT(problem, HasSubstr("law.name: this key is missing"));
  EXPECT_EQ(vtkHapticWithConstraint(whole, "7", more, problem), "");
  EXPECT_THAT(problem, HasSubstr("must be a list"));
}
