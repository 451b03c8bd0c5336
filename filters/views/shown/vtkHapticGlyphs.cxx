// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticGlyphs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include "haptics/core/Types.h"
#include "haptics/core/WordHash.h"
#include "vtkAppendPolyData.h"
#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkHapticConversion.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

namespace
{
using palpate::Vec3;
using Turn = Eigen::Quaterniond;

vtkDataArray* ArrayOf(vtkGlyph3DMapper& mapper, int which, vtkDataSet& data)
{
  vtkInformation* const wanted = mapper.GetInputArrayInformation(which);
  const char* const name = wanted->Get(vtkDataObject::FIELD_NAME());
  vtkPointData* const points = data.GetPointData();
  if (name)
  {
    return points->GetArray(name);
  }
  const bool byKind = wanted->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  return byKind ? points->GetAttribute(wanted->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE())) : nullptr;
}

double LengthOf(vtkDataArray& array, vtkIdType point)
{
  return vtkMath::Norm(array.GetTuple(point), array.GetNumberOfComponents());
}

/// About the z axis, then the turned x, then the turned y axis [degrees].
Turn TurnOfAngles(const double degrees[3])
{
  const auto about = [&](int axis)
  { return Eigen::AngleAxisd(degrees[axis] * std::numbers::pi / 180.0, Vec3::Unit(axis)); };
  return about(2) * about(0) * about(1);
}

/// That takes the x axis to a direction, by half a turn about the axis half way between.
Turn TurnTo(const Vec3& direction)
{
  if (direction[1] == 0.0 && direction[2] == 0.0)
  {
    return direction[0] < 0.0 ? Turn(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitY())) : Turn::Identity();
  }
  return Turn(Eigen::AngleAxisd(std::numbers::pi, (direction + direction.norm() * Vec3::UnitX()).normalized()));
}

/// How the mapper places the glyph of each point of a data set.
class Rule
{
public:
  Rule(vtkGlyph3DMapper& mapper, vtkDataSet& data)
    : Mapper(mapper), Data(data), Scale(mapper.GetScaling() ? this->Array(vtkGlyph3DMapper::SCALE) : nullptr),
      Direction(mapper.GetOrient() ? this->Array(vtkGlyph3DMapper::ORIENTATION) : nullptr),
      Index(mapper.GetSourceIndexing() ? this->Array(vtkGlyph3DMapper::SOURCE_INDEX) : nullptr),
      Mask(vtkBitArray::SafeDownCast(mapper.GetMasking() ? this->Array(vtkGlyph3DMapper::MASK) : nullptr))
  {
  }

  [[nodiscard]] bool Draws(vtkIdType point) const { return !this->Mask || this->Mask->GetValue(point) != 0; }

  /// Which of so many glyphs.
  [[nodiscard]] int GlyphAt(vtkIdType point, int glyphs) const
  {
    if (!this->Index)
    {
      return 0;
    }
    const double wanted = LengthOf(*this->Index, point);
    return std::isnan(wanted) ? 0 : static_cast<int>(std::clamp(wanted, 0.0, glyphs - 1.0));
  }

  [[nodiscard]] Eigen::Affine3d PlaceOf(vtkIdType point) const
  {
    Eigen::Affine3d place(Eigen::Translation3d(Vec3(this->Data.GetPoint(point))));
    place.rotate(this->TurnAt(point));
    return this->Mapper.GetScaling() ? place.scale(this->SizeAt(point)) : place;
  }

  /// Empty, or why the arrays do not say how.
  [[nodiscard]] std::string Problem() const
  {
    const int needed = this->Mapper.GetOrientationMode() == vtkGlyph3DMapper::QUATERNION ? 4 : 3;
    if (this->Direction && this->Direction->GetNumberOfComponents() != needed)
    {
      return "the orientation array of its glyphs has " + std::to_string(this->Direction->GetNumberOfComponents()) +
             " components instead of " + std::to_string(needed) + "; choose another one";
    }
    return {};
  }

private:
  vtkDataArray* Array(int which) const { return ArrayOf(this->Mapper, which, this->Data); }

  double RangeLength() const
  {
    const double length = this->Mapper.GetRange()[1] - this->Mapper.GetRange()[0];
    return length == 0.0 ? 1.0 : length;
  }

  Turn TurnAt(vtkIdType point) const
  {
    if (!this->Direction)
    {
      return Turn::Identity();
    }
    double o[4];
    this->Direction->GetTuple(point, o);
    switch (this->Mapper.GetOrientationMode())
    {
      case vtkGlyph3DMapper::ROTATION:
        return TurnOfAngles(o);
      case vtkGlyph3DMapper::QUATERNION:
        return Turn(o[0], o[1], o[2], o[3]).normalized();
      default:
        return TurnTo(Vec3(o));
    }
  }

