// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMechanismFile.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>

#include "haptics/compliance/material/ElasticLaw.h"
#include "vtkHapticBodyFile.h"
#include "vtkHapticJson.h"
#include "vtkHapticJsonNode.h"
#include "vtkHapticMechanismBodies.h"

namespace
{
using Json = nlohmann::json;
using Node = vtkHapticJsonNode;

constexpr const char* Format = "palpate mechanism";
constexpr int Version = 1;
constexpr std::uintmax_t MostBytes = 1 << 20; ///< of a scene file; bodies are files of their own

template<class Kind>
Kind KindOf(const Node& node, std::initializer_list<Kind> kinds)
{
  const std::string name = node.Needed("kind");
  std::string all;
  for (const Kind kind : kinds)
  {
    if (name == palpate::nameOf(kind))
    {
      return kind;
    }
    all += (all.empty() ? "" : ", ") + std::string(palpate::nameOf(kind));
  }
  node.Fail("kind", "unknown kind \"" + name + "\"; valid kinds: " + all);
}

vtkHapticSoftDescription SoftOf(const Node& node, double unit_m)
{
  vtkHapticSoftDescription soft;
  soft.File = node.Text("file", "");
  soft.BoxSize_u = node.Vector("box", palpate::Vec3::Zero());
  soft.BoxMiddle_W = node.Vector("at", palpate::Vec3::Zero());
  soft.Edge_u = node.Size("edge");
  soft.Fixed = node.Text("fixed", "");
  soft.Material.Young_Pa = node.Number("young_Pa", soft.Material.Young_Pa);
  soft.Material.Poisson = node.Number("poisson", soft.Material.Poisson);
  soft.Material.Unit_m = unit_m;
  node.Accept("young_Pa", palpate::refuseModulus(soft.Material.Young_Pa));
  const std::string model = node.Text("model", "linear");
  if (!vtkHapticModelOf(model, soft.Material.Model))
  {
    node.Fail("model", "unknown model \"" + model + "\"; valid models: linear, corotational, neohookean");
  }
  if (soft.File.empty() == !node.Has("box"))
  {
    node.Fail("", "a soft body needs either a \"file\" or a \"box\"");
  }
  return soft;
}

palpate::MechanismBody BodyOf(const Node& node)
{
  using enum palpate::MechanismBodyKind;
  palpate::MechanismBody body;
  body.name = node.Name();
  body.kind = KindOf(node, { Held, Rigid, Soft, World });
  switch (body.kind)
  {
    case Held:
      node.Knows({ "name", "kind", "length", "diameter", "turn" });
      break;
    case Rigid:
      node.Knows({ "name", "kind", "half_size", "at", "turn", "load_N" });
      break;
    case Soft:
      node.Knows(
        { "name", "kind", "file", "box", "at", "edge", "fixed", "young_Pa", "poisson", "model", "tip_diameter" });
      break;
    case World:
      node.Knows({ "name", "kind" });
      break;
  }
  body.length_u = node.Number("length", 0.0);
  body.diameter_u = node.Number("diameter", 0.0);
  body.halfSize_u = node.Vector("half_size", palpate::Vec3::Zero());
  body.load_W = node.Vector("load_N", palpate::Vec3::Zero());
  body.pose_W.q = node.Turn("turn");
  if (body.kind == Rigid)
  {
    body.pose_W.p = node.Vector("at", palpate::Vec3::Zero());
  }
  return body;
}

palpate::MechanismConstraint ConstraintOf(const Node& node, double unit_m)
{
  using enum palpate::ConstraintKind;
  node.Knows({ "name", "kind", "a", "b", "point_a", "point_b", "axis_a", "axis_b", "strength_N", "tear_N", "friction",
    "dry_friction_N", "stiffness_N_per_m", "rest", "least", "most" });
  palpate::MechanismConstraint law;
  law.name = node.Name();
  law.kind = KindOf(
    node, { Contact, Attachment, Hinge, Slider, Break, Friction, DryFriction, Spring, Limit, Puncture, Insertion });
  if ((law.kind == Break || law.kind == Puncture) && !node.Has("strength_N"))
  {
    node.Fail("strength_N",
      "this key is missing: set the force [N] at which the constraint breaks or the surface is punctured");
  }
  law.a = node.Needed("a");
  law.b = node.Needed("b");
  law.point_A = node.Vector("point_a", law.point_A);
  law.point_B = node.Vector("point_b", law.point_B);
  law.axis_A = node.Vector("axis_a", law.axis_A);
  law.axis_B = node.Vector("axis_b", law.axis_B);
  law.strength_N = node.Number("strength_N", law.strength_N);
  law.tear_N = node.Number("tear_N", law.tear_N);
  law.friction = node.Number("friction", law.friction);
  law.dryFriction_N = node.Number("dry_friction_N", law.dryFriction_N);
  law.stiffness_N_per_u = unit_m * node.Number("stiffness_N_per_m", law.stiffness_N_per_u / unit_m);
  law.rest_u = node.Number("rest", law.rest_u);
  law.least_u = node.Number("least", law.least_u);
  law.most_u = node.Number("most", law.most_u);
  return law;
}

void CheckHead(const Node& root)
{
  root.Knows({ "format", "version", "unit_m", "bodies", "laws" });
  if (root.Needed("format") != Format)
  {
    root.Fail("format", std::string("must be \"") + Format + "\"");
  }
  const double version = root.Number("version", 0.0);
  if (version != Version)
  {
    root.Fail("version", "this program reads version " + std::to_string(Version) +
                           (version > Version ? "; the file has a later version: update Palpate" : ""));
  }
}

constexpr double NoTipGiven = -1.0;

/// A body without a tip of its own is pressed by one as wide as the rod in the hand, whatever the mesh is.
void PressByHeld(palpate::MechanismInputs& inputs)
{
  const auto held =
    std::ranges::find(inputs.mechanism.bodies, palpate::MechanismBodyKind::Held, &palpate::MechanismBody::kind);
  const double tip_u = held != inputs.mechanism.bodies.end() ? 0.5 * held->diameter_u : 0.0;
  for (palpate::MechanismSoftInput& soft : inputs.soft)
  {
    soft.tip_u = soft.tip_u == NoTipGiven ? tip_u : soft.tip_u;
  }
}

vtkHapticMechanismResult Build(
  const Node& root, const std::string& folder, const std::vector<palpate::MechanismSoftInput>& read)
{
  CheckHead(root);
  vtkHapticMechanismResult result;
  auto inputs = std::make_shared<palpate::MechanismInputs>();
  inputs->unit_m = root.Number("unit_m", 1.0);
  if (!(inputs->unit_m >= 1e-12 && inputs->unit_m <= 1e6))
  {
    root.Fail("unit_m", "must be a number of metres from 1e-12 to 1e6");
  }
  for (const Node& node : root.List("bodies"))
  {
    inputs->mechanism.bodies.push_back(BodyOf(node));
    const palpate::MechanismBody& body = inputs->mechanism.bodies.back();
    if (body.kind != palpate::MechanismBodyKind::Soft || !read.empty())
    {
      continue;
    }
    vtkHapticDescribedSoft made = vtkHapticMakeSoft(SoftOf(node, inputs->unit_m), folder);
    if (!made.Input)
    {
      node.Fail("", body.name + " cannot be a soft body: " + made.Problem);
    }
    const double tip_u = node.Has("tip_diameter") ? 0.5 * node.Size("tip_diameter") : NoTipGiven;
    inputs->soft.push_back({ body.name, made.Input, tip_u });
    result.SoftGrids.push_back(made.Grid);
  }
  inputs->soft = read.empty() ? inputs->soft : read;
  PressByHeld(*inputs);
  for (const Node& node : root.List("laws"))
  {
    inputs->mechanism.laws.push_back(ConstraintOf(node, inputs->unit_m));
  }
  result.Inputs = inputs;
  return result;
}
/// The result of a function that reads JSON: "" or the fault of the text.
template<class Read>
std::string ProblemOf(const Read& read)
{
  try
  {
    read();
    return "";
  }
  catch (const Json::parse_error& error)
  {
    return "not JSON: byte " + std::to_string(error.byte) + " is unexpected";
  }
  catch (const Json::exception&)
  {
    return "the JSON text has a number that is too large";
  }
  catch (const vtkHapticJsonProblem& problem)
  {
    return problem.what();
  }
}

/// Those of the file, or those in their place.
Json ConstraintsOf(const std::string& text, const std::string& laws)
{
  const Json file = Json::parse(text);
  const Json list = laws.empty() ? (file.is_object() ? file.value("laws", Json::array()) : Json()) : Json::parse(laws);
  if (!list.is_array())
  {
    throw vtkHapticJsonProblem("laws: must be a list, [ ... ]");
  }
  return list;
}

Json Without(const Json& laws, const std::string& name)
{
  Json others = Json::array();
  std::copy_if(laws.begin(), laws.end(), std::back_inserter(others),
    [&name](const Json& law) { return !law.is_object() || law.value("name", Json()) != name; });
  return others;
}
} // namespace

