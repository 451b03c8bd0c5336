// SPDX-License-Identifier: GPL-3.0-or-later
// Progress and abort of the filter Image Curves.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "FunctionImages.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;

namespace
{
/// Many rings of other values on a ground of zero, broken below their middles.
vtkSmartPointer<vtkImageData> manyRings()
{
  return squareImage(
    512,
    [](const Vec3& p_W)
    {
      const double x = std::fmod(p_W.x(), 16.0) - 8.0, y = std::fmod(p_W.y(), 16.0) - 8.0;
      const bool broken = std::abs(x) < 1.0 && y < 0.0;
      return std::abs(std::hypot(x, y) - 5.0) < 1.3 && !broken ? 1.0 + std::floor(p_W.x() / 16) : 0.0;
    },
    VTK_UNSIGNED_CHAR);
}

vtkSmartPointer<vtkImageCurves> ringsAs(int kind)
{
  const auto filter = filterOf(manyRings(), kind);
  filter->UseMiddleOff();
  filter->InkIsDarkOff();
  filter->SetGap(3.0);
  return filter;
}

/// Reports of a filter while it runs; stopped at the first report of at least `stopAt`.
std::vector<double> reports(vtkImageCurves* filter, double stopAt)
{
  struct Watch
  {
    std::vector<double> Shares;
    double StopAt;
  } watch{ {}, stopAt };
  vtkNew<vtkCallbackCommand> report;
  report->SetClientData(&watch);
  report->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* share)
    {
      auto* told = static_cast<Watch*>(client);
      told->Shares.push_back(*static_cast<double*>(share));
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(told->Shares.back() >= told->StopAt);
    });
  filter->AddObserver(vtkCommand::ProgressEvent, report);
  filter->Update();
  return watch.Shares;
}
} // namespace

TEST(ImageCurves, ProgressRisesInSmallStepsWhateverTheImageIs)
{
  for (const int kind : { vtkImageCurves::Contour, vtkImageCurves::Labels, vtkImageCurves::Drawing })
  {
    const auto filter = ringsAs(kind);
    const std::vector<double> shares = reports(filter, 2.0);
    ASSERT_FALSE(shares.empty());
    EXPECT_GT(filter->GetOutput()->GetNumberOfLines(), 500) << kind;
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end())) << kind;
    EXPECT_EQ(shares.back(), 1.0) << kind;
    for (std::size_t i = 1; i < shares.size(); ++i)
    {
      ASSERT_LE(shares[i] - shares[i - 1], 0.15) << kind << ": from " << shares[i - 1];
    }
  }
}

TEST(ImageCurves, AnAbortIsHeededAtTheNextReportAndLeavesAnEmptyOutput)
{
  for (const int kind : { vtkImageCurves::Contour, vtkImageCurves::Labels, vtkImageCurves::Drawing })
  {
    for (const double stopAt : { 0.0, 0.05, 0.2, 0.4, 0.55, 0.62, 0.8 })
    {
      const auto filter = ringsAs(kind);
      const std::vector<double> shares = reports(filter, stopAt);
      const auto after = [&](double share) { return share >= stopAt && share < 1.0; }; // 1 comes from the pipeline
      EXPECT_EQ(std::count_if(shares.begin(), shares.end(), after), 1) << kind << " at " << stopAt;
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << kind << " at " << stopAt;
    }
  }
}
