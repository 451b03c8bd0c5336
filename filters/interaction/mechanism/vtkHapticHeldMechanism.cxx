// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticHeldMechanism.h"

#include "haptics/core/PoseMath.h"
#include "haptics/session/HapticSession.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <sstream>
#include <utility>

#include "haptics/session/SessionWorkers.h"
#include "haptics/session/settings/Setting.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkHapticHeldWire.h"
#include "vtkHapticMechanismData.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkHapticTool.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace
{
constexpr std::array Phases = { "open", "closed", "slips", "inside", "gone" };

/// How a body has gone from where it was at first: a held one was at the origin.
struct Way
{
  palpate::Pose Rigid;
  vtkHapticBodyWay Soft; ///< of a soft one's vertices; null: of none
};

/// Of one vertex, where there is such an array.
palpate::Vec3 Of(vtkDoubleArray* array, double vertex)
{
  const auto at = static_cast<vtkIdType>(vertex);
  const bool known = array && at >= 0 && at < array->GetNumberOfTuples();
  return known ? palpate::Vec3(array->GetPointer(3 * at)) : palpate::Vec3(palpate::Vec3::Zero());
}

vtkSmartPointer<vtkDoubleArray> Vectors(const char* name, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(tuples);
  return array;
}

Way WayOf(const palpate::MechanismBody& body, const palpate::Pose& now_W)
{
  using enum palpate::MechanismBodyKind;
  if (body.kind != Held && body.kind != Rigid)
  {
    return {};
  }
  const palpate::Quat turn = now_W.q * body.pose_W.q.conjugate();
  return { { now_W.p - turn * body.pose_W.p, turn }, {} };
}

/// Soft bodies come in the order in which the description has them.
std::vector<Way> WaysOf(const palpate::MechanismInputs& inputs, std::span<const palpate::Pose> pose_W,
  const std::vector<palpate::SeenBody>& seen, std::span<const palpate::Vec3> wire_W)
{
  std::vector<Way> ways;
  std::size_t soft = 0;
  for (const palpate::MechanismBody& body : inputs.mechanism.bodies)
  {
    ways.push_back(WayOf(body, pose_W[ways.size()]));
    if (body.wire && body.wire->plan)
    {
      ways.back().Soft.Displacement = vtkHapticWireWay(*body.wire->plan, wire_W);
    }
    if (body.kind == palpate::MechanismBodyKind::Soft && soft < std::min(seen.size(), inputs.soft.size()))
    {
      ways.back().Soft = vtkHapticWayOf(*inputs.soft[soft].input, seen[soft].asMade.get(), seen[soft].shape.get());
      ++soft;
    }
  }
  return ways;
}

/// One a body, of the points that name that body.
std::vector<vtkBoundingBox> BoundsOfBodies(vtkDataSet* shapes)
{
  std::vector<vtkBoundingBox> bounds;
  vtkDataArray* const bodies = shapes ? shapes->GetPointData()->GetArray(vtkHapticMechanismArray::Body) : nullptr;
  for (vtkIdType point = 0; bodies && point < shapes->GetNumberOfPoints(); ++point)
  {
    const auto body = static_cast<std::size_t>(std::max(bodies->GetComponent(point, 0), 0.0));
    bounds.resize(std::max(bounds.size(), body + 1));
    bounds[body].AddPoint(shapes->GetPoint(point));
  }
  return bounds;
}

/// The numbers of a constraint, as a person reads them: "1.5 N, drags 0.4 N".
std::string NumbersOf(const palpate::MechanismConstraint& law, double unit_m)
{
  std::ostringstream all;
  const auto say = [&all](bool is, const char* before, double value, const char* unit)
  {
    if (is && std::isfinite(value))
    {
      all << (all.tellp() > 0 ? ", " : "") << before << value << unit;
    }
  };
  say(true, "", law.strength_N, " N");
  say(law.dryFriction_N > 0.0, "drags ", law.dryFriction_N, " N");
  say(law.friction > 0.0, "friction ", law.friction, "");
  say(true, "tears at ", law.tear_N, " N");
  say(true, "", law.stiffness_N_per_u / unit_m, " N/m");
  say(true, "from ", law.least_u, " u");
  say(true, "to ", law.most_u, " u");
  return all.str();
}

/// Constraints that join two points hold with any force, and none: they are never open.
const char* PhaseOf(const palpate::MechanismConstraint& law, palpate::ConstraintPhase phase)
{
  using enum palpate::ConstraintKind;
  const bool joins = law.kind == Attachment || law.kind == Break || law.kind == Hinge || law.kind == Slider;
  const auto shown = joins && phase == palpate::ConstraintPhase::Open ? palpate::ConstraintPhase::Closed : phase;
  return Phases[static_cast<std::size_t>(shown)];
}

void AddNames(vtkTable& table, const char* name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> column;
  column->SetName(name);
  for (const std::string& value : values)
  {
    column->InsertNextValue(value);
  }
  table.AddColumn(column);
}

void AddNumbers(vtkTable& table, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name);
  for (const double value : values)
  {
    column->InsertNextValue(value);
  }
  table.AddColumn(column);
}
} // namespace

