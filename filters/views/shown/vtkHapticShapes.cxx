// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticShapes.h"

#include "vtkGlyph3DMapper.h"
#include "vtkHapticGlyphs.h"
#include "vtkHapticSlices.h"
#include "vtkPVImageSliceMapper.h"

vtkHapticShape vtkHapticShapes::GlyphsOf(vtkGlyph3DMapper* mapper)
{
  return this->Find(mapper, vtkHapticGlyphsKey(mapper), [&] { return vtkHapticGlyphsOf(mapper); });
}

vtkHapticShape vtkHapticShapes::SliceOf(vtkPVImageSliceMapper* mapper)
{
  return this->Find(mapper, vtkHapticSliceKey(mapper), [&] { return vtkHapticSliceOf(mapper); });
}

vtkHapticShape vtkHapticShapes::Find(vtkMapper* mapper, std::uint64_t key, const std::function<vtkHapticShape()>& make)
{
  const auto [at, isNew] = this->Known.try_emplace(mapper);
  if (isNew || at->second.Key != key)
  {
    at->second.Key = key;
    at->second.Shape = make();
  }
  at->second.Used = true;
  return at->second.Shape;
}

void vtkHapticShapes::Forget()
{
  std::erase_if(this->Known, [](const auto& each) { return !each.second.Used; });
  for (auto& each : this->Known)
  {
    each.second.Used = false;
  }
}
