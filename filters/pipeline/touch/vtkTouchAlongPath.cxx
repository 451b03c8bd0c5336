// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkTouchAlongPath.h"

#include <cmath>
#include <limits>
#include <utility>

#include "haptics/session/path/PathRunner.h"
#include "haptics/session/settings/SessionSettings.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkHapticConversion.h"
#include "vtkHapticHandPath.h"
#include "vtkHapticMechanismData.h"
#include "vtkHapticPathData.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkHapticWholeInput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkTouchAlongPath);

namespace
{
enum Port
{
  Surfaces,
  Path,
  Field,
  Tool,
  Compared,
  Snap,
  Loose,
  PortCount
};

/// Name in sentences of the data of each port that has no name of its own.
constexpr const char* PortNames[PortCount] = { "the surface", "the path", "the field", "the tool", "the compared data",
  "the snap targets", "the loose body" };

/// The name of ParaView's property for a setting, where it has another name.
std::string PropertyOf(std::string_view setting)
{
  return setting == "SoftRate"       ? "LowRate"
         : setting == "ToolLever"    ? "Lever"
         : setting == "ToolCoupling" ? "VirtualCoupling"
                                     : std::string(setting);
}

/// The output while it grows: the path of the proxy as a polyline, one row a tick.
class Rows
{
public:
  Rows(std::size_t count, const std::vector<palpate::PathColumn>& columns, bool withCost)
    : Count(static_cast<vtkIdType>(count)), Columns(columns)
  {
    this->Points->SetDataTypeToDouble();
    this->Points->SetNumberOfPoints(this->Count);
    this->Add(this->Force, "Force", 3);
    this->Add(this->Depth, "Depth", 1);
    this->Add(this->Contacts, "Contacts", 1);
    this->Add(this->Device, "Device", 3);
    this->Add(this->Time, "Time", 1);
    for (const palpate::PathColumn& column : columns)
    {
      this->More.emplace_back();
      this->Add(this->More.back(), column.name.c_str(), column.components);
    }
    if (withCost)
    {
      this->Add(this->Cost, "Cost", 1);
    }
  }

  void Set(std::size_t row, const palpate::PathSample& sample, const palpate::PathTick& tick)
  {
    const auto i = static_cast<vtkIdType>(row);
    const palpate::Vec3 &proxy_W = tick.proxy_W.p, &hand_W = sample.hand_W.p;
    this->Points->SetPoint(i, proxy_W.data());
    this->Force->SetTuple(i, tick.wrench_W.force.data());
    this->Depth->SetValue(i, (proxy_W - hand_W).norm());
    this->Contacts->SetValue(i, tick.contacts);
    this->Device->SetTuple(i, hand_W.data());
    this->Time->SetValue(i, sample.time_s);
    const double* values = tick.more.data();
    for (std::size_t column = 0; column < this->More.size(); ++column)
    {
      this->More[column]->SetTuple(i, values);
      values += this->Columns[column].components;
    }
    if (this->Cost->GetNumberOfTuples() > 0)
    {
      this->Cost->SetValue(i, tick.cost_us);
    }
  }

  void MoveTo(vtkPolyData& output)
  {
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(static_cast<int>(this->Count));
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      lines->InsertCellPoint(i);
    }
    output.SetPoints(this->Points);
    output.SetLines(lines);
    for (vtkDataArray* const array : this->All)
    {
      output.GetPointData()->AddArray(array);
    }
  }

private:
  void Add(vtkDataArray* array, const char* name, int components)
  {
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(this->Count);
    this->All.push_back(array);
  }

  vtkIdType Count;
  std::vector<palpate::PathColumn> Columns;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Force, Depth, Device, Time, Cost;
  vtkNew<vtkIntArray> Contacts;
  std::vector<vtkNew<vtkDoubleArray>> More; ///< of the columns
  std::vector<vtkDataArray*> All;
};
} // namespace

vtkTouchAlongPath::vtkTouchAlongPath()
  : Settings(std::make_unique<palpate::SettingStore>(palpate::pathSettings())),
    Report(std::make_unique<palpate::PathReport>())
{
  this->SetNumberOfInputPorts(PortCount);
}

