// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFieldBlock.h"

#include <algorithm>
#include <string>

#include "vtkHapticFieldPacket.h"
#include "vtkHapticWholeInput.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

vtkStandardNewMacro(vtkHapticFieldBlock);

namespace
{
constexpr const char* Column = "FieldBlock";
}

/// The data as they were when they were looked at last.
struct vtkHapticFieldBlock::Looked
{
  vtkHapticFieldArrays Arrays;
  bool Changed = true; ///< other arrays
  vtkMTimeType Time = 0;
  vtkHapticFieldResult Field;
  vtkHapticFieldPacket Known;

  /// All ranks ask at once: their pipelines execute together.
  void Look(vtkDataObject* piece)
  {
    if (!this->Changed && this->Time == piece->GetMTime())
    {
      return;
    }
    this->Changed = false;
    this->Time = piece->GetMTime();
    const vtkSmartPointer<vtkDataObject> whole = vtkHapticWholeSurface(piece);
    if (vtkHapticRank() == 0)
    {
      this->Field = vtkHapticToField(whole, this->Arrays);
      this->Known.Problem = this->Field.Problem;
      this->Known.Ends = this->Field.Ends;
      this->Known.Bounds = this->Field.Bounds;
    }
  }
};

vtkHapticFieldBlock::vtkHapticFieldBlock() : Data(std::make_unique<Looked>()) {}

vtkHapticFieldBlock::~vtkHapticFieldBlock() = default;

void vtkHapticFieldBlock::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Values: " << this->Data->Arrays.Scalar << "\n";
  os << indent << "Directions: " << this->Data->Arrays.Vector << "\n";
  os << indent << "Centre: " << this->Centre[0] << " " << this->Centre[1] << " " << this->Centre[2] << "\n";
  os << indent << "Reach: " << this->Reach << "\n";
  os << indent << "Revision: " << this->Revision << "\n";
}

template<class Change>
void vtkHapticFieldBlock::ChangeArrays(const Change& change)
{
  const vtkHapticFieldArrays before = this->Data->Arrays;
  change(this->Data->Arrays);
  if (before != this->Data->Arrays)
  {
    this->Data->Changed = true;
    this->Modified();
  }
}

void vtkHapticFieldBlock::SetValues(const char* name)
{
  this->ChangeArrays([=](vtkHapticFieldArrays& a) { a.Scalar = name ? name : ""; });
}

void vtkHapticFieldBlock::SetDirections(const char* name)
{
  this->ChangeArrays([=](vtkHapticFieldArrays& a) { a.Vector = name ? name : ""; });
}

void vtkHapticFieldBlock::SetResistance(const char* name)
{
  this->ChangeArrays([=](vtkHapticFieldArrays& a) { a.Resistance = name ? name : ""; });
}

void vtkHapticFieldBlock::SetOther(const char* name)
{
  this->ChangeArrays([=](vtkHapticFieldArrays& a) { a.Other = name ? name : ""; });
}

void vtkHapticFieldBlock::SetComponent(int component)
{
  this->ChangeArrays([=](vtkHapticFieldArrays& a) { a.Component = component; });
}

void vtkHapticFieldBlock::SetEigenvector(int which)
{
  this->ChangeArrays([=](vtkHapticFieldArrays& a) { a.Eigenvector = which; });
}

void vtkHapticFieldBlock::SetSmoothing(int times)
{
  this->ChangeArrays([=](vtkHapticFieldArrays& a) { a.Smoothing = times; });
}

vtkUnsignedCharArray* vtkHapticFieldBlock::BytesOf(vtkTable* output)
{
  return output ? vtkUnsignedCharArray::SafeDownCast(output->GetColumnByName(Column)) : nullptr;
}

int vtkHapticFieldBlock::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkHapticFieldBlock::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->Data->Look(vtkDataObject::GetData(input[0]));
  if (vtkHapticRank() > 0)
  {
    return 1;
  }
  vtkHapticFieldPacket packet = this->Data->Known;
  if (this->Data->Field.Source && this->Revision > 0)
  {
    const palpate::FieldBlockWish wish{ palpate::Vec3(this->Centre), this->Reach,
      static_cast<std::uint64_t>(this->Revision), this->HasLevel ? std::optional(this->Level) : std::nullopt,
      this->SmoothLevels };
    packet.Made = this->Data->Field.Source->brickAround(wish);
  }
  const std::vector<char> bytes = vtkHapticPackField(packet);
  vtkNew<vtkUnsignedCharArray> column;
  column->SetName(Column);
  column->SetNumberOfValues(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), column->GetPointer(0));
  vtkTable::GetData(output)->AddColumn(column);
  return 1;
}