  Vec3 DataSizeAt(vtkIdType point) const
  {
    const int mode = this->Scale ? this->Mapper.GetScaleMode() : vtkGlyph3DMapper::NO_DATA_SCALING;
    Vec3 size = Vec3::Ones();
    if (mode == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
    {
      size.setConstant(LengthOf(*this->Scale, point));
    }
    else if (mode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS && this->Scale->GetNumberOfComponents() == 3)
    {
      size = Vec3(this->Scale->GetTuple(point));
    }
    if (this->Mapper.GetClamping() && mode != vtkGlyph3DMapper::NO_DATA_SCALING)
    {
      const double* const range = this->Mapper.GetRange();
      size = (size.cwiseMax(range[0]).cwiseMin(range[1]).array() - range[0]) / this->RangeLength();
    }
    return size;
  }

  /// Never flat: nothing could be felt of it.
  Vec3 SizeAt(vtkIdType point) const
  {
    constexpr double nothing = 1e-10;
    const Vec3 size = this->Mapper.GetScaleFactor() * this->DataSizeAt(point);
    return size.unaryExpr([](double s) { return s == 0.0 ? nothing : s; });
  }

  vtkGlyph3DMapper& Mapper;
  vtkDataSet& Data;
  vtkDataArray* Scale;
  vtkDataArray* Direction;
  vtkDataArray* Index;
  vtkBitArray* Mask;
};

/// A glyph without strips, and with its polygons the other way round for places that mirror it.
struct Glyph
{
  vtkSmartPointer<vtkPolyData> Data;
  vtkNew<vtkCellArray> Mirrored;

  explicit Glyph(vtkPolyData* source) : Data(source)
  {
    if (source && source->GetNumberOfStrips() > 0)
    {
      vtkNew<vtkTriangleFilter> triangles;
      triangles->SetInputData(source);
      triangles->PassLinesOn();
      triangles->PassVertsOn();
      triangles->Update();
      this->Data = triangles->GetOutput();
    }
    if (this->Data)
    {
      this->Mirrored->DeepCopy(this->Data->GetPolys());
    }
    for (vtkIdType cell = 0; cell < this->Mirrored->GetNumberOfCells(); ++cell)
    {
      this->Mirrored->ReverseCellAtId(cell);
    }
  }
  [[nodiscard]] std::int64_t Cells() const { return this->Data ? this->Data->GetNumberOfCells() : 0; }
};

using Glyphs = std::vector<std::unique_ptr<Glyph>>;

/// All polygons and lines of a node of a table: poly data, or a composite of it that is drawn as one glyph.
vtkSmartPointer<vtkPolyData> WholeOf(vtkDataObject* node)
{
  vtkNew<vtkAppendPolyData> whole;
  vtkHapticForEachDataSet(node,
    [&](vtkDataSet& data)
    {
      if (auto* const piece = vtkPolyData::SafeDownCast(&data))
      {
        whole->AddInputData(piece);
      }
    });
  whole->Update();
  return whole->GetOutput();
}

/// A node of the tree below its root is a glyph.
Glyphs GlyphsOf(vtkDataObjectTree& table)
{
  const auto node = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(table.NewTreeIterator());
  node->TraverseSubTreeOff();
  node->VisitOnlyLeavesOff();
  Glyphs glyphs;
  for (node->InitTraversal(); !node->IsDoneWithTraversal(); node->GoToNextItem())
  {
    glyphs.push_back(std::make_unique<Glyph>(WholeOf(node->GetCurrentDataObject())));
  }
  return glyphs;
}

Glyphs GlyphsOf(vtkGlyph3DMapper& mapper)
{
  constexpr int sourcePort = 1;
  if (mapper.GetUseSourceTableTree())
  {
    vtkDataObjectTree* const table = mapper.GetSourceTableTree();
    return table ? GlyphsOf(*table) : Glyphs();
  }
  Glyphs glyphs;
  for (int i = 0; i < mapper.GetNumberOfInputConnections(sourcePort); ++i)
  {
    glyphs.push_back(std::make_unique<Glyph>(mapper.GetSource(i)));
  }
  return glyphs;
}

/// Puts copies together.
class Soup
{
public:
  explicit Soup(vtkDataSet& from) : From(from.GetPointData())
  {
    this->Points->SetDataTypeToDouble();
    this->To->CopyAllocate(this->From);
    this->Ids->SetName("vtkOriginalPointIds");
  }

  void Add(const Glyph& glyph, const Eigen::Affine3d& place, vtkIdType point)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < glyph.Data->GetNumberOfPoints(); ++i)
    {
      const Vec3 p = place * Vec3(glyph.Data->GetPoint(i));
      const vtkIdType id = this->Points->InsertNextPoint(p.data());
      this->To->CopyData(this->From, point, id);
      this->Ids->InsertNextValue(point);
    }
    const bool mirrors = place.linear().determinant() < 0.0;
    this->Polygons->Append(mirrors ? glyph.Mirrored.GetPointer() : glyph.Data->GetPolys(), first);
    this->Lines->Append(glyph.Data->GetLines(), first);
    this->Vertices->Append(glyph.Data->GetVerts(), first);
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> Data()
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    data->SetPolys(this->Polygons);
    data->SetLines(this->Lines);
    data->SetVerts(this->Vertices);
    data->GetPointData()->ShallowCopy(this->To);
    if (!data->GetPointData()->HasArray(this->Ids->GetName())) // the input's own say more
    {
      data->GetPointData()->AddArray(this->Ids);
    }
    vtkNew<vtkIdTypeArray> cells; // no cell of the source is here
    cells->SetName("vtkOriginalCellIds");
    cells->SetNumberOfValues(data->GetNumberOfCells());
    cells->FillValue(-1);
    data->GetCellData()->AddArray(cells);
    return data;
  }

