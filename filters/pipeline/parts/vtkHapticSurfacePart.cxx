// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSurfacePart.h"

#include <algorithm>

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

namespace
{
constexpr const char* Numbers = "Palpate part";
constexpr const char* Version = "Palpate version";

/// Puts or gets all numbers, so that each is named once.
template<class Stream, class Info>
void Each(const Stream& stream, Info& info)
{
  stream(info.Number);
  stream(info.CellsOfAll);
  stream(info.Whole);
  stream(info.Reach);
  std::for_each(info.Centre.begin(), info.Centre.end(), stream);
  std::for_each(info.Bounds.begin(), info.Bounds.end(), stream);
}

constexpr vtkIdType NumbersInAll = 13;
} // namespace

void vtkHapticTellPart(const vtkHapticPartInfo& info, vtkDataObject* data)
{
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName(Numbers);
  Each([&numbers](const auto& value) { numbers->InsertNextValue(static_cast<double>(value)); }, info);
  vtkNew<vtkStringArray> version;
  version->SetName(Version);
  version->InsertNextValue(PALPATE_VERSION);
  data->GetFieldData()->AddArray(numbers);
  data->GetFieldData()->AddArray(version);
}

std::optional<vtkHapticPartInfo> vtkHapticPartOf(vtkDataObject* data)
{
  vtkFieldData* const fields = data ? data->GetFieldData() : nullptr;
  auto* const numbers = fields ? vtkDoubleArray::SafeDownCast(fields->GetArray(Numbers)) : nullptr;
  auto* const version = fields ? vtkStringArray::SafeDownCast(fields->GetAbstractArray(Version)) : nullptr;
  if (!numbers || !version || version->GetNumberOfValues() != 1)
  {
    return std::nullopt;
  }
  vtkHapticPartInfo info;
  info.Version = version->GetValue(0);
  if (numbers->GetNumberOfValues() == NumbersInAll)
  {
    vtkIdType next = 0;
    Each([&](auto& value) { value = static_cast<std::decay_t<decltype(value)>>(numbers->GetValue(next++)); }, info);
  }
  return info;
}

std::string vtkHapticOtherVersion(const std::string& version)
{
  const std::string load =
    "load the plugin Palpate " PALPATE_VERSION " on the server too (set PV_PLUGIN_PATH to its folder)";
  if (version == PALPATE_VERSION)
  {
    return "";
  }
  return version.empty() ? "the server does not answer: the connection is lost, or " + load
                         : "the server has the plugin Palpate " + version + ", and here is another: " + load;
}