vtkTouchAlongPath::~vtkTouchAlongPath()
{
  this->SetTimeArray(nullptr);
  this->SetTurnArray(nullptr);
}

void vtkTouchAlongPath::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const palpate::Setting& setting : palpate::sessionSettings())
  {
    const palpate::SettingValue& value = this->Settings->of(setting.name);
    if (palpate::isOfPath(setting))
    {
      os << indent << setting.name << ": " << value.text;
      for (const double number : value.numbers)
      {
        os << number << " ";
      }
      os << setting.unit << "\n";
    }
  }
  os << indent << "Rate: " << this->Rate << " Hz\n";
  os << indent << "TimeArray: " << (this->TimeArray ? this->TimeArray : "(none)") << "\n";
  os << indent << "TurnArray: " << (this->TurnArray ? this->TurnArray : "(none)") << "\n";
  os << indent << "NoSpeed: " << this->NoSpeed << "\n";
  os << indent << "Density: " << this->Density << " kg/m3\n";
  os << indent << "WithCost: " << this->WithCost << "\n";
}

/// Values that cannot be are an error when the filter runs.
void vtkTouchAlongPath::Put(const char* name, const palpate::SettingValue& value)
{
  const palpate::Setting* const setting = palpate::findSetting(name ? name : "");
  if (!setting || !palpate::isOfPath(*setting) || setting->defaults.size() != value.numbers.size())
  {
    vtkErrorMacro(
      "No setting " << (name ? name : "(none)") << " of a path has " << value.numbers.size() << " numbers.");
  }
  else if (this->Settings->of(name) != value)
  {
    this->Settings->put(name, value);
    this->Modified();
  }
}

void vtkTouchAlongPath::SetSetting(const char* name, double value)
{
  this->Put(name, { { value }, {} });
}

void vtkTouchAlongPath::SetSetting(const char* name, int value)
{
  this->SetSetting(name, static_cast<double>(value));
}

void vtkTouchAlongPath::SetSetting(const char* name, double low, double high)
{
  this->Put(name, { { low, high }, {} });
}

void vtkTouchAlongPath::SetSetting(const char* name, double x, double y, double z)
{
  this->Put(name, { { x, y, z }, {} });
}

void vtkTouchAlongPath::SetSetting(const char* name, const char* text)
{
  this->Put(name, { {}, text ? text : "" });
}

void vtkTouchAlongPath::SetSettings(const palpate::SettingStore& settings)
{
  *this->Settings = settings;
  this->Modified();
}

double vtkTouchAlongPath::GetSetting(const char* name) const
{
  return this->GetSettingSize(name) > 0 ? this->Settings->number(name) : std::numeric_limits<double>::quiet_NaN();
}

int vtkTouchAlongPath::GetSettingSize(const char* name) const
{
  const palpate::Setting* const setting = palpate::findSetting(name ? name : "");
  return setting ? static_cast<int>(setting->defaults.size()) : 0;
}

std::string vtkTouchAlongPath::GetSettingNames()
{
  std::string names;
  for (const palpate::Setting& setting : palpate::sessionSettings())
  {
    names += palpate::isOfPath(setting) ? std::string(setting.name) + " " : "";
  }
  return names;
}

void vtkTouchAlongPath::AddNamed(int port, const std::string& name, vtkDataObject* data)
{
  this->AddInputDataObject(port, data);
  this->Names[port].push_back(name);
}

std::string vtkTouchAlongPath::NameOf(int port, std::size_t connection) const
{
  const auto names = this->Names.find(port);
  return names != this->Names.end() && connection < names->second.size() ? names->second[connection] : PortNames[port];
}

int vtkTouchAlongPath::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == Port::Path ? "vtkPolyData" : "vtkDataSet");
  if (port != Port::Path)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  if (port == Surfaces)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  if (port > Port::Path)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

bool vtkTouchAlongPath::FeelsField() const
{
  return vtkHapticFieldArraysOf(*this->Settings).Any() || palpate::isOn(palpate::pathParameters(*this->Settings).field);
}

