// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMechanismFile.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <sstream>

#include "haptics/compliance/material/ElasticLaw.h"
#include "haptics/core/PoseMath.h"
#include "haptics/geometry/mesh/Material.h"
#include "haptics/mechanism/sided/SidedSurface.h"
#include "vtkHapticBodyFile.h"
#include "vtkHapticMechanismBodies.h"
#include "vtkHapticWireFile.h"

namespace
{
using Json = nlohmann::json;
using Node = vtkHapticSceneNode;

constexpr std::uintmax_t MostBytes = 1 << 20; ///< of a scene file; bodies are files of their own

template<class Kind>
Kind KindOf(const Node& node, std::initializer_list<Kind> kinds)
{
  const std::string name = node.needed("kind");
  std::string all;
  for (const Kind kind : kinds)
  {
    if (name == palpate::nameOf(kind))
    {
      return kind;
    }
    all += (all.empty() ? "" : ", ") + std::string(palpate::nameOf(kind));
  }
  node.fail("kind", "unknown kind \"" + name + "\"; valid kinds: " + all);
}

vtkHapticSoftDescription SoftOf(const Node& node, double unit_m)
{
  vtkHapticSoftDescription soft;
  soft.File = node.text("file", "");
  soft.BoxSize_u = node.vector("box", palpate::Vec3::Zero());
  soft.BoxMiddle_W = node.vector("at", palpate::Vec3::Zero());
  soft.Edge_u = node.size("edge");
  soft.Fixed = node.text("fixed", "");
  soft.Material.Young_Pa = node.number("young_Pa", soft.Material.Young_Pa);
  soft.Material.Poisson = node.number("poisson", soft.Material.Poisson);
  soft.Material.Unit_m = unit_m;
  node.accept("young_Pa", palpate::refuseModulus(soft.Material.Young_Pa));
  const std::string model = node.text("model", "linear");
  if (!vtkHapticModelOf(model, soft.Material.Model))
  {
    node.fail("model", "unknown model \"" + model + "\"; valid models: linear, corotational, neohookean");
  }
  if (soft.File.empty() == !node.has("box"))
  {
    node.fail("", "a soft body needs either a \"file\" or a \"box\"");
  }
  return soft;
}

/// All that the bodies of a file share.
struct Surroundings
{
  std::string folder;
  double unit_m = 1.0;
  palpate::Vec3 gravity_m_per_s2{ 0.0, 0.0, -9.81 };
  std::shared_ptr<const palpate::TriangleMesh> vessel_W; ///< of a wire that names no file of one; null: none
};

/// A box that stands: the mesh of its surface, where it stands.
std::shared_ptr<const palpate::SidedSurface> StandingBox(const Node& node, const palpate::MechanismBody& body)
{
  palpate::TriangleMesh box = palpate::boxOf(body.halfSize_u);
  for (palpate::Vec3& p : box.vertices_W)
  {
    p = body.pose_W * p;
  }
  const auto made = palpate::makeRigidMesh(box);
  node.accept("half_size", made.problem);
  return made.value;
}

/// A mesh, or the box in place of one. An open mesh has no volume.
void ReadMesh(const Node& node, const Surroundings& around, palpate::MechanismBody& body)
{
  if (!node.has("file"))
  {
    return;
  }
  if (node.has("half_size"))
  {
    node.fail("file", "a body has either a \"file\" or a \"half_size\"");
  }
  if (body.kind == palpate::MechanismBodyKind::Rigid && !node.has("density"))
  {
    node.fail("density", "this key is missing: a rigid mesh is loose, and needs a density [kg/m^3]");
  }
  const bool stands = body.kind == palpate::MechanismBodyKind::World;
  const auto read =
    vtkHapticReadRigidMesh(node.text("file", ""), around.folder, stands ? body.pose_W : palpate::Pose());
  const bool loose = body.kind == palpate::MechanismBodyKind::Rigid;
  node.accept("file", read.ok() || !loose ? read.problem : read.problem + ", so that its density gives a mass");
  body.mesh = read.value;
}

/// The origin of the body's frame in that of its file.
palpate::Vec3 ReadMass(const Node& node, const Surroundings& around, palpate::MechanismBody& body)
{
  if (!node.has("density"))
  {
    return palpate::Vec3::Zero();
  }
  const palpate::MassGiven given = palpate::giveMass(body, node.number("density", 0.0), around.unit_m);
  node.accept("density", given.refusal);
  body.load_W += body.mass.mass_Ns2_per_u / around.unit_m * around.gravity_m_per_s2;
  return given.centre_u;
}

palpate::MechanismBody BodyOf(const Node& node, const Surroundings& around, palpate::Vec3& centre_u)
{
  using enum palpate::MechanismBodyKind;
  palpate::MechanismBody body;
  body.name = node.name();
  body.kind = KindOf(node, { Held, Rigid, Soft, World, Wire });
  switch (body.kind)
  {
    case Held:
      node.knows({ "name", "kind", "file", "length", "diameter", "turn" });
      break;
    case Rigid:
      node.knows({ "name", "kind", "file", "half_size", "at", "turn", "load_N", "density" });
      break;
    case Soft:
      node.knows(
        { "name", "kind", "file", "box", "at", "edge", "fixed", "young_Pa", "poisson", "model", "tip_diameter" });
      break;
    case World:
      node.knows({ "name", "kind", "file", "half_size", "at", "turn" });
      break;
    case Wire:
      node.knows({ "name", "kind", "vessel", "diameter", "length", "young_Pa", "tip_young_Pa", "poisson", "friction",
        "mouth", "direction", "beams", "tip", "tip_length", "tip_radius", "tip_pitch" });
      body.wire = vtkHapticReadWire(node, around.folder, around.unit_m, around.vessel_W);
      return body;
  }
  body.length_u = node.number("length", 0.0);
  body.diameter_u = node.number("diameter", 0.0);
  body.halfSize_u = node.vector("half_size", palpate::Vec3::Zero());
  body.load_W = node.vector("load_N", palpate::Vec3::Zero());
  body.pose_W.q = node.turn("turn");
  if (body.kind == Rigid || body.kind == World)
  {
    body.pose_W.p = node.vector("at", palpate::Vec3::Zero());
  }
  if (body.kind != Soft)
  {
    ReadMesh(node, around, body);
  }
  if (body.kind == World) // its frame is the scene's
  {
    body.mesh = node.has("half_size") ? StandingBox(node, body) : body.mesh;
    body.halfSize_u.setZero();
    body.pose_W = {};
  }
  if (body.kind == Rigid)
  {
    centre_u = ReadMass(node, around, body);
  }
  return body;
}

palpate::MechanismConstraint ConstraintOf(const Node& node, double unit_m)
{
  using enum palpate::ConstraintKind;
  node.knows({ "name", "kind", "a", "b", "point_a", "point_b", "axis_a", "axis_b", "strength_N", "tear_N", "friction",
    "dry_friction_N", "stiffness_N_per_m", "rest", "least", "most" });
  palpate::MechanismConstraint law;
  law.name = node.name();
  law.kind = KindOf(
    node, { Contact, Attachment, Hinge, Slider, Break, Friction, DryFriction, Spring, Limit, Puncture, Insertion });
  if ((law.kind == Break || law.kind == Puncture) && !node.has("strength_N"))
  {
    node.fail("strength_N",
      "this key is missing: set the force [N] at which the constraint breaks or the surface is punctured");
  }
  law.a = node.needed("a");
  law.b = node.needed("b");
  law.point_A = node.vector("point_a", law.point_A);
  law.point_B = node.vector("point_b", law.point_B);
  law.axis_A = node.vector("axis_a", law.axis_A);
  law.axis_B = node.vector("axis_b", law.axis_B);
  law.strength_N = node.number("strength_N", law.strength_N);
  law.tear_N = node.number("tear_N", law.tear_N);
  law.friction = node.number("friction", law.friction);
  law.dryFriction_N = node.number("dry_friction_N", law.dryFriction_N);
  law.stiffness_N_per_u = unit_m * node.number("stiffness_N_per_m", law.stiffness_N_per_u / unit_m);
  law.rest_u = node.number("rest", law.rest_u);
  law.least_u = node.number("least", law.least_u);
  law.most_u = node.number("most", law.most_u);
  return law;
}

void CheckHead(const Node& root)
{
  root.knows({ "format", "version", "unit_m", "bodies", "laws", "contacts", "friction", "gravity" });
  palpate::checkHead(root, vtkHapticSceneFormat, vtkHapticSceneVersion);
}

/// Contacts that are found have no other word.
void FindContacts(const Node& root, palpate::Mechanism& mechanism)
{
  mechanism.findsContacts = root.has("contacts");
  if (mechanism.findsContacts && root.text("contacts", "") != "found")
  {
    root.fail("contacts", "must be \"found\": omit the key where contacts are named constraints");
  }
  if (root.has("friction") && !mechanism.findsContacts)
  {
    root.fail(
      "friction", "is that of found contacts: set \"contacts\": \"found\", or give the friction of a constraint");
  }
  mechanism.foundFriction = root.size("friction");
  if (mechanism.foundFriction > palpate::Material::largestFriction)
  {
    std::ostringstream text;
    text << "must be from 0 to " << palpate::Material::largestFriction;
    root.fail("friction", text.str());
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

/// Points are given in the frame of a body's file, whose origin is not the centre of a loose mesh.
palpate::Vec3 CentreOf(const std::map<std::string, palpate::Vec3>& centres_u, const std::string& body)
{
  const auto found = centres_u.find(body);
  return found != centres_u.end() ? found->second : palpate::Vec3(palpate::Vec3::Zero());
}

vtkHapticMechanismResult Build(
  const Node& root, Surroundings around, const std::vector<palpate::MechanismSoftInput>& read)
{
  CheckHead(root);
  vtkHapticMechanismResult result;
  auto inputs = std::make_shared<palpate::MechanismInputs>();
  inputs->unit_m = root.number("unit_m", 1.0);
  if (!(inputs->unit_m >= 1e-12 && inputs->unit_m <= 1e6))
  {
    root.fail("unit_m", "must be a number of metres from 1e-12 to 1e6");
  }
  around.unit_m = inputs->unit_m;
  around.gravity_m_per_s2 = root.vector("gravity", around.gravity_m_per_s2);
  std::map<std::string, palpate::Vec3> centres_u;
  for (const Node& node : root.list("bodies"))
  {
    palpate::Vec3 centre_u = palpate::Vec3::Zero();
    inputs->mechanism.bodies.push_back(BodyOf(node, around, centre_u));
    centres_u[inputs->mechanism.bodies.back().name] = centre_u;
    const palpate::MechanismBody& body = inputs->mechanism.bodies.back();
    result.VesselGiven = result.VesselGiven || (body.wire && !node.has("vessel"));
    if (body.kind != palpate::MechanismBodyKind::Soft || !read.empty())
    {
      continue;
    }
    vtkHapticDescribedSoft made = vtkHapticMakeSoft(SoftOf(node, inputs->unit_m), around.folder);
    if (!made.Input)
    {
      node.fail("", body.name + " cannot be a soft body: " + made.Problem);
    }
    const double tip_u = node.has("tip_diameter") ? 0.5 * node.size("tip_diameter") : NoTipGiven;
    inputs->soft.push_back({ body.name, made.Input, tip_u });
    result.SoftGrids.push_back(made.Grid);
  }
  inputs->soft = read.empty() ? inputs->soft : read;
  PressByHeld(*inputs);
  FindContacts(root, inputs->mechanism);
  if (root.has("gravity") && std::ranges::none_of(inputs->mechanism.bodies, [](const auto& b) { return isLoose(b); }))
  {
    root.fail("gravity", "acts on bodies with a \"density\", and there are none: give one, or set \"load_N\"");
  }
  const bool meets = inputs->mechanism.findsContacts ||
                     std::ranges::any_of(inputs->mechanism.bodies, [](const auto& b) { return b.wire != nullptr; });
  for (const Node& node : meets && !root.has("laws") ? std::vector<Node>() : root.list("laws"))
  {
    palpate::MechanismConstraint& law = inputs->mechanism.laws.emplace_back(ConstraintOf(node, inputs->unit_m));
    law.point_A -= CentreOf(centres_u, law.a);
    law.point_B -= CentreOf(centres_u, law.b);
  }
  result.Inputs = inputs;
  return result;
}

/// Those of the file, or those in their place.
Json ConstraintsOf(const std::string& text, const std::string& laws)
{
  const Json file = Json::parse(text);
  const Json list = laws.empty() ? (file.is_object() ? file.value("laws", Json::array()) : Json()) : Json::parse(laws);
  if (!list.is_array())
  {
    throw palpate::JsonProblem("laws: must be a list, [ ... ]");
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
  const std::string& laws, const std::vector<palpate::MechanismSoftInput>& read,
  const std::shared_ptr<const palpate::TriangleMesh>& vessel_W)
{
  Surroundings around;
  around.folder = folder;
  around.vessel_W = vessel_W;
  vtkHapticMechanismResult result;
  result.Problem = palpate::jsonProblemOf<Json>(
    [&]
    {
      Json json = Json::parse(text);
      if (!laws.empty() && json.is_object())
      {
        json["laws"] = ConstraintsOf(text, laws);
      }
      result = Build(Node(json, ""), around, read);
    });
  result.Text = text;
  return result;
}

std::string vtkHapticWithConstraint(
  const std::string& text, const std::string& laws, const std::string& law, std::string& problem)
{
  std::string with;
  problem = palpate::jsonProblemOf<Json>(
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
  problem = palpate::jsonProblemOf<Json>(
    [&]
    {
      const Json list = ConstraintsOf(text, laws), others = Without(list, name);
      if (others.size() == list.size())
      {
        throw palpate::JsonProblem("there is no constraint \"" + name + "\"");
      }
      without = others.dump();
    });
  return without;
}

palpate::Outcome<std::string> vtkHapticSceneText(const std::string& file)
{
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  if (error || !stream || bytes > MostBytes)
  {
    return { "", file + (error || !stream ? ": cannot be read" : ": a scene file has at most 1 MiB") };
  }
  return { std::string{ std::istreambuf_iterator<char>(stream), {} }, "" };
}

vtkHapticMechanismResult vtkHapticReadMechanism(const std::string& file)
{
  const palpate::Outcome<std::string> text = vtkHapticSceneText(file);
  if (!text.ok())
  {
    return { nullptr, {}, "", text.problem };
  }
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  vtkHapticMechanismResult result = vtkHapticParseMechanism(text.value, folder.string());
  result.Problem = result.Problem.empty() ? "" : file + ": " + result.Problem;
  return result;
}

bool vtkHapticIsMechanismFile(const std::string& file)
{
  std::string suffix = std::filesystem::path(file).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  return suffix == ".json";
}
