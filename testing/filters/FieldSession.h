// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "haptics/core/Types.h"
#include "vtkFloatArray.h"
#include "vtkHapticSession.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

namespace palpate::testing
{

/// f = |p| on n^3 points h apart around the origin.
inline vtkSmartPointer<vtkImageData> distances(int n, double h)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetSpacing(h, h, h);
  image->SetOrigin(-0.5 * h * (n - 1), -0.5 * h * (n - 1), -0.5 * h * (n - 1));
  vtkNew<vtkFloatArray> values;
  values->SetName("distance");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->SetValue(i, static_cast<float>(Vec3(image->GetPoint(i)).norm()));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// A hand that is led through numbers in space in virtual time.
class FieldSession : public VirtualSession
{
protected:
  void start(const Vec3& hand)
  {
    this->at(hand);
    this->startTouching();
    this->session_->Step(ticksToEngage);
  }
  void at(const Vec3& hand) { this->session_->SetHandPosition(hand.x(), hand.y(), hand.z()); }
  /// 1 mm a tick.
  void go(const Vec3& from, const Vec3& to)
  {
    const int ticks = static_cast<int>((to - from).norm());
    for (int i = 1; i <= ticks; ++i)
    {
      this->at(from + i * (to - from) / ticks);
      this->session_->Step(1);
      this->session_->FinishField();
    }
    this->session_->Step(200);
  }
  [[nodiscard]] Vec3 force() const { return Vec3(this->session_->GetForce()); }
};

} // namespace palpate::testing
