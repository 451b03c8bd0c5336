// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/backends/Backend.h"

namespace palpate::lab
{
namespace
{

#ifdef PALPATE_LAB_VTK
constexpr auto vtkStatic = makeVtkStaticCellLocator;
constexpr auto vtkCells = makeVtkCellLocator;
#else
constexpr std::nullptr_t vtkStatic = nullptr;
constexpr std::nullptr_t vtkCells = nullptr;
#endif
#ifdef PALPATE_LAB_EMBREE
constexpr auto embree = makeEmbree;
#else
constexpr std::nullptr_t embree = nullptr;
#endif
#ifdef PALPATE_LAB_BULLET
constexpr auto bullet = makeBullet;
#else
constexpr std::nullptr_t bullet = nullptr;
#endif

} // namespace

std::vector<BackendKind> backendKinds()
{
  return {
    { "ours", Arithmetic::Exact, makeOurs },
    { "cgal", Arithmetic::Double, makeCgal },
    { "vtkStaticCellLocator", Arithmetic::Double, vtkStatic },
    { "vtkCellLocator", Arithmetic::Double, vtkCells },
    { "embree", Arithmetic::Single, embree },
    { "bullet", Arithmetic::Single, bullet },
  };
}

} // namespace palpate::lab