void vtkHapticHeldMechanism::Choose(palpate::HapticSession& core) const
{
  core.choose<palpate::MechanismTask>({ this->Inputs, this->Name, this->Rate_Hz });
}

std::string vtkHapticHeldMechanism::Convert(vtkDataObject* data, const std::string& reason)
{
  this->File = vtkHapticIsMechanism(data) ? vtkHapticMechanismFileOf(*data) : "";
  this->Folder = vtkHapticIsMechanism(data) ? vtkHapticMechanismFolderOf(*data) : "";
  this->Vessel_W = vtkHapticIsMechanism(data) ? vtkHapticVesselOf(*data) : nullptr;
  this->Read.clear();
  this->AtRest.clear();
  this->Seen = {};
  auto* const shapes = vtkDataSet::SafeDownCast(data);
  this->Bounds = shapes ? vtkBoundingBox(shapes->GetBounds()) : vtkBoundingBox();
  this->BodyBounds = BoundsOfBodies(shapes);
  this->OfServer = data && vtkHapticIsOfServer(*data);
  this->Problem = data && this->File.empty() ? this->Name + " is not a mechanism: choose the output of Haptic Mechanism"
                  : !reason.empty()          ? this->Name + " cannot be held: " + reason
                                             : "";
  if (data && !this->File.empty() && !vtkHapticIsWhereMade(*data))
  {
    this->File.clear(); // it would be felt where its scene file has it
    this->Problem = this->Name +
                    " cannot be held: it was moved away from the position of its scene file; hold the Haptic "
                    "Mechanism itself, and move bodies in that file";
  }
  return this->TakeAgain();
}

std::string vtkHapticHeldMechanism::TakeAgain()
{
  this->Inputs = nullptr;
  this->Felt = false;
  if (this->File.empty())
  {
    return this->Problem;
  }
  const vtkHapticMechanismResult read =
    vtkHapticParseMechanism(this->File, this->Folder, this->Constraints, this->Read, this->Vessel_W);
  this->Inputs = read.Inputs;
  this->Read = read.Inputs ? read.Inputs->soft : this->Read;
  this->Held = read.Inputs && this->HeldBody() < read.Inputs->mechanism.bodies.size()
                 ? vtkHapticHeldShape(read.Inputs->mechanism.bodies[this->HeldBody()])
                 : nullptr;
  if (this->IsWire()) // most of which is in its sheath, far behind
  {
    this->Bounds = this->MetBounds();
  }
  this->Problem = read.Inputs ? "" : this->Name + " cannot be held: " + read.Problem;
  if (!read.Inputs && this->OfServer)
  {
    this->Problem += "; the mechanism comes from a server, but the files of its bodies are read on the client: copy "
                     "them to the same folder on the client";
  }
  return this->Problem;
}

bool vtkHapticHeldMechanism::BeginAgain()
{
  if (this->Inputs)
  {
    this->Inputs = std::make_shared<const palpate::MechanismInputs>(*this->Inputs); // other inputs are another order
    this->Felt = false;
  }
  return this->Inputs != nullptr;
}

/// The last one, as a plan has it; as many as there are bodies: none.
std::size_t vtkHapticHeldMechanism::HeldBody() const
{
  const auto& bodies = this->Inputs->mechanism.bodies;
  const auto isHeld = [](const auto& body) { return body.kind == palpate::MechanismBodyKind::Held; };
  const auto found = std::find_if(bodies.rbegin(), bodies.rend(), isHeld);
  return found != bodies.rend() ? static_cast<std::size_t>(bodies.rend() - found) - 1 : bodies.size();
}

std::optional<vtkHapticHeldAxis> vtkHapticHeldMechanism::Axis() const
{
  if (!this->Inputs || this->HeldBody() == this->Inputs->mechanism.bodies.size())
  {
    return std::nullopt;
  }
  const palpate::MechanismBody& rod = this->Inputs->mechanism.bodies[this->HeldBody()];
  return vtkHapticHeldAxis{ rod.length_u * palpate::Vec3::UnitZ(), palpate::Vec3::UnitZ(), rod.pose_W.q };
}

