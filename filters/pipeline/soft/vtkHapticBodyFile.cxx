// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticBodyFile.h"

#include <algorithm>
#include <array>
#include <utility>

#include "vtkDataSet.h"
#include "vtkHapticReaders.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkPolyData.h"

vtkHapticTetraFillResult vtkHapticReadBody(const std::string& file, const palpate::TetraSizes& sizes)
{
  vtkHapticTetraFillResult made;
  if (vtkHapticIsVolumeFile(file))
  {
    const vtkHapticReadVolumeResult read = vtkHapticReadVolume(file);
    made.Problem = read.Problem;
    made.Grid = read.Volume ? vtkHapticTetrahedra(read.Volume, made.Problem) : nullptr;
    made.Problem = read.Volume && !made.Grid ? file + ": " + made.Problem : made.Problem;
    return made;
  }
  const vtkHapticReadResult read = vtkHapticReadSurface(file, {});
  if (!read.Surface)
  {
    made.Problem = read.Problem;
    return made;
  }
  made = vtkHapticFillSurface(*read.Surface, sizes, palpate::always);
  made.Problem = made.Grid ? "" : file + ": " + made.Problem;
  return made;
}

bool vtkHapticModelOf(const std::string& name, palpate::ElasticModel& model)
{
  using enum palpate::ElasticModel;
  constexpr std::array names = { std::pair("linear", Linear), std::pair("corotational", CoRotational),
    std::pair("neohookean", NeoHookean) };
  const auto* const found =
    std::find_if(names.begin(), names.end(), [&](const auto& pair) { return name == pair.first; });
  model = found != names.end() ? found->second : model;
  return found != names.end();
}
