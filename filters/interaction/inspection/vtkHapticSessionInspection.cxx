// SPDX-License-Identifier: GPL-3.0-or-later
// The data at the contact.
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "haptics/geometry/measure/ContactPlace.h"
#include "vtkHapticContactState.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"

namespace
{
using palpate::Vec3;

constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();

void AddVector(vtkHapticMarkRecord& record, const std::string& name, const Vec3& v)
{
  const char* const axes[] = { "X", "Y", "Z" };
  for (int k = 0; k < 3; ++k)
  {
    record.Numbers.emplace_back(name + axes[k], v[k]);
  }
}

/// The felt surface may be a simpler one: the place is that on the data themselves.
void Replace(vtkHapticMarkRecord& record, const Vec3& p_W)
{
  for (int k = 0; k < 3; ++k)
  {
    record.Numbers[k].second = p_W[k]; // X, Y and Z come first
  }
}

void AddPlace(vtkHapticMarkRecord& record, const palpate::ContactPlace& place)
{
  AddVector(record, "", place.p_W);
  AddVector(record, "Normal", place.normal_W);
  record.Numbers.emplace_back("CurvatureLargest", place.curvature ? place.curvature->largest_per_u : NotKnown);
  record.Numbers.emplace_back("CurvatureLeast", place.curvature ? place.curvature->least_per_u : NotKnown);
  record.Numbers.emplace_back("Thickness", place.thickness_u.value_or(NotKnown));
}

void AddProbed(vtkHapticMarkRecord& record, const vtkHapticProbed& probed)
{
  record.Numbers.emplace_back("Cell", static_cast<double>(probed.Cell));
  record.Numbers.emplace_back("Point", static_cast<double>(probed.Point));
  for (const auto& [name, value] : probed.Values)
  {
    const bool taken = !std::isnan(record.Number(name)) || name == vtkHapticMarkRecords::NameColumn; // one of ours
    record.Numbers.emplace_back(taken ? name + " (array)" : name, value);
  }
}

std::string Described(const vtkHapticMarkRecord& contact)
{
  std::ostringstream text;
  text << contact.Source << ": cell " << contact.Number("Cell") << ", point " << contact.Number("Point") << " at ("
       << contact.Number("X") << ", " << contact.Number("Y") << ", " << contact.Number("Z") << ")";
  if (!std::isnan(contact.Number("CurvatureLargest")))
  {
    text << "; curvature " << contact.Number("CurvatureLargest") << " and " << contact.Number("CurvatureLeast")
         << " a unit";
  }
  if (!std::isnan(contact.Number("Thickness")))
  {
    text << "; wall of " << contact.Number("Thickness") << " units";
  }
  return text.str();
}

/// Numbers that were found in arrays come last.
std::string ArraysOf(const vtkHapticMarkRecord& contact)
{
  std::ostringstream text;
  bool ofArray = false;
  for (const auto& [name, value] : contact.Numbers)
  {
    if (ofArray)
    {
      text << name << " = " << value << "\n";
    }
    ofArray = ofArray || name == "Point";
  }
  return text.str();
}
} // namespace

std::optional<vtkHapticMarkRecord> vtkHapticSession::Internals::LookAtContact()
{
  const auto& scene = this->Scene.built().scene;
  if (!this->Contact.Last || !scene)
  {
    return std::nullopt;
  }
  const palpate::HapticState& touched = *this->Contact.Last;
  const auto place = this->PlaceOfContact(touched);
  if (!place)
  {
    return std::nullopt;
  }
  const auto origin = this->Surfaces.OriginOf(place->surface);
  vtkHapticMarkRecord record{ origin ? origin->Name : place->surface, {} };
  AddPlace(record, *place);
  record.Numbers.emplace_back("Depth", (touched.proxy_W.p - touched.device_W.p).norm());
  record.Numbers.emplace_back("Force", touched.force_W.norm());
  if (origin)
  {
    const vtkHapticProbed probed = this->Contact.Probe.Look(origin->Data, origin->Placement.inverse() * place->p_W);
    AddProbed(record, probed);
    Replace(record, probed.Cell < 0 ? place->p_W : Vec3(origin->Placement * probed.Nearest));
  }
  return record;
}

void vtkHapticSession::Internals::ShowContact(std::optional<vtkHapticMarkRecord> contact)
{
  this->Contact.Found = std::move(contact);
  this->Contact.Text = this->Contact.Found ? Described(*this->Contact.Found) : "";
  this->Contact.Arrays = this->Contact.Found ? ArraysOf(*this->Contact.Found) : "";
  const auto show = [this](const std::string& name)
  { return this->Contact.Found ? this->Contact.Found->Number(name) : 0.0; };
  const char* const axes[] = { "X", "Y", "Z" };
  for (int k = 0; k < 3; ++k)
  {
    this->Contact.Position[k] = show(axes[k]);
    this->Contact.Normal[k] = show(std::string("Normal") + axes[k]);
  }
  this->Contact.Curvature[0] = show("CurvatureLargest");
  this->Contact.Curvature[1] = show("CurvatureLeast");
}

bool vtkHapticSession::InspectContact()
{
  this->Impl->ShowContact(this->Impl->LookAtContact());
  return this->Impl->Contact.Found.has_value();
}

/// The touched surface is not there any more, or stands elsewhere.
void vtkHapticSession::Internals::ForgetContact()
{
  this->Contact.Last.reset();
  this->ShowContact(std::nullopt);
}

void vtkHapticSession::Internals::FollowContact()
{
  if (this->State.contacts > 0)
  {
    this->Contact.Last = this->State;
  }
  const std::uint32_t down = this->State.buttons;
  const std::uint32_t wentDown = down & ~std::exchange(this->Contact.MarkButtons, down);
  const int button = this->Settings.whole("MarkButton");
  if (button > 0 && (wentDown >> (button - 1) & 1u) != 0)
  {
    this->Session.AddMark();
  }
  else if (this->Settings.isOn("Inspect") && this->State.contacts > 0)
  {
    this->Session.InspectContact();
  }
}
