// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/backends/ImageContour.h"

#ifdef PALPATE_LAB_FILTERS
#include <algorithm>

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageCurves.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#endif

namespace palpate::lab
{
namespace
{

#ifdef PALPATE_LAB_FILTERS
std::vector<std::vector<Vec3>> curvesOf(vtkPolyData* data)
{
  std::vector<std::vector<Vec3>> curves;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (data->GetLines()->InitTraversal(); data->GetLines()->GetNextCell(count, points);)
  {
    curves.emplace_back(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      data->GetPoint(points[i], curves.back()[static_cast<std::size_t>(i)].data());
    }
  }
  return curves;
}

vtkSmartPointer<vtkImageData> imageOf(int size, const PixelField& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, 1);
  vtkNew<vtkDoubleArray> values;
  values->Allocate(static_cast<vtkIdType>(size) * size);
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      values->InsertNextValue(field(x, y));
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

std::vector<std::vector<Vec3>> contour(int size, const PixelField& field, double tolerance_u)
{
  vtkNew<vtkImageCurves> curves;
  curves->SetInputData(imageOf(size, field));
  curves->UseMiddleOff();
  curves->SetValue(0.0);
  curves->SetTolerance(tolerance_u);
  curves->Update();
  return curvesOf(curves->GetOutput());
}

/// The longest step of the shares that a filter reports.
struct Watch
{
  double last = 0.0, longest = 0.0;

  static void report(vtkObject*, unsigned long, void* client, void* share)
  {
    auto* watch = static_cast<Watch*>(client);
    const double now = *static_cast<double*>(share);
    watch->longest = std::max(watch->longest, now - watch->last);
    watch->last = now;
  }
};

ImageRun run(ImageKind kind, int size, const PixelField& field)
{
  vtkNew<vtkImageCurves> curves;
  curves->SetInputData(imageOf(size, field));
  curves->SetKind(kind == ImageKind::Contour  ? vtkImageCurves::Contour
                  : kind == ImageKind::Labels ? vtkImageCurves::Labels
                                              : vtkImageCurves::Drawing);
  curves->SetTolerance(1.0);
  constexpr std::size_t rounds = 3;
  test::CostSample cost(rounds);
  Watch watch;
  vtkNew<vtkCallbackCommand> report;
  report->SetClientData(&watch);
  report->SetCallback(Watch::report);
  curves->AddObserver(vtkCommand::ProgressEvent, report);
  for (std::size_t i = 0; i < rounds; ++i)
  {
    watch.last = 0.0;
    curves->Modified();
    cost.time([&] { curves->Update(); });
  }
  return { Cost::of(cost), watch.longest };
}

constexpr ImageContour ours = contour;
constexpr ImageRunner runner = run;
#else
constexpr ImageContour ours = nullptr;
constexpr ImageRunner runner = nullptr;
#endif

} // namespace

ImageContour imageContour()
{
  return ours;
}

ImageRunner imageRunner()
{
  return runner;
}

} // namespace palpate::lab
