// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticDrafts.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkSMInputProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkSMVectorProperty.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <string_view>

namespace
{
/// True if `wanted` holds for a property.
bool AnyProperty(vtkSMProxy* proxy, const std::function<bool(vtkSMProperty*)>& wanted)
{
  auto each = vtkSmartPointer<vtkSMPropertyIterator>::Take(proxy->NewPropertyIterator());
  for (each->Begin(); !each->IsAtEnd(); each->Next())
  {
    if (wanted(each->GetProperty()))
    {
      return true;
    }
  }
  return false;
}

/// The proxy that is a value of this one, as the function of a spline is of its source; null: the value is none.
vtkSMProxy* Part(vtkSMProperty* property)
{
  auto* proxies = vtkSMProxyProperty::SafeDownCast(property);
  return proxies && proxies->GetNumberOfProxies() == 1 ? proxies->GetProxy(0) : nullptr;
}

bool IsNumbers(vtkSMProperty* property)
{
  return property->IsA("vtkSMVectorProperty") && !property->IsA("vtkSMStringVectorProperty") &&
         !property->GetInformationOnly();
}

bool HasWidget(vtkSMProxy* proxy)
{
  constexpr std::string_view curves[] = { "InteractiveLine", "InteractivePolyLine", "InteractiveSpline" };
  for (std::size_t i = 0; i < proxy->GetNumberOfPropertyGroups(); ++i)
  {
    const char* widget = proxy->GetPropertyGroup(i)->GetPanelWidget();
    if (widget && std::find(std::begin(curves), std::end(curves), widget) != std::end(curves))
    {
      return true;
    }
  }
  return AnyProperty(proxy, [](vtkSMProperty* property) { return Part(property) && HasWidget(Part(property)); });
}

bool IsDrawn(vtkSMProxy* source)
{
  return vtkSMSourceProxy::SafeDownCast(source) &&
         !AnyProperty(source, [](vtkSMProperty* property) { return property->IsA("vtkSMInputProperty"); }) &&
         HasWidget(source);
}

bool IsChanged(vtkSMProxy* proxy)
{
  return AnyProperty(proxy,
    [](vtkSMProperty* property)
    {
      return IsNumbers(property) ? vtkSMPropertyHelper(property).GetDoubleArray() !=
                                     vtkSMUncheckedPropertyHelper(property).GetDoubleArray()
                                 : Part(property) && IsChanged(Part(property));
    });
}

vtkSmartPointer<vtkSMProxy> NewOfKind(vtkSMProxy* proxy)
{
  return vtkSmartPointer<vtkSMProxy>::Take(
    proxy->GetSessionProxyManager()->NewProxy(proxy->GetXMLGroup(), proxy->GetXMLName()));
}

/// Equal values do not modify the copy, so a copy of a curve that did not move costs no run of it.
void CopyDrawn(vtkSMProxy* from, vtkSMProxy* to)
{
  auto each = vtkSmartPointer<vtkSMPropertyIterator>::Take(from->NewPropertyIterator());
  for (each->Begin(); !each->IsAtEnd(); each->Next())
  {
    vtkSMProperty* const own = to->GetProperty(each->GetKey());
    if (IsNumbers(each->GetProperty()))
    {
      vtkSMPropertyHelper(own).Copy(vtkSMUncheckedPropertyHelper(each->GetProperty()));
    }
    else if (vtkSMProxy* const part = Part(each->GetProperty()))
    {
      if (!Part(own) || Part(own) == part || Part(own)->GetXMLName() != std::string_view(part->GetXMLName()))
      {
        vtkSMPropertyHelper(own).Set(NewOfKind(part));
      }
      CopyDrawn(part, Part(own));
    }
  }
  to->UpdateVTKObjects();
}
} // namespace

vtkHapticDrafts::vtkHapticDrafts() = default;

vtkHapticDrafts::~vtkHapticDrafts() = default;

vtkDataObject* vtkHapticDrafts::Changed(vtkSMProxy* source)
{
  return IsDrawn(source) && IsChanged(source) ? this->Drawn(source) : nullptr;
}

vtkDataObject* vtkHapticDrafts::Drawn(vtkSMProxy* source)
{
  if (!IsDrawn(source))
  {
    return nullptr;
  }
  Copy& copy = this->Copies[source];
  if (copy.Of != source)
  {
    copy = { source, vtkSMSourceProxy::SafeDownCast(NewOfKind(source)) };
  }
  CopyDrawn(source, copy.Source);
  copy.Source->UpdatePipeline();
  auto* algorithm = vtkAlgorithm::SafeDownCast(copy.Source->GetClientSideObject());
  return algorithm ? algorithm->GetOutputDataObject(0) : nullptr;
}

bool vtkHapticDrafts::Knows(vtkSMProxy* source) const
{
  const auto found = this->Copies.find(source);
  return found != this->Copies.end() && found->second.Of == source;
}

void vtkHapticDrafts::Forget(vtkSMProxy* source)
{
  this->Copies.erase(source);
}

void vtkHapticDrafts::ForgetDeleted()
{
  for (auto each = this->Copies.begin(); each != this->Copies.end();)
  {
    each = each->second.Of ? std::next(each) : this->Copies.erase(each);
  }
}

void vtkHapticDrafts::ForgetAll()
{
  this->Copies.clear();
}
