// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticTouchAs.h"

#include "vtkAlgorithm.h"
#include "vtkHapticAskedField.h"
#include "vtkHapticClosedLevel.h"
#include "vtkHapticColourRange.h"
#include "vtkHapticNamedData.h"
#include "vtkHapticSession.h"
#include "vtkHapticSourceParts.h"
#include "vtkHapticTouchedMechanism.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

vtkStandardNewMacro(vtkHapticTouchAs);

namespace
{
/// As the filter Tube has it.
constexpr double radiusOfSide = 0.01;
/// Enough to be led, and little enough to leave the streamline.
constexpr double follow_N = 2.0;
constexpr std::array<const char*, 3> HandedSettings = { "ToolSource", "SoftSource", "MechanismSource" };

void Put(vtkSMProxy* session, const char* property, const std::string& text)
{
  vtkSMPropertyHelper(session, property).Set(text.c_str());
}

void Put(vtkSMProxy* session, const char* property, double number)
{
  vtkSMPropertyHelper(session, property).Set(number);
}

std::string TextOf(vtkSMProxy* session, const char* property)
{
  return vtkSMPropertyHelper(session, property).GetAsString();
}

bool Is(vtkSMProxy* proxy, std::string_view name)
{
  return proxy->GetXMLName() && proxy->GetXMLName() == name;
}

/// Made to be held by its origin.
bool IsToolSource(vtkSMProxy* source)
{
  constexpr int hole = 1, nut = 3; // which stay where they are
  const bool shape = Is(source, "HapticToolShape");
  const int which = shape ? vtkSMPropertyHelper(source, "Shape").GetAsInt() : 0;
  return Is(source, "HapticNeedle") || (shape && which != hole && which != nut);
}

/// "0.25": two digits tell radii and values apart.
double Rounded(double value)
{
  std::ostringstream text;
  text.precision(2);
  text << value;
  return std::stod(text.str());
}

std::optional<vtkHapticTouchKind> KindOf(std::string_view name)
{
  constexpr std::array kinds = { "surface", "lines", "field", "tool", "tissue", "mechanism" };
  const auto found = std::find(kinds.begin(), kinds.end(), name);
  return found == kinds.end() ? std::nullopt
                              : std::optional(static_cast<vtkHapticTouchKind>(std::distance(kinds.begin(), found)));
}

void UpdateAt(vtkSMSourceProxy* source, vtkSMProxy* view)
{
  if (source)
  {
    source->UpdatePipeline(view ? vtkSMPropertyHelper(view, "ViewTime").GetAsDouble() : 0.0);
  }
}

bool DrawsNoSurface(vtkSMProxy* representation)
{
  const std::string type = representation ? TextOf(representation, "Representation") : "";
  return type == "Volume" || type == "Slice" || type == "Outline";
}
} // namespace

vtkHapticTouchAs::vtkHapticTouchAs() = default;

vtkHapticTouchAs::~vtkHapticTouchAs() = default;

void vtkHapticTouchAs::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Session: " << this->Session << "\n";
  os << indent << "View: " << this->View << "\n";
  os << indent << "Text: " << this->Text << "\n";
}

void vtkHapticTouchAs::SetSession(vtkSMProxy* session)
{
  this->Session = session;
}

void vtkHapticTouchAs::SetView(vtkSMProxy* view)
{
  this->View = view;
}

std::string vtkHapticTouchAs::GetLikely(vtkSMProxy* source)
{
  auto* const made = vtkSMSourceProxy::SafeDownCast(source);
  UpdateAt(made, this->View);
  const vtkHapticSourceParts parts = vtkHapticPartsOf(made);
  auto* const view = vtkSMViewProxy::SafeDownCast(this->View);
  vtkSMProxy* const drawn = view && made ? view->FindRepresentation(made, 0) : nullptr;
  const bool inside = parts.Solid && parts.Arrays && (DrawsNoSurface(drawn) || (!drawn && !parts.Faces));
  return parts.Mechanism                ? "mechanism"
         : parts.Body                   ? "tissue"
         : made && IsToolSource(source) ? "tool"
         : inside                       ? "field"
         : parts.Faces                  ? "surface"
         : parts.Lines                  ? "lines"
                                        : "";
}

