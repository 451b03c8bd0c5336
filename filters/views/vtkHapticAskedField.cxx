// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticAskedField.h"

#include "vtkHapticFieldData.h"
#include "vtkHapticSession.h"

#include <algorithm>
#include <vector>

namespace
{
/// Those that are asked for and have to be in one data set.
std::vector<std::string> NamesOf(const vtkHapticSession& session)
{
  std::vector<std::string> names{ session.GetFieldArray(), session.GetFieldVectors(), session.GetFieldResistance() };
  if (*session.GetCompareSource() == '\0')
  {
    names.emplace_back(session.GetFieldOther());
  }
  std::erase(names, "");
  return names;
}
} // namespace

bool vtkHapticAsksForField(const vtkHapticSession& session)
{
  return *session.GetFieldArray() != '\0' || *session.GetFieldVectors() != '\0' ||
         *session.GetFieldResistance() != '\0';
}

bool vtkHapticHasFieldArrays(vtkDataObject* data, const vtkHapticSession& session)
{
  const std::vector<std::string> names = NamesOf(session), has = vtkHapticFieldArrayNames(data);
  return std::all_of(names.begin(), names.end(),
    [&has](const std::string& name) { return std::find(has.begin(), has.end(), name) != has.end(); });
}

std::string vtkHapticLackOfField(const vtkHapticSession& session)
{
  std::string list;
  for (const std::string& name : NamesOf(session))
  {
    list += (list.empty() ? "\"" : ", \"") + name + "\"";
  }
  return "nothing that is shown has " + list + ", to be felt as a field";
}
