// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkTouchAlongPath.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/field/Smoothing.h"
#include "haptics/session/path/PathTouch.h"
#include "haptics/session/scene/TouchedData.h"
#include "vtkHapticConversion.h"
#include "vtkHapticHandPath.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticMechanismData.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkHapticTickRows.h"
#include "vtkHapticTouchedField.h"
#include "vtkHapticWholeInput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkTouchAlongPath);

namespace
{
/// Ticks between two looks at progress and abort.
constexpr std::size_t ReportEvery = 1000;

/// Triangles, and lines if they have a radius, with their material; none with a problem.
std::vector<palpate::SurfaceInput> ReadInputs(
  vtkDataObject* surface, const vtkHapticMaterialSettings& settings, double lineRadius_u, std::string& problem)
{
  std::vector<palpate::SurfaceInput> inputs;
  std::vector<std::string> ofArrays;
  const auto fieldsOf = [&](const vtkHapticConversionResult& read)
  {
    vtkHapticMaterialResult material = vtkHapticToMaterial(surface, read.PartPoints, settings);
    ofArrays.push_back(material.Problem);
    return material.Fields;
  };
  if (lineRadius_u > 0.0)
  {
    const vtkHapticConversionResult lines = vtkHapticToLines(surface);
    if (lines.Mesh)
    {
      const palpate::LineSurface tubes = palpate::tubesOf({ "surface", lines.Mesh, fieldsOf(lines) }, lineRadius_u);
      if (!tubes.input)
      {
        problem = tubes.problem;
        return {};
      }
      inputs.push_back(*tubes.input);
    }
  }
  const vtkHapticConversionResult faces = vtkHapticToMesh(surface);
  problem = faces.Problem;
  if (faces.Mesh)
  {
    inputs.push_back({ "surface", faces.Mesh, palpate::Material(), fieldsOf(faces) });
  }
  if (!inputs.empty()) // one of both may be without an array, as a block of composite data may
  {
    const bool any = std::any_of(ofArrays.begin(), ofArrays.end(), [](const auto& text) { return text.empty(); });
    problem = any ? "" : ofArrays.front();
  }
  return inputs;
}

/// Of a path that lies on one rank, or a problem.
vtkHapticHandPath PathOf(vtkDataObject* piece, const vtkHapticPathArrays& arrays)
{
  auto* const whole = vtkPolyData::SafeDownCast(piece);
  vtkHapticHandPath path;
  path.Problem = "it lies in pieces on several ranks; give it whole on one of them.";
  return whole ? vtkHapticReadHandPath(whole, arrays) : path;
}

/// The surface as a scene; null with a problem.
std::shared_ptr<const palpate::Scene> BuildScene(
  vtkDataObject* surface, const vtkHapticMaterialSettings& settings, double lineRadius_u, std::string& problem)
{
  const std::vector<palpate::SurfaceInput> inputs = ReadInputs(surface, settings, lineRadius_u, problem);
  if (!problem.empty())
  {
    return nullptr;
  }
  const palpate::WholeScene whole = palpate::wholeScene(inputs);
  problem = whole.refusal;
  return whole.scene;
}

/// One tick a point; false if `goes` asked to stop. `fault` receives the first one. The orientation of the hand plays
/// no part for a ball.
template<class Goes>
bool Touch(const vtkHapticHandPath& path, const palpate::WorkspaceMap& map, palpate::PathTouch& touch,
  vtkHapticTickRows& rows, palpate::Fault& fault, Goes goes)
{
  for (std::size_t i = 0; i < path.Points_W.size(); ++i)
  {
    if (i % ReportEvery == 0 && !goes(static_cast<double>(i) / static_cast<double>(path.Points_W.size())))
    {
      return false;
    }
    const palpate::HapticState state =
      touch.next(path.Times[i], { map.toDevice(path.Points_W[i]), palpate::Quat::Identity() });
    fault = fault == palpate::Fault::None ? state.fault : fault;
    rows.Set(i, { state.proxy_W.p, path.Points_W[i], state.force_W, state.contacts, path.Times[i] });
  }
  return true;
}
} // namespace

vtkTouchAlongPath::vtkTouchAlongPath()
  : Materials(std::make_unique<vtkHapticMaterialSettings>()), Field(std::make_unique<vtkHapticTouchedField>())
{
  this->SetNumberOfInputPorts(6);
}