vtkBoundingBox vtkHapticHeldMechanism::MetBounds() const
{
  vtkBoundingBox met;
  for (std::size_t body = 0; this->Inputs && body < this->BodyBounds.size(); ++body)
  {
    const auto& bodies = this->Inputs->mechanism.bodies; // the vessel of a wire counts as one more
    if (body >= bodies.size() || !palpate::isInHand(bodies[body].kind))
    {
      met.AddBox(this->BodyBounds[body]);
    }
  }
  return met;
}

std::string vtkHapticHeldMechanism::RefusalOf(const std::string& laws, const palpate::HapticSession& core)
{
  if (!this->Inputs || laws.empty()) // those of its scene file are taken as they are
  {
    return "";
  }
  const vtkHapticMechanismResult read =
    vtkHapticParseMechanism(this->File, this->Folder, laws, this->Read, this->Vessel_W);
  if (!read.Inputs)
  {
    return read.Problem;
  }
  if (this->AtRest.size() != this->Read.size())
  {
    std::string problem;
    const auto bodies = palpate::MechanismBodies::make(this->Read, problem);
    this->AtRest = bodies ? bodies->first() : palpate::BodiesAtRest();
  }
  const bool sound = core.refuseMechanism(*this->Inputs, this->AtRest).empty();
  return sound ? core.refuseMechanism(*read.Inputs, this->AtRest) : "";
}

std::string vtkHapticHeldMechanism::With(const std::string& law, std::string& problem) const
{
  problem = "no mechanism is held: hold a mechanism before adding a constraint";
  return this->File.empty() ? "" : vtkHapticWithConstraint(this->File, this->Constraints, law, problem);
}

std::string vtkHapticHeldMechanism::Without(const std::string& name, std::string& problem) const
{
  problem = "no mechanism is held: hold a mechanism before removing a constraint";
  return this->File.empty() ? "" : vtkHapticWithoutConstraint(this->File, this->Constraints, name, problem);
}

int vtkHapticHeldMechanism::IndexOf(const std::string& name) const
{
  if (!this->Inputs)
  {
    return -1;
  }
  const auto& laws = this->Inputs->mechanism.laws;
  const auto found = std::find_if(laws.begin(), laws.end(), [&name](const auto& law) { return law.name == name; });
  return found != laws.end() ? static_cast<int>(found - laws.begin()) : -1;
}

void vtkHapticHeldMechanism::Look(palpate::HapticSession& core, const palpate::HapticState& state, double /*now_s*/)
{
  this->Status = this->Inputs ? core.status<palpate::MechanismTask>() : palpate::MechanismStatus(); // else of a tool
  this->Felt = !this->Status.building && this->Status.plan != 0 && state.mechanism.revision == this->Status.plan;
  this->Now = this->Felt ? state.mechanism : palpate::MechanismNow{};
  this->AtRest = !this->Status.building && this->Status.plan != 0 && this->Inputs ? this->Status.atRest : this->AtRest;
  if (this->Felt && this->Inputs)
  {
    this->Seen = { this->Now.held, this->Now.pose_W, this->Status.soft, this->Status.wire_W };
    vtkHapticPutPose(this->Now.held ? state.proxy_W : palpate::Pose{}, this->Pose);
    vtkHapticPutPose(this->Now.hand_W, this->HandPose);
  }
  else if (!this->Status.building && this->Status.plan == 0) // nor will any be
  {
    this->Seen = {};
  }
  const auto pushing = [](const palpate::ConstraintReport& law) { return law.force_N > 0.0; };
  const bool pushes = std::any_of(this->Now.laws.begin(), this->Now.laws.begin() + this->Now.lawCount, pushing);
  const bool changes = !this->Felt && this->Seen.Held; // of constraints, and it is unknown which of them push
  this->Begin_W = pushes || changes ? this->Begin_W : state.device_W.p;
  this->Depth = this->Status.check.wire
                  ? this->Now.wire.pushed_u
                  : (state.device_W.p - this->Begin_W).dot(state.proxy_W.q * palpate::Vec3::UnitZ());
  std::copy_n(this->Now.wire.wall_W.data(), 3, this->WallPlace);
}

std::string vtkHapticHeldMechanism::Sentence(palpate::HapticSession& core, const palpate::HapticState& /*state*/) const
{
  return this->FeltText(core.running()) +
         (this->DrawnElsewhere
             ? "; its touched position is that of the scene file, not of the display: reset the display transform, "
               "and move bodies in that file"
             : "");
}

const char* vtkHapticHeldMechanism::Absent() const
{
  return " does not exist, or has read no mechanism: repair or replace the source, or choose none";
}

const palpate::Vec3* vtkHapticHeldMechanism::SoftHand_W() const
{
  return this->Seen.Held && !this->Seen.Soft.empty() ? &this->Seen.Soft.front().shape->hand_W : nullptr;
}

bool vtkHapticHeldMechanism::IsWire() const
{
  return this->Inputs &&
         std::ranges::any_of(this->Inputs->mechanism.bodies, [](const auto& body) { return body.wire != nullptr; });
}