void vtkTouchAlongPath::ReadTouched(
  vtkDataObject& data, const std::string& name, palpate::PathInputs& inputs, std::string& problem) const
{
  if (auto body = vtkHapticToSoftBody(&data).Input)
  {
    problem = inputs.body ? name + ": soft body besides " + inputs.body->name + "; use one soft body at a time" : "";
    inputs.body = palpate::PathBody{ name, std::move(body) };
    return;
  }
  const bool curves = palpate::areWalls(*this->Settings) || this->Settings->number("LineRadius") > 0.0;
  for (palpate::PathSurface& surface :
    vtkHapticToPathSurfaces(data, name, vtkHapticMaterialsOf(*this->Settings), curves, problem))
  {
    inputs.surfaces.push_back(std::move(surface));
  }
  problem = problem.empty() ? "" : name + ": cannot be touched: " + problem;
}

/// The data of all ports; null where there are none.
struct vtkTouchAlongPath::WholeInputs
{
  explicit WholeInputs(vtkInformationVector** input)
  {
    for (int i = 0; i < input[Surfaces]->GetNumberOfInformationObjects(); ++i)
    {
      this->Touched.push_back(vtkHapticWholeSurface(vtkDataObject::GetData(input[Surfaces], i)));
    }
    vtkDataObject* const field = vtkDataObject::GetData(input[Port::Field]);
    const bool same = field && field == vtkDataObject::GetData(input[Surfaces]);
    this->Field = same ? this->Touched.front() : this->Whole(field);
    this->Tool = this->Whole(vtkDataObject::GetData(input[Port::Tool]));
    this->Compared = this->Whole(vtkDataObject::GetData(input[Port::Compared]));
    this->Snap = this->Whole(vtkDataObject::GetData(input[Port::Snap]));
    this->Loose = this->Whole(vtkDataObject::GetData(input[Port::Loose]));
    this->Path = vtkHapticOnePiece(vtkPolyData::GetData(input[Port::Path]));
  }

  static vtkSmartPointer<vtkDataObject> Whole(vtkDataObject* piece)
  {
    return piece ? vtkHapticWholeSurface(piece) : nullptr;
  }

  std::vector<vtkSmartPointer<vtkDataObject>> Touched;
  vtkSmartPointer<vtkDataObject> Field, Tool, Compared, Snap, Loose, Path;
};

void vtkTouchAlongPath::ReadField(const WholeInputs& whole, palpate::PathInputs& inputs, std::string& problem) const
{
  if (!whole.Field && !this->FeelsField())
  {
    problem = whole.Compared || whole.Snap
                ? "compared data and snap targets need a field, but none is set: set {FieldArray} or Field"
                : "";
    return;
  }
  vtkDataObject* const data = whole.Field ? whole.Field : whole.Touched.front();
  vtkHapticFieldResult felt =
    vtkHapticToField(data, vtkHapticFieldArraysOf(*this->Settings), { whole.Compared, whole.Snap });
  const std::string name = this->NameOf(whole.Field ? Port::Field : Surfaces, 0);
  problem = felt.Source ? "" : name + ": cannot be rendered as a field: " + felt.Problem;
  inputs.field = palpate::PathField{ name, std::move(felt.Source), felt.Ends, this->NoSpeed };
}