vtkTouchAlongPath::~vtkTouchAlongPath()
{
  this->SetTimeArray(nullptr);
  this->SetTurnArray(nullptr);
}

void vtkTouchAlongPath::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Stiffness: " << this->Stiffness << " N/m\n";
  os << indent << "Radius: " << this->Radius << " u\n";
  os << indent << "LineRadius: " << this->LineRadius << " u\n";
  os << indent << "FrictionStatic: " << this->FrictionStatic << "\n";
  os << indent << "FrictionKinetic: " << this->FrictionKinetic << "\n";
  os << indent << "ForceShading: " << this->ForceShading << "\n";
  os << indent << "StiffnessArray: " << this->GetStiffnessArray() << "\n";
  os << indent << "FrictionArray: " << this->GetFrictionArray() << "\n";
  os << indent << "TextureArray: " << this->GetTextureArray() << "\n";
  os << indent << "FieldArray: " << this->GetFieldArray() << "\n";
  os << indent << "FieldVectors: " << this->GetFieldVectors() << "\n";
  os << indent << "Scale: " << this->Scale << " u/m\n";
  os << indent << "Rate: " << this->Rate << " Hz\n";
  os << indent << "TimeArray: " << (this->TimeArray ? this->TimeArray : "(none)") << "\n";
  os << indent << "TurnArray: " << (this->TurnArray ? this->TurnArray : "(none)") << "\n";
  os << indent << "Lever: " << this->Lever << " u\n";
  os << indent << "VirtualCoupling: " << this->VirtualCoupling << "\n";
  os << indent << "LowRate: " << this->LowRate << " Hz\n";
}

void vtkTouchAlongPath::SetPathConnection(vtkAlgorithmOutput* path)
{
  this->SetInputConnection(1, path);
}

void vtkTouchAlongPath::SetPathData(vtkDataObject* path)
{
  this->SetInputDataObject(1, path);
}