std::string vtkHapticHeldMechanism::FeltText(bool runs) const
{
  if (!this->Status.problem.empty())
  {
    return this->Name + " cannot be touched: " + this->Status.problem;
  }
  const bool wire = this->IsWire();
  const std::string laws =
    this->Name + ": " +
    (wire ? "a wire's beams" : std::to_string(this->Inputs->mechanism.laws.size()) + " constraints");
  if (!runs)
  {
    return wire ? this->Name + ": a wire" : laws;
  }
  if (!this->Felt)
  {
    return laws + (this->Seen.Held ? " are being computed; the previous ones apply until then"
                                   : " are being computed; there is no force until then");
  }
  std::string text = this->Name;
  for (const std::string& line : vtkHapticMechanismText(*this->Inputs, this->Status.check))
  {
    text += (text == this->Name ? ": " : "; ") + line;
  }
  for (const palpate::BodyPair& pair : this->Status.overlaps)
  {
    text += "; now " + palpate::overlapText(pair);
  }
  if (wire)
  {
    return text + vtkHapticHeldWireText(this->Now);
  }
  text +=
    this->Now.ahead ? "; the hand is faster than contacts are looked for, so that the held mesh stays behind" : "";
  text += this->Now.leftOut > 0 ? "; the held mesh touches in more places than a tick can solve" : "";
  return text + (this->Now.capped ? "; the constraints were not satisfied within the work of a tick" : "");
}

bool vtkHapticHeldMechanism::Move(vtkPolyData& shapes) const
{
  vtkDataArray* const bodies = shapes.GetPointData()->GetArray(vtkHapticMechanismArray::Body);
  vtkDataArray* const vertices = shapes.GetPointData()->GetArray(vtkHapticMechanismArray::Vertex);
  if (!this->Seen.Held || !this->Inputs || !bodies || !vertices)
  {
    return false;
  }
  const std::vector<Way> ways = WaysOf(*this->Inputs, this->Seen.Pose_W, this->Seen.Soft, this->Seen.Wire_W);
  vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  moved->DeepCopy(shapes.GetPoints());
  const auto gone = Vectors(vtkHapticMechanismArray::Displacement, moved->GetNumberOfPoints());
  const auto dented = Vectors(vtkHapticMechanismArray::Dent, moved->GetNumberOfPoints());
  for (vtkIdType point = 0; point < moved->GetNumberOfPoints(); ++point)
  {
    const auto body = static_cast<std::size_t>(bodies->GetComponent(point, 0));
    const Way way = body < ways.size() ? ways[body] : Way{};
    const palpate::Vec3 gone_u = Of(way.Soft.Displacement, vertices->GetComponent(point, 0));
    const palpate::Vec3 dent_u = Of(way.Soft.Dent, vertices->GetComponent(point, 0));
    const palpate::Vec3 to_W = way.Rigid * palpate::Vec3(shapes.GetPoint(point)) + gone_u + dent_u;
    moved->SetPoint(point, to_W.data());
    gone->SetTuple(point, gone_u.data());
    dented->SetTuple(point, dent_u.data());
  }
  shapes.SetPoints(moved);
  shapes.GetPointData()->AddArray(gone);
  shapes.GetPointData()->AddArray(dented);
  return true;
}

void vtkHapticHeldMechanism::FillTable(vtkTable& table) const
{
  std::vector<std::string> names, kinds, firsts, seconds, numbers, phases;
  std::vector<double> forces, insides;
  const auto laws = this->Inputs ? this->Inputs->mechanism.laws : std::vector<palpate::MechanismConstraint>();
  for (std::size_t i = 0; i < laws.size(); ++i)
  {
    const bool known = this->Now.held && i < static_cast<std::size_t>(this->Now.lawCount);
    const auto now = known ? this->Now.laws[i] : palpate::ConstraintReport{};
    names.push_back(laws[i].name);
    kinds.emplace_back(palpate::nameOf(laws[i].kind));
    firsts.push_back(laws[i].a);
    seconds.push_back(laws[i].b);
    numbers.push_back(NumbersOf(laws[i], this->Inputs->unit_m));
    phases.emplace_back(known ? PhaseOf(laws[i], now.phase) : "");
    forces.push_back(now.force_N);
    insides.push_back(now.inside_u);
  }
  table.Initialize();
  AddNames(table, "Constraint", names);
  AddNames(table, "Kind", kinds);
  AddNames(table, "A", firsts);
  AddNames(table, "B", seconds);
  AddNames(table, "Numbers", numbers);
  AddNames(table, "Phase", phases);
  AddNumbers(table, "Force", forces);
  AddNumbers(table, "Inside", insides);
}
