// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPlaceInWorkSpace.h"

#include <algorithm>

#include "haptics/arm/file/ArmFile.h"
#include "haptics/arm/shown/ArmWorkSpaceMap.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"

vtkStandardNewMacro(vtkHapticPlaceInWorkSpace);

namespace
{
constexpr int Steps = 16; ///< along the diameter of the work space
/// Of the work space's radius: the data do not become smaller, however near to the rim the arm is best.
constexpr double LeastShare = 0.2;
} // namespace

vtkHapticPlaceInWorkSpace::vtkHapticPlaceInWorkSpace() = default;

vtkHapticPlaceInWorkSpace::~vtkHapticPlaceInWorkSpace() = default;

void vtkHapticPlaceInWorkSpace::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Arm: " << this->Arm << '\n';
}

int vtkHapticPlaceInWorkSpace::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkPointSet* const data = vtkPointSet::GetData(input[0]);
  const palpate::Outcome<palpate::ArmPlan> plan = palpate::armNamed(this->Arm);
  if (!plan.ok())
  {
    vtkErrorMacro(<< plan.problem);
    return 0;
  }
  const palpate::Arm arm(plan.value);
  const palpate::ArmRange range = palpate::rangeOf(arm, palpate::mapWorkSpace(arm, Steps));
  if (range.usable == 0 || data->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro(<< this->Arm << ": "
                  << (range.usable == 0 ? palpate::noteOn(arm, range) : "the data have no points"));
    return 0;
  }
  const palpate::ArmWorkSpace& space = plan.value.workSpace;
  const double room_m = std::max(space.radius_m - (range.best_D - space.centre_D).norm(), LeastShare * space.radius_m);
  const double length = data->GetLength();
  const double scale = this->Fit && length > 0.0 ? 2.0 * room_m * this->Scale / length : 1.0;
  const palpate::Vec3 place = this->Scale * range.best_D;
  const double* const middle = data->GetCenter();
  vtkNew<vtkTransform> transform;
  transform->Translate(place.x(), place.y(), place.z());
  transform->Scale(scale, scale, scale);
  transform->Translate(-middle[0], -middle[1], -middle[2]);
  vtkNew<vtkTransformFilter> filter;
  filter->SetInputData(data);
  filter->SetTransform(transform);
  filter->Update();
  vtkPointSet::GetData(output)->ShallowCopy(filter->GetOutput());
  return 1;
}