int vtkTouchAlongPath::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 1 ? "vtkPolyData" : "vtkDataSet");
  if (port != 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  if (port > 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

palpate::HapticParameters vtkTouchAlongPath::Parameters() const
{
  palpate::HapticParameters parameters;
  parameters.stiffness_N_per_m = this->Stiffness;
  parameters.contact.radius_u = this->Radius;
  parameters.contact.friction = { this->FrictionStatic, this->FrictionKinetic };
  parameters.contact.shading = this->ForceShading;
  parameters.map.scale_u_per_m = this->Scale;
  parameters.field = this->Field->Plan();
  return parameters;
}

std::string vtkTouchAlongPath::CheckParameters() const
{
  std::string problem = this->Field->Check();
  problem = problem.empty() ? this->Parameters().validate() : problem;
  problem = problem.empty() ? this->Materials->Check() : problem;
  const bool rate = this->Rate > 0.0 && std::isfinite(this->Rate);
  const bool lines = this->LineRadius >= 0.0 && std::isfinite(this->LineRadius);
  problem = problem.empty() && !lines ? "the radius of lines must be a finite number, 0 or above" : problem;
  return problem.empty() && !rate ? "the rate must be a finite number of hertz above 0" : problem;
}

bool vtkTouchAlongPath::Goes(double progress)
{
  this->UpdateProgress(progress);
  return !this->CheckAbort();
}

std::unique_ptr<palpate::PathTouch> vtkTouchAlongPath::Prepare(vtkDataObject* input, vtkDataObject* field,
  const vtkHapticFieldBeside& beside, const vtkHapticHandPath& path, std::string& problem) const
{
  std::shared_ptr<const palpate::Scene> scene;
  const bool soft = vtkHapticToSoftBody(input).Input != nullptr;
  if (input != field && !soft)
  {
    scene = BuildScene(input, *this->Materials, this->LineRadius, problem);
    problem = scene ? "" : "The surface cannot be touched: " + problem;
  }
  vtkHapticFieldResult felt;
  if (field && problem.empty())
  {
    felt = vtkHapticToField(field, this->Field->Arrays, beside);
    problem = felt.Source ? palpate::levelProblem(this->Field->Plan(), felt.Ends) : felt.Problem;
    problem = problem.empty() ? "" : "The field cannot be felt: " + problem;
  }
  if (!field && problem.empty() && (beside.Compared || beside.Snap))
  {
    problem = "What is compared with and snapped to is beside a field, and none is felt: give FieldArray or Field";
  }
  if (!problem.empty())
  {
    return nullptr;
  }
  auto touch = std::make_unique<palpate::PathTouch>(scene, this->Parameters(), path.FirstDuration());
  touch->feel(felt.Source);
  if (soft)
  {
    this->Press(input, *touch, problem);
  }
  return problem.empty() ? std::move(touch) : nullptr;
}

int vtkTouchAlongPath::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  if (const std::string problem = this->CheckParameters(); !problem.empty())
  {
    vtkErrorMacro("Nothing was touched: " << problem);
    return 0;
  }
  vtkDataObject* const given = vtkDataObject::GetData(input[0]);
  vtkDataObject* const beside = vtkDataObject::GetData(input[2]);
  const vtkSmartPointer<vtkDataObject> surface = vtkHapticWholeSurface(given);
  const vtkSmartPointer<vtkDataObject> field = beside && beside != given             ? vtkHapticWholeSurface(beside)
                                               : beside || this->Field->IsAskedFor() ? surface
                                                                                     : nullptr;
  vtkDataObject* const held = vtkDataObject::GetData(input[3]);
  const vtkSmartPointer<vtkDataObject> tool = held ? vtkHapticWholeSurface(held) : nullptr;
  vtkDataObject *const other = vtkDataObject::GetData(input[4]), *const places = vtkDataObject::GetData(input[5]);
  const vtkSmartPointer<vtkDataObject> compared = other ? vtkHapticWholeSurface(other) : nullptr;
  const vtkSmartPointer<vtkDataObject> snap = places ? vtkHapticWholeSurface(places) : nullptr;
  const vtkSmartPointer<vtkDataObject> piece = vtkHapticOnePiece(vtkPolyData::GetData(input[1]));
  if (vtkHapticRank() > 0)
  {
    return 1; // one hand: the first rank has what it feels
  }
  const vtkHapticHandPath path = PathOf(piece, { this->TimeArray, this->TurnArray, this->Rate });
  if (!path.Problem.empty())
  {
    vtkErrorMacro("The path cannot be followed: " << path.Problem);
    return 0;
  }
  if (vtkHapticIsMechanism(given))
  {
    return this->TouchMechanism(*given, path, *vtkPolyData::GetData(output)) ? 1 : 0;
  }
  if (tool && vtkHapticToSoftBody(given).Input)
  {
    vtkErrorMacro("A tool does not feel what gives way: leave out the tool, or give the body's surface.");
    return 0;
  }
  if (tool)
  {
    return this->TouchWithTool(*surface, *tool, path, *vtkPolyData::GetData(output)) ? 1 : 0;
  }
  std::string problem;
  const auto touch = this->Prepare(surface, field, { compared, snap }, path, problem);
  if (!touch)
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  vtkHapticTickRows rows(path.Points_W.size());
  palpate::Fault fault = palpate::Fault::None;
  const auto goes = [this](double progress) { return this->Goes(progress); };
  if (Touch(path, this->Parameters().map, *touch, rows, fault, goes))
  {
    rows.MoveTo(vtkPolyData::GetData(output));
  }
  this->TellOf(*touch, fault);
  return 1;
}

void vtkTouchAlongPath::TellOf(const palpate::PathTouch& touch, palpate::Fault fault)
{
  if (const std::string nothing = touch.whyNothingOfField(); !nothing.empty())
  {
    vtkWarningMacro("Nothing was felt of the field: " << nothing);
  }
  if (const std::string lattice = touch.latticeSentence(); !lattice.empty())
  {
    vtkWarningMacro("Of the field: " << lattice);
  }
  if (const std::string detent = touch.detentSentence(); !detent.empty())
  {
    vtkWarningMacro("FieldDetent: " << detent);
  }
  const palpate::MadeBrick& made = touch.madeBrick();
  const palpate::FieldSmoothness& smooth = made.smoothness;
  if (smooth.noise > palpate::trappingNoise && !(made.brick && made.brick->cells()))
  {
    vtkWarningMacro("The field's noise of " << smooth.noise << " of a spacing traps a hand: it was smoothed once, and "
                                            << "FieldSmoothing 0 leaves it as it is");
  }
  if (touch.body())
  {
    this->TellOfBody(*touch.body());
  }
  if (fault != palpate::Fault::None)
  {
    vtkWarningMacro("Without force from some point on: " << palpate::describe(fault));
  }
}