bool vtkHapticTouchAs::Touch(vtkSMProxy* source, const char* kindName)
{
  constexpr std::array<void (vtkHapticTouchAs::*)(), 6> steps = { &vtkHapticTouchAs::TouchSurface,
    &vtkHapticTouchAs::TouchLines, &vtkHapticTouchAs::TouchField, &vtkHapticTouchAs::HoldTool,
    &vtkHapticTouchAs::PressTissue, &vtkHapticTouchAs::HoldMechanism };
  this->Source = vtkSMSourceProxy::SafeDownCast(source);
  this->Name = vtkHapticNameOf(source);
  if (!this->Session || !this->Source || this->Name.empty())
  {
    this->Text = "There is no source to touch: choose one in the pipeline browser.";
    return false;
  }
  const std::string_view asked = kindName ? kindName : "";
  const std::optional<vtkHapticTouchKind> kind = KindOf(asked);
  if (!kind && asked != "not at all")
  {
    this->Text = this->Name + (asked.empty() ? " has nothing that can be touched."
                                             : " cannot be touched as " + std::string(asked) +
                                                 "; the kinds are surface, lines, field, tool, tissue, mechanism and "
                                                 "not at all.");
    return false;
  }
  UpdateAt(this->Source, this->View);
  const vtkHapticSourceParts parts = vtkHapticPartsOf(this->Source);
  if (const std::string misfit = kind ? vtkHapticMisfit(parts, *kind) : ""; !misfit.empty())
  {
    this->Text = this->Name + " " + misfit + ".";
    return false;
  }
  this->Free();
  (this->*(kind ? steps[static_cast<std::size_t>(*kind)] : &vtkHapticTouchAs::LeaveOut))();
  this->Session->UpdateVTKObjects();
  return true;
}

void vtkHapticTouchAs::Free()
{
  for (const char* const setting : HandedSettings)
  {
    if (TextOf(this->Session, setting) == this->Name)
    {
      Put(this->Session, setting, "");
    }
  }
  if (TextOf(this->Session, "FeltSource") == this->Name)
  {
    for (const char* const setting : { "FeltSource", "FieldArray", "FieldVectors", "FieldResistance" })
    {
      Put(this->Session, setting, "");
    }
  }
  this->Session->UpdateVTKObjects();
  if (auto* const session = vtkHapticSession::SafeDownCast(this->Session->GetClientSideObject()))
  {
    session->SetSourceTouched(this->Name.c_str(), true);
    session->GetMechanism()->SetDensity(this->Name.c_str(), 0.0);
  }
}

/// A tool and a soft body are felt together, a mechanism by itself.
void vtkHapticTouchAs::Take(const char* setting)
{
  const auto isMechanism = [](std::string_view name) { return name == "MechanismSource"; };
  for (const char* const other : HandedSettings)
  {
    const std::string before = TextOf(this->Session, other);
    if (isMechanism(setting) != isMechanism(other) && !before.empty())
    {
      this->Text += " " + before + " is let go.";
      Put(this->Session, other, "");
    }
  }
  Put(this->Session, setting, this->Name);
}

vtkSMProxy* vtkHapticTouchAs::Representation() const
{
  auto* const view = vtkSMViewProxy::SafeDownCast(this->View);
  return view ? view->FindRepresentation(this->Source, 0) : nullptr;
}

void vtkHapticTouchAs::Show(bool shown)
{
  auto* const view = vtkSMViewProxy::SafeDownCast(this->View);
  if (view)
  {
    vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
    shown ? (void)controller->Show(this->Source, 0, view) : (void)controller->Hide(this->Source, 0, view);
    view->StillRender();
  }
}

void vtkHapticTouchAs::TouchSurface()
{
  this->Show(true);
  if (vtkSMProxy* const drawn = this->Representation(); DrawsNoSurface(drawn))
  {
    vtkSMRepresentationProxy::SetRepresentationType(drawn, "Surface");
    drawn->UpdateVTKObjects();
    vtkSMViewProxy::SafeDownCast(this->View)->StillRender();
  }
  this->Text = this->Name + " is touched as surface.";
}

double vtkHapticTouchAs::LongestSide() const
{
  double bounds[6];
  this->Source->GetDataInformation(0)->GetBounds(bounds);
  return std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
}

void vtkHapticTouchAs::TouchLines()
{
  this->Show(true);
  const auto* const session = vtkHapticSession::SafeDownCast(this->Session->GetClientSideObject());
  const bool walls = session && session->GetRaisesLines();
  if (!walls && vtkSMPropertyHelper(this->Session, "LineRadius").GetAsDouble() == 0.0)
  {
    Put(this->Session, "LineRadius", Rounded(radiusOfSide * this->LongestSide()));
  }
  std::ostringstream text;
  text << this->Name << " is touched as lines";
  walls ? text << " that are walls."
        : text << " with a radius of " << vtkSMPropertyHelper(this->Session, "LineRadius").GetAsDouble() << " u.";
  this->Text = text.str();
}

std::vector<std::string> vtkHapticTouchAs::ArraysOf(int components) const
{
  auto* const here = vtkAlgorithm::SafeDownCast(this->Source->GetClientSideObject());
  vtkHapticViewScan::Source source{ this->Name };
  source.Data = here ? here->GetOutputDataObject(0) : nullptr;
  source.Remote = here ? nullptr : this->Source;
  return vtkHapticArraysOfSource(source, components);
}

