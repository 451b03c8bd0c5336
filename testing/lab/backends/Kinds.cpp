// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/backends/Backend.h"
#include "testing/lab/backends/Peers.h"

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
constexpr auto rays = makeEmbreeRays;
#else
constexpr std::nullptr_t embree = nullptr;
constexpr std::nullptr_t rays = nullptr;
#endif
#ifdef PALPATE_LAB_BULLET
constexpr auto bullet = makeBullet;
constexpr auto ball = makeBulletBall;
#else
constexpr std::nullptr_t bullet = nullptr;
constexpr std::nullptr_t ball = nullptr;
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

MakeRays embreeRays()
{
  return rays;
}

MakeBall bulletBall()
{
  return ball;
}

} // namespace palpate::lab