vtkHapticMechanismResult vtkHapticParseMechanism(const std::string& text, const std::string& folder,
  const std::string& laws, const std::vector<palpate::MechanismSoftInput>& read)
{
  vtkHapticMechanismResult result;
  result.Problem = ProblemOf(
    [&]
    {
      Json json = Json::parse(text);
      if (!laws.empty() && json.is_object())
      {
        json["laws"] = ConstraintsOf(text, laws);
      }
      result = Build(Node(json, ""), folder, read);
    });
  result.Text = text;
  return result;
}

std::string vtkHapticWithConstraint(
  const std::string& text, const std::string& laws, const std::string& law, std::string& problem)
{
  std::string with;
  problem = ProblemOf(
    [&]
    {
      const Json added = Json::parse(law);
      Json list = Without(ConstraintsOf(text, laws), ConstraintOf(Node(added, "law"), 1.0).name);
      list.push_back(added);
      with = list.dump();
    });
  return with;
}

std::string vtkHapticWithoutConstraint(
  const std::string& text, const std::string& laws, const std::string& name, std::string& problem)
{
  std::string without;
  problem = ProblemOf(
    [&]
    {
      const Json list = ConstraintsOf(text, laws), others = Without(list, name);
      if (others.size() == list.size())
      {
        throw vtkHapticJsonProblem("there is no constraint \"" + name + "\"");
      }
      without = others.dump();
    });
  return without;
}

vtkHapticMechanismResult vtkHapticReadMechanism(const std::string& file)
{
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  if (error || !stream || bytes > MostBytes)
  {
    return { nullptr, {}, "", file + (error || !stream ? ": cannot be read" : ": a scene file has at most 1 MiB") };
  }
  const std::string text{ std::istreambuf_iterator<char>(stream), {} };
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  vtkHapticMechanismResult result = vtkHapticParseMechanism(text, folder.string());
  result.Problem = result.Problem.empty() ? "" : file + ": " + result.Problem;
  return result;
}

bool vtkHapticIsMechanismFile(const std::string& file)
{
  std::string suffix = std::filesystem::path(file).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  return suffix == ".json";
}
