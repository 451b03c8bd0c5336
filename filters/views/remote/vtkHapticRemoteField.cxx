// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticRemoteField.h"

#include <set>
#include <span>

#include "vtkCommand.h"
#include "vtkHapticFieldBlock.h"
#include "vtkHapticServerProxies.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWeakPointer.h"

namespace
{
constexpr const char* NoAnswer =
  "the server did not send the field: load the plugin Palpate of this version on the server too";

/// A block filter on the server.
class Server
{
public:
  Server(vtkSMSourceProxy* source, unsigned int port, double time, const vtkHapticFieldArrays& arrays) : Time(time)
  {
    this->FieldBlock = vtkHapticMakeProxy(source, "internal_filters", "HapticFieldBlock");
    if (!this->FieldBlock)
    {
      return;
    }
    vtkSMPropertyHelper(this->FieldBlock, "Input").Set(source, port);
    vtkSMPropertyHelper(this->FieldBlock, "Values").Set(arrays.Scalar.c_str());
    vtkSMPropertyHelper(this->FieldBlock, "Directions").Set(arrays.Vector.c_str());
    vtkSMPropertyHelper(this->FieldBlock, "Resistance").Set(arrays.Resistance.c_str());
    vtkSMPropertyHelper(this->FieldBlock, "Other").Set(arrays.Other.c_str());
    vtkSMPropertyHelper(this->FieldBlock, "Component").Set(arrays.Component);
    vtkSMPropertyHelper(this->FieldBlock, "Eigenvector").Set(arrays.Eigenvector);
    vtkSMPropertyHelper(this->FieldBlock, "Smoothing").Set(arrays.Smoothing);
    this->FieldBlock->UpdateVTKObjects();
  }

  /// None where the server has no such filter or went away.
  std::optional<vtkHapticFieldPacket> Ask(const palpate::FieldBlockWish& wish)
  {
    if (!this->FieldBlock)
    {
      return std::nullopt;
    }
    vtkSMPropertyHelper(this->FieldBlock, "Centre").Set(wish.centre_W.data(), 3);
    vtkSMPropertyHelper(this->FieldBlock, "Reach").Set(wish.reach_u);
    vtkSMPropertyHelper(this->FieldBlock, "Revision").Set(static_cast<int>(wish.revision));
    vtkSMPropertyHelper(this->FieldBlock, "HasLevel").Set(wish.level ? 1 : 0);
    vtkSMPropertyHelper(this->FieldBlock, "SmoothLevels").Set(wish.smoothLevels ? 1 : 0);
    vtkSMPropertyHelper(this->FieldBlock, "Level").Set(wish.level.value_or(0.0));
    this->FieldBlock->UpdateVTKObjects();
    const vtkSmartPointer<vtkDataObject> came = vtkHapticBring(this->FieldBlock, VTK_TABLE, this->Time);
    vtkUnsignedCharArray* const bytes = vtkHapticFieldBlock::BytesOf(vtkTable::SafeDownCast(came));
    return bytes ? vtkHapticUnpackField({ reinterpret_cast<const char*>(bytes->GetPointer(0)),
                     static_cast<std::size_t>(bytes->GetNumberOfValues()) })
                 : std::nullopt;
  }

private:
  vtkSmartPointer<vtkSMSourceProxy> FieldBlock;
  double Time;
};

class RemoteField : public palpate::FieldSource
{
public:
  RemoteField(Server server, vtkSMSourceProxy* source) : Asked(std::move(server)), Source(source)
  {
    this->Observer = source->AddObserver(vtkCommand::UpdateDataEvent, this, &RemoteField::Change);
  }
  ~RemoteField() override
  {
    if (this->Source)
    {
      this->Source->RemoveObserver(this->Observer);
    }
  }

  palpate::MadeFieldBlock brickAround(const palpate::FieldBlockWish& wish) const override
  {
    const auto packet = this->Asked.Ask(wish);
    return packet ? packet->Made : palpate::MadeFieldBlock{ nullptr, wish.centre_W, wish.reach_u, NoAnswer };
  }
  bool answersAnyThread() const override { return false; }
  std::shared_ptr<const bool> Changed() const { return this->HasChanged; }

private:
  void Change() { *this->HasChanged = true; }

  mutable Server Asked; ///< by one thread at a time
  vtkWeakPointer<vtkSMSourceProxy> Source;
  unsigned long Observer = 0;
  std::shared_ptr<bool> HasChanged = std::make_shared<bool>(false);
};
} // namespace

vtkHapticRemoteFieldResult vtkHapticRemoteField(
  vtkSMSourceProxy* source, unsigned int port, double time, const vtkHapticFieldArrays& arrays)
{
  Server server(source, port, time, arrays);
  const auto packet = server.Ask({});
  if (!packet)
  {
    return { { nullptr, NoAnswer } };
  }
  vtkHapticRemoteFieldResult result{ { nullptr, packet->Problem, packet->Ends, packet->Bounds } };
  if (packet->Problem.empty())
  {
    const auto field = std::make_shared<RemoteField>(std::move(server), source);
    result.Field.Source = field;
    result.Changed = field->Changed();
  }
  return result;
}

std::vector<std::string> vtkHapticRemoteArrayNames(vtkSMSourceProxy* source, unsigned int port, int components)
{
  std::set<std::string> names;
  vtkPVDataInformation* const data = source->GetDataInformation(port);
  for (vtkPVDataSetAttributesInformation* attributes :
    { data->GetPointDataInformation(), data->GetCellDataInformation() })
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkPVArrayInformation* const array = attributes->GetArrayInformation(i);
      if (array->GetDataType() != VTK_STRING && vtkHapticFitsComponents(array->GetNumberOfComponents(), components))
      {
        names.insert(array->GetName());
      }
    }
  }
  return { names.begin(), names.end() };
}