private:
  vtkPointData* From;
  vtkNew<vtkPointData> To;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polygons;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Vertices;
  vtkNew<vtkIdTypeArray> Ids;
};

/// Calls `visit` with each point whose glyph is drawn, and which glyph that is.
template<typename Visit>
void ForEachDrawn(const Rule& rule, vtkDataSet& data, const Glyphs& glyphs, Visit visit)
{
  for (vtkIdType point = 0; point < data.GetNumberOfPoints(); ++point)
  {
    const Glyph& glyph = *glyphs[static_cast<std::size_t>(rule.GlyphAt(point, static_cast<int>(glyphs.size())))];
    if (glyph.Data && rule.Draws(point))
    {
      visit(point, glyph);
    }
  }
}

std::string Refusal(vtkGlyph3DMapper& mapper, const Glyphs& glyphs, std::int64_t mostPolygons)
{
  if (glyphs.empty())
  {
    return "no glyph is chosen; choose a Glyph Type";
  }
  std::string problem;
  std::int64_t count = 0, polygons = 0;
  vtkHapticForEachDataSet(mapper.GetInputDataObject(0, 0),
    [&](vtkDataSet& data)
    {
      const Rule rule(mapper, data);
      problem = problem.empty() ? rule.Problem() : problem;
      ForEachDrawn(rule, data, glyphs,
        [&](vtkIdType, const Glyph& glyph)
        {
          ++count;
          polygons += glyph.Cells();
        });
    });
  if (problem.empty() && polygons > mostPolygons)
  {
    problem = std::to_string(count) + " glyphs have " + std::to_string(polygons) + " polygons, and at most " +
              std::to_string(mostPolygons) + " can be touched; draw fewer glyphs, or choose a simpler Glyph Type";
  }
  return problem;
}

void AddArray(palpate::WordHash& hash, vtkGlyph3DMapper& mapper, int which)
{
  const char* const name = mapper.GetInputArrayInformation(which)->Get(vtkDataObject::FIELD_NAME());
  hash.add(static_cast<std::uint64_t>(std::hash<std::string>()(name ? name : "")));
}

void AddObject(palpate::WordHash& hash, vtkObject* object)
{
  hash.add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(object)));
  hash.add(static_cast<std::uint64_t>(object ? object->GetMTime() : 0));
}

void AddWithPieces(palpate::WordHash& hash, vtkDataObject* data)
{
  AddObject(hash, data);
  vtkHapticForEachDataSet(data, [&](vtkDataSet& set) { AddObject(hash, &set); });
}
} // namespace

vtkHapticShape vtkHapticGlyphsOf(vtkGlyph3DMapper* mapper, std::int64_t mostPolygons)
{
  vtkHapticShape result;
  const Glyphs glyphs = GlyphsOf(*mapper);
  result.Problem = Refusal(*mapper, glyphs, mostPolygons);
  if (!result.Problem.empty())
  {
    return result;
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkHapticForEachDataSet(mapper->GetInputDataObject(0, 0),
    [&](vtkDataSet& data)
    {
      const Rule rule(*mapper, data);
      Soup soup(data);
      ForEachDrawn(
        rule, data, glyphs, [&](vtkIdType point, const Glyph& glyph) { soup.Add(glyph, rule.PlaceOf(point), point); });
      blocks->SetBlock(blocks->GetNumberOfBlocks(), soup.Data());
    });
  result.Data = blocks;
  return result;
}

std::uint64_t vtkHapticGlyphsKey(vtkGlyph3DMapper* mapper)
{
  palpate::WordHash hash;
  for (const int choice : { mapper->GetScaleMode(), mapper->GetOrientationMode(), int(mapper->GetScaling()),
         int(mapper->GetOrient()), int(mapper->GetClamping()), int(mapper->GetSourceIndexing()),
         int(mapper->GetMasking()), int(mapper->GetUseSourceTableTree()) })
  {
    hash.add(static_cast<std::uint64_t>(choice));
  }
  for (const double number : { mapper->GetScaleFactor(), mapper->GetRange()[0], mapper->GetRange()[1] })
  {
    hash.add(number);
  }
  for (const int which :
    { vtkGlyph3DMapper::SCALE, vtkGlyph3DMapper::SOURCE_INDEX, vtkGlyph3DMapper::MASK, vtkGlyph3DMapper::ORIENTATION })
  {
    AddArray(hash, *mapper, which);
  }
  for (int i = 0; i < mapper->GetNumberOfInputConnections(1); ++i)
  {
    AddWithPieces(hash, mapper->GetInputDataObject(1, i));
  }
  vtkHapticForEachDataSet(mapper->GetInputDataObject(0, 0), [&](vtkDataSet& data) { AddObject(hash, &data); });
  return hash.value();
}
