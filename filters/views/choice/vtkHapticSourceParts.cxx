// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSourceParts.h"

#include "vtkAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkHapticFieldData.h"
#include "vtkHapticMechanismData.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkHapticVtkVersions.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPolyData.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <string_view>

namespace
{
void AddPolyData(vtkPolyData& data, vtkHapticSourceParts& parts)
{
  parts.Faces = parts.Faces || data.GetNumberOfPolys() + data.GetNumberOfStrips() > 0;
  parts.Lines = parts.Lines || data.GetNumberOfLines() > 0;
}

/// One cell that fills space is enough; all cells of an image or of a curvilinear grid have the same dimension.
void AddCells(vtkDataSet& data, vtkHapticSourceParts& parts)
{
  const bool mixed = data.IsA("vtkUnstructuredGrid");
  const vtkIdType cells = mixed ? data.GetNumberOfCells() : std::min<vtkIdType>(data.GetNumberOfCells(), 1);
  for (vtkIdType cell = 0; cell < cells && !parts.Solid; ++cell)
  {
    const int dimension = vtkHapticCellDimension(static_cast<unsigned char>(data.GetCellType(cell)));
    parts.Solid = dimension == 3;
    parts.Faces = parts.Faces || dimension >= 2;
    parts.Lines = parts.Lines || dimension == 1;
  }
}

vtkHapticSourceParts PartsHere(vtkDataObject* data)
{
  vtkHapticSourceParts parts;
  for (vtkDataSet* const set : vtkHapticFieldSets(data))
  {
    parts.Known = parts.Known || set->GetNumberOfPoints() > 0;
    if (auto* const poly = vtkPolyData::SafeDownCast(set))
    {
      AddPolyData(*poly, parts);
    }
    else
    {
      AddCells(*set, parts);
    }
  }
  parts.Arrays = !vtkHapticFieldArrayNames(data).empty();
  parts.Body = vtkHapticIsSoftBody(data);
  parts.Mechanism = vtkHapticIsMechanism(data);
  return parts;
}

vtkHapticSourceParts PartsThere(vtkSMSourceProxy& source)
{
  vtkPVDataInformation* const data = source.GetDataInformation(0);
  vtkHapticSourceParts parts;
  parts.Known = data && data->GetNumberOfPoints() > 0;
  if (parts.Known)
  {
    const bool poly = data->GetDataSetType() == VTK_POLY_DATA;
    parts.Faces = true;
    parts.Lines = poly;
    parts.Solid = !poly;
    parts.Arrays = data->GetPointDataInformation()->GetNumberOfArrays() > 0 ||
                   data->GetCellDataInformation()->GetNumberOfArrays() > 0;
    const std::string_view made = source.GetXMLName();
    parts.Body = made == "HapticSoftBody";
    parts.Mechanism = made == "HapticMechanism" || made == "HapticWire";
  }
  return parts;
}
} // namespace

vtkHapticSourceParts vtkHapticPartsOf(vtkSMSourceProxy* source)
{
  if (!source || source->GetNumberOfOutputPorts() == 0)
  {
    return {};
  }
  auto* const here = vtkAlgorithm::SafeDownCast(source->GetClientSideObject());
  return here ? PartsHere(here->GetOutputDataObject(0)) : PartsThere(*source);
}

std::string vtkHapticMisfit(const vtkHapticSourceParts& parts, vtkHapticTouchKind kind)
{
  if (!parts.Known)
  {
    return {};
  }
  switch (kind)
  {
    case vtkHapticTouchKind::Surface:
      return parts.Faces ? "" : "has no faces; apply a filter that makes a surface, for example Tube or Glyph";
    case vtkHapticTouchKind::Lines:
      return parts.Lines ? "" : "has no lines; apply a filter that makes lines, for example Stream Tracer or Contour";
    case vtkHapticTouchKind::Field:
      return !parts.Solid    ? "has no cells that fill space; a field needs a volume"
             : !parts.Arrays ? "has no array; a field needs numbers at points or cells"
                             : "";
    case vtkHapticTouchKind::Tool:
      return parts.Mechanism ? "is a mechanism; hold it as a mechanism"
             : parts.Faces   ? ""
                             : "has no faces; a tool needs a surface";
    case vtkHapticTouchKind::Tissue:
      return parts.Body ? "" : "has no material; apply the filter Soft Body and press its result";
    case vtkHapticTouchKind::Mechanism:
      return parts.Mechanism ? "" : "is no mechanism; open one with Sources > Haptics > Haptic Mechanism";
  }
  return {};
}
