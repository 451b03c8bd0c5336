// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticAskedField.h"

#include "vtkHapticNamedData.h"
#include "vtkHapticRemoteField.h"
#include "vtkHapticSession.h"
#include "vtkSMPropertyHelper.h"

#include <algorithm>

namespace
{
/// Those that are asked for and have to be in one data set.
std::vector<std::string> NamesOf(const vtkHapticSession& session)
{
  std::vector<std::string> names{ session.GetSettingText("FieldArray"), session.GetSettingText("FieldVectors"),
    session.GetSettingText("FieldResistance") };
  if (*session.GetSettingText("CompareSource") == '\0')
  {
    names.emplace_back(session.GetSettingText("FieldOther"));
  }
  std::erase(names, "");
  return names;
}
} // namespace

bool vtkHapticAsksForField(const vtkHapticSession& session)
{
  return *session.GetSettingText("FieldArray") != '\0' || *session.GetSettingText("FieldVectors") != '\0' ||
         *session.GetSettingText("FieldResistance") != '\0';
}

std::vector<std::string> vtkHapticArraysOfSource(const vtkHapticViewScan::Source& source, int components)
{
  return source.Data ? vtkHapticFieldArrayNames(source.Data, components)
                     : vtkHapticRemoteArrayNames(source.Remote, source.Port, components);
}

namespace
{
/// Whether a source has all arrays that the session names; an array to compare with only where that is in the same
/// data.
bool HasArrays(const vtkHapticViewScan::Source& source, const vtkHapticSession& session)
{
  const std::vector<std::string> names = NamesOf(session), has = vtkHapticArraysOfSource(source);
  return std::all_of(names.begin(), names.end(),
    [&has](const std::string& name) { return std::find(has.begin(), has.end(), name) != has.end(); });
}

/// Why no source that could be is felt.
std::string LackOf(const vtkHapticSession& session)
{
  const std::string chosen = session.GetSettingText("FeltSource");
  std::string list;
  for (const std::string& name : NamesOf(session))
  {
    list += (list.empty() ? "\"" : ", \"") + name + "\"";
  }
  return (chosen.empty() ? "no visible source" : chosen) + " has " + (chosen.empty() ? "" : "not ") + list +
         ", for the field";
}
} // namespace

std::vector<vtkHapticViewScan::Source> vtkHapticSourcesOfField(
  const vtkHapticSession& session, vtkSMProxy* view, const std::vector<vtkHapticViewScan::Source>& shown)
{
  const std::string chosen = session.GetSettingText("FeltSource");
  if (chosen.empty())
  {
    return shown;
  }
  const auto drawn =
    std::find_if(shown.begin(), shown.end(), [&](const auto& source) { return source.Name == chosen; });
  if (drawn != shown.end())
  {
    return { *drawn };
  }
  const vtkHapticViewScan::Source named = vtkHapticNamedSource(view, chosen);
  return named.Data || named.Remote ? std::vector{ named } : std::vector<vtkHapticViewScan::Source>();
}

vtkHapticFieldCandidates vtkHapticCandidatesOfField(
  const vtkHapticSession& session, vtkSMProxy* view, const std::vector<vtkHapticViewScan::Source>& shown)
{
  vtkHapticFieldCandidates candidates;
  if (!vtkHapticAsksForField(session))
  {
    return candidates;
  }
  const std::string chosen = session.GetSettingText("FeltSource");
  const std::vector<vtkHapticViewScan::Source> sources = vtkHapticSourcesOfField(session, view, shown);
  candidates.Refusal = !sources.empty()  ? LackOf(session)
                       : !chosen.empty() ? chosen + ": no source with data has this name"
                                         : "";
  for (const vtkHapticViewScan::Source& source : sources)
  {
    const bool has = HasArrays(source, session) && session.GetSourceTouched(source.Name.c_str());
    if (has && source.Moved)
    {
      candidates.Refusal =
        source.Name +
        " is transformed in the view, but its data are not: use the filter Transform, or reset the display transform";
    }
    else if (has)
    {
      candidates.Sources.push_back(source);
    }
  }
  candidates.Refusal = candidates.Sources.empty() ? candidates.Refusal : "";
  return candidates;
}

vtkHapticFieldKey vtkHapticKeyOfField(const vtkHapticViewScan::Source& source, vtkSMProxy* view)
{
  return source.Data
           ? vtkHapticFieldKey{ source.Data, 0, static_cast<double>(source.Data->GetMTime()) }
           : vtkHapticFieldKey{ source.Remote, source.Port, vtkSMPropertyHelper(view, "ViewTime").GetAsDouble() };
}

vtkHapticFieldArrays vtkHapticArraysOfSession(const vtkHapticSession& session)
{
  vtkHapticFieldArrays arrays;
  arrays.Scalar = session.GetSettingText("FieldArray");
  arrays.Vector = session.GetSettingText("FieldVectors");
  arrays.Resistance = session.GetSettingText("FieldResistance");
  arrays.Other = session.GetSettingText("FieldOther");
  arrays.Component = static_cast<int>(session.GetSetting("FieldComponent"));
  arrays.Eigenvector = static_cast<int>(session.GetSetting("FieldEigenvector"));
  arrays.Smoothing = static_cast<int>(session.GetSetting("FieldSmoothing"));
  return arrays;
}