palpate::PathInputs vtkTouchAlongPath::Read(const WholeInputs& whole, vtkDataObject& given, std::string& problem) const
{
  palpate::PathInputs inputs;
  inputs.settings = *this->Settings;
  auto* const path = vtkPolyData::SafeDownCast(whole.Path);
  problem = "the data are distributed over several ranks; gather the data on one rank";
  if (path)
  {
    inputs.path = vtkHapticReadHandPath(*path, { this->TimeArray, this->TurnArray, this->Rate }, problem);
  }
  problem = problem.empty() ? "" : this->NameOf(Port::Path, 0) + ": cannot be used as a path: " + problem;
  const bool rate = this->Rate > 0.0 && std::isfinite(this->Rate);
  const bool speeds =
    this->NoSpeed == 0.0 || (this->NoSpeed > 0.0 && this->NoSpeed < this->Settings->number("FieldFullSpeed"));
  problem = !rate    ? "Rate: must be a finite number of hertz above 0"
            : speeds ? problem
                     : "NoSpeed: it has to be 0, or above 0 and below {FieldFullSpeed}";
  problem = problem.empty() ? palpate::refusePathSettings(*this->Settings) : problem;
  if (problem.empty() && vtkHapticIsMechanism(&given))
  {
    const vtkHapticMechanismResult read = vtkHapticToMechanism(given);
    inputs.mechanism = palpate::PathMechanism{ this->NameOf(Surfaces, 0), read.Inputs };
    problem = !read.Problem.empty()          ? read.Problem
              : !vtkHapticIsWhereMade(given) ? "the mechanism was moved away from the position of its scene file: use "
                                               "Haptic Mechanism itself, and move bodies in that file"
                                             : "";
  }
  else if (problem.empty())
  {
    this->ReadField(whole, inputs, problem);
  }
  const bool first = !inputs.mechanism && !(inputs.field && (!whole.Field || whole.Field == whole.Touched.front()));
  for (std::size_t i = first ? 0 : 1; i < whole.Touched.size() && problem.empty(); ++i)
  {
    this->ReadTouched(*whole.Touched[i], this->NameOf(Surfaces, i), inputs, problem);
  }
  if (whole.Loose && problem.empty())
  {
    vtkHapticAddLoose(*whole.Loose, this->NameOf(Port::Loose, 0), this->Density, inputs, problem);
  }
  if (whole.Tool && problem.empty())
  {
    const vtkHapticConversionResult held = vtkHapticToMesh(whole.Tool);
    inputs.tool = palpate::PathTool{ this->NameOf(Port::Tool, 0), held.Mesh };
    problem = held.Mesh ? "" : inputs.tool->name + ": cannot be held: " + held.Problem;
  }
  return inputs;
}

bool vtkTouchAlongPath::Follow(palpate::PathRunner& runner, std::size_t count, vtkPolyData& output)
{
  Rows rows(count, runner.columns(), this->WithCost);
  const auto goes = [this](double progress)
  {
    this->UpdateProgress(progress);
    return !this->CheckAbort();
  };
  const auto take = [&rows](std::size_t row, const palpate::PathSample& sample, const palpate::PathTick& tick)
  { rows.Set(row, sample, tick); };
  if (!runner.run(goes, take))
  {
    return false;
  }
  rows.MoveTo(output);
  return true;
}

int vtkTouchAlongPath::Tell()
{
  const auto said = [](const std::string& text) { return palpate::withNames(text, PropertyOf); };
  if (!this->Report->refusal.empty())
  {
    vtkErrorMacro("Nothing was touched: " << said(this->Report->refusal));
    return 0;
  }
  if (!this->Report->unfelt.empty())
  {
    vtkWarningMacro("The field had no effect: " << this->Report->unfelt);
  }
  for (const std::string& note : this->Report->notes)
  {
    vtkWarningMacro(<< said(note));
  }
  return 1;
}

int vtkTouchAlongPath::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  const WholeInputs whole(input);
  if (vtkHapticRank() > 0)
  {
    return 1; // one hand: the first rank has its forces
  }
  *this->Report = {};
  palpate::PathInputs inputs = this->Read(whole, *vtkDataObject::GetData(input[Surfaces]), this->Report->refusal);
  if (!this->Report->refusal.empty())
  {
    return this->Tell();
  }
  const std::size_t count = inputs.path.size();
  palpate::PathRunner runner(std::move(inputs));
  const bool done = runner.report().refusal.empty() && this->Follow(runner, count, *vtkPolyData::GetData(output));
  *this->Report = runner.report();
  if (done && runner.body() && runner.body()->shape().mostGradient > vtkHapticStrain::Small)
  {
    this->Report->notes.push_back(
      "at the end of the path the largest strain is " + vtkHapticStrainText(runner.body()->shape()));
  }
  return this->Tell();
}
