// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticHeldMechanism.h"

#include <algorithm>
#include <array>
#include <utility>

#include "haptics/session/settings/Setting.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkHapticMechanismData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace
{
constexpr std::array Phases = { "open", "closed", "slips", "inside", "gone" };

/// Where each body has gone from where it was at first: a held one was at the origin.
palpate::Pose WayOf(const palpate::MechanismBody& body, const palpate::Pose& now_W)
{
  const palpate::Quat turn = now_W.q * body.pose_W.q.conjugate();
  return { now_W.p - turn * body.pose_W.p, turn };
}

bool IsMoved(palpate::MechanismBodyKind kind)
{
  return kind == palpate::MechanismBodyKind::Held || kind == palpate::MechanismBodyKind::Rigid;
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

std::string vtkHapticHeldMechanism::Take(const std::string& name, vtkDataObject* data)
{
  this->Name = name;
  this->File = vtkHapticIsMechanism(data) ? vtkHapticMechanismFileOf(*data) : "";
  this->Folder = vtkHapticIsMechanism(data) ? vtkHapticMechanismFolderOf(*data) : "";
  this->OfServer = data && vtkHapticIsOfServer(*data);
  this->Inputs = nullptr;
  this->Problem = data && this->File.empty() ? name + " is no mechanism: choose the output of Haptic Mechanism" : "";
  return this->TakeAgain();
}

std::string vtkHapticHeldMechanism::TakeAgain()
{
  const std::shared_ptr<const palpate::MechanismInputs> before = std::exchange(this->Inputs, nullptr);
  if (this->File.empty())
  {
    return this->Problem;
  }
  const vtkHapticMechanismResult read = vtkHapticParseMechanism(this->File, this->Folder, this->Laws);
  this->Inputs = read.Inputs;
  if (read.Inputs && before) // the same bodies, which are factored already
  {
    auto inputs = std::make_shared<palpate::MechanismInputs>(*read.Inputs);
    inputs->soft = before->soft;
    this->Inputs = inputs;
  }
  this->Problem = read.Inputs ? "" : this->Name + " cannot be held: " + read.Problem;
  if (!read.Inputs && this->OfServer)
  {
    this->Problem += "; it is of a server: files of its bodies are read here, put them into the same folder here";
  }
  return this->Problem;
}

std::string vtkHapticHeldMechanism::With(const std::string& law, std::string& problem) const
{
  problem = "hold a mechanism first: there is none to add a law to";
  return this->File.empty() ? "" : vtkHapticWithLaw(this->File, this->Laws, law, problem);
}

std::string vtkHapticHeldMechanism::Without(const std::string& name, std::string& problem) const
{
  problem = "hold a mechanism first: there is none to take a law from";
  return this->File.empty() ? "" : vtkHapticWithoutLaw(this->File, this->Laws, name, problem);
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

void vtkHapticHeldMechanism::Follow(palpate::HapticSession& core, const palpate::HapticState& state)
{
  this->Now = core.running() ? state.mechanism : palpate::MechanismNow{};
  const auto pushing = [](const palpate::LawReport& law) { return law.force_N > 0.0; };
  const bool pushes = std::any_of(this->Now.laws.begin(), this->Now.laws.begin() + this->Now.lawCount, pushing);
  this->Begin_W = pushes ? this->Begin_W : state.device_W.p;
  this->Depth = (state.device_W.p - this->Begin_W).dot(state.proxy_W.q * palpate::Vec3::UnitZ());
  this->Text = this->Source.empty() ? "" : this->Sentence(core);
}

std::string vtkHapticHeldMechanism::Sentence(palpate::HapticSession& core) const
{
  if (!this->Problem.empty())
  {
    return this->Problem;
  }
  if (!this->Inputs)
  {
    return this->Source + " is not there: choose another source as the mechanism, or none";
  }
  const palpate::MechanismStatus status = core.running() ? core.mechanismStatus() : palpate::MechanismStatus{};
  if (!status.problem.empty())
  {
    return this->Name + " cannot be felt: " + status.problem;
  }
  if (!core.running())
  {
    return this->Name + ": " + std::to_string(this->Inputs->mechanism.laws.size()) + " laws";
  }
  if (!this->Now.held)
  {
    return this->Name + " is being computed, and not felt until then";
  }
  std::string text = this->Name;
  for (const std::string& line : vtkHapticMechanismText(*this->Inputs, status.check))
  {
    text += (text == this->Name ? ": " : "; ") + line;
  }
  return text + (this->Now.capped ? "; its laws were not met within a tick's work" : "");
}

bool vtkHapticHeldMechanism::Move(vtkPolyData& shapes) const
{
  vtkDataArray* const bodies = shapes.GetCellData()->GetArray("Body");
  if (!this->Now.held || !this->Inputs || !bodies)
  {
    return false;
  }
  const auto& all = this->Inputs->mechanism.bodies;
  vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  moved->DeepCopy(shapes.GetPoints());
  vtkNew<vtkIdList> corners;
  std::vector<bool> done(static_cast<std::size_t>(moved->GetNumberOfPoints()), false);
  for (vtkIdType cell = 0; cell < shapes.GetNumberOfCells(); ++cell)
  {
    const auto body = static_cast<std::size_t>(bodies->GetComponent(cell, 0));
    if (body >= all.size() || !IsMoved(all[body].kind))
    {
      continue;
    }
    const palpate::Pose way = WayOf(all[body], this->Now.pose_W[body]);
    shapes.GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const vtkIdType point = corners->GetId(i);
      if (!done[static_cast<std::size_t>(point)])
      {
        done[static_cast<std::size_t>(point)] = true;
        const palpate::Vec3 to_W = way.p + way.q * palpate::Vec3(shapes.GetPoint(point));
        moved->SetPoint(point, to_W.data());
      }
    }
  }
  shapes.SetPoints(moved);
  return true;
}

void vtkHapticHeldMechanism::FillTable(vtkTable& table) const
{
  std::vector<std::string> names, kinds, firsts, seconds, phases;
  std::vector<double> forces, insides;
  const auto laws = this->Inputs ? this->Inputs->mechanism.laws : std::vector<palpate::MechanismLaw>();
  for (std::size_t i = 0; i < laws.size(); ++i)
  {
    const bool known = this->Now.held && i < static_cast<std::size_t>(this->Now.lawCount);
    const auto now = known ? this->Now.laws[i] : palpate::LawReport{};
    names.push_back(laws[i].name);
    kinds.emplace_back(palpate::nameOf(laws[i].kind));
    firsts.push_back(laws[i].a);
    seconds.push_back(laws[i].b);
    phases.emplace_back(known ? Phases[static_cast<std::size_t>(now.phase)] : "");
    forces.push_back(now.force_N);
    insides.push_back(now.inside_u);
  }
  table.Initialize();
  AddNames(table, "Law", names);
  AddNames(table, "Kind", kinds);
  AddNames(table, "A", firsts);
  AddNames(table, "B", seconds);
  AddNames(table, "Phase", phases);
  AddNumbers(table, "Force", forces);
  AddNumbers(table, "Inside", insides);
}