std::string vtkHapticTouchAs::FieldArray() const
{
  constexpr int any = 0, scalar = 1;
  const std::vector<std::string> all = this->ArraysOf(any), scalars = this->ArraysOf(scalar);
  const std::string coloured = vtkHapticColourMapOf(this->Representation()).Array;
  const bool has = std::find(all.begin(), all.end(), coloured) != all.end();
  return has ? coloured : scalars.empty() ? all.front() : scalars.front();
}

double vtkHapticTouchAs::MiddleOf(const std::string& array) const
{
  vtkPVDataInformation* const data = this->Source->GetDataInformation(0);
  vtkPVArrayInformation* const ofPoints = data->GetArrayInformation(array.c_str(), vtkDataObject::POINT);
  vtkPVArrayInformation* const found =
    ofPoints ? ofPoints : data->GetArrayInformation(array.c_str(), vtkDataObject::CELL);
  double range[2] = { 0.0, 0.0 };
  if (found)
  {
    found->GetComponentRange(0, range);
  }
  return 0.5 * (range[0] + range[1]);
}

/// Half of the largest opacity, or the middle of the values where the array colours nothing.
vtkHapticTouchAs::Level vtkHapticTouchAs::LevelOf(const std::string& array) const
{
  const vtkHapticColourMap map = vtkHapticColourMapOf(this->Representation());
  const bool coloured = map.Array == array && map.High > map.Low;
  const double seen = coloured ? map.Opaque : this->MiddleOf(array);
  auto* const here = vtkAlgorithm::SafeDownCast(this->Source->GetClientSideObject());
  const bool free = here && !(coloured && map.Drawn);
  return { seen, free ? vtkHapticClosedLevel(here->GetOutputDataObject(0), array, seen) : seen };
}

void vtkHapticTouchAs::FollowStreamlines(const std::string& array)
{
  Put(this->Session, "FieldArray", "");
  Put(this->Session, "FieldVectors", array);
  if (vtkSMPropertyHelper(this->Session, "FieldFollow").GetAsDouble() == 0.0)
  {
    Put(this->Session, "FieldFollow", follow_N);
  }
  std::ostringstream text;
  text << this->Name << " is touched as field: the hand follows " << array << " with "
       << vtkSMPropertyHelper(this->Session, "FieldFollow").GetAsDouble() << " N.";
  this->Text = text.str();
}

void vtkHapticTouchAs::FeelIsosurface(const std::string& array)
{
  Put(this->Session, "FieldVectors", "");
  Put(this->Session, "FieldArray", array);
  Put(this->Session, "FieldIsosurface", 1.0);
  const Level level = this->LevelOf(array);
  Put(this->Session, "FieldIsovalue", level.Felt);
  std::ostringstream text;
  text << this->Name << " is touched as field: its isosurface at " << array << " = " << level.Felt;
  if (level.Felt != level.Seen)
  {
    text << ", as the isosurface at " << level.Seen << " is open where the data end";
  }
  text << ".";
  this->Text = text.str();
}

void vtkHapticTouchAs::TouchField()
{
  this->Show(true);
  const std::string array = this->FieldArray();
  constexpr int vector = 3;
  const std::vector<std::string> vectors = this->ArraysOf(vector);
  Put(this->Session, "FeltSource", this->Name);
  std::find(vectors.begin(), vectors.end(), array) == vectors.end() ? this->FeelIsosurface(array)
                                                                    : this->FollowStreamlines(array);
}

void vtkHapticTouchAs::HoldTool()
{
  this->Show(false); // the tool is drawn at its pose instead
  this->Text = this->Name + " is held as tool.";
  this->Take("ToolSource");
  if (IsToolSource(this->Source))
  {
    constexpr int originOfItsData = 1;
    Put(this->Session, "ToolHandle", originOfItsData);
  }
}

void vtkHapticTouchAs::PressTissue()
{
  this->Show(true);
  this->Text = this->Name + " is pressed as tissue.";
  this->Take("SoftSource");
}

void vtkHapticTouchAs::HoldMechanism()
{
  this->Show(true);
  this->Text = this->Name + " is held as mechanism.";
  Put(this->Session, "MechanismConstraints", ""); // those of another mechanism would not fit
  this->Take("MechanismSource");
}

void vtkHapticTouchAs::LeaveOut()
{
  if (auto* const session = vtkHapticSession::SafeDownCast(this->Session->GetClientSideObject()))
  {
    session->SetSourceTouched(this->Name.c_str(), false);
  }
  this->Text = this->Name + " is not touched.";
}
