// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/backends/Gallery.h"

#ifdef PALPATE_LAB_FILTERS
#include <stdexcept>

#include <vtkHapticLabyrinthData.h>
#endif

namespace palpate::lab
{

#ifdef PALPATE_LAB_FILTERS
std::optional<Labyrinth> galleryMaze(const std::string& name)
{
  vtkHapticLabyrinthResult read = vtkHapticReadLabyrinth(std::string(PALPATE_GALLERY) + '/' + name + ".vtp");
  if (!read.Problem.empty())
  {
    throw std::runtime_error(read.Problem);
  }
  return std::move(read.Labyrinth);
}
#else
std::optional<Labyrinth> galleryMaze(const std::string&)
{
  return std::nullopt;
}
#endif

} // namespace palpate::lab
