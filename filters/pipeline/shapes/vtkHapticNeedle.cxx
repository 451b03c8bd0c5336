// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticNeedle.h"

#include <cmath>

#include "vtkHapticTurnedSolid.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHapticNeedle);

namespace
{
constexpr double PointLength = 1.5; // in diameters
constexpr double Blunt = 1e-3;      // radius of the point, in radii: a fan closes it
} // namespace

vtkHapticNeedle::vtkHapticNeedle()
{
  this->SetNumberOfInputPorts(0);
}

void vtkHapticNeedle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Length: " << this->Length << " u\n";
  os << indent << "Diameter: " << this->Diameter << " u\n";
  os << indent << "Resolution: " << this->Resolution << '\n';
}

int vtkHapticNeedle::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  const double point = PointLength * this->Diameter;
  if (!(this->Diameter > 0.0 && std::isfinite(this->Length) && this->Length > point))
  {
    vtkErrorMacro("No needle was made: the diameter must be above 0, and the length a finite number above "
                  << PointLength << " diameters, the length of its tip.");
    return 0;
  }
  const double radius = 0.5 * this->Diameter;
  const auto round = [](double width, double height) {
    return vtkHapticRing{ height, [width](double) { return width; } };
  };
  vtkHapticTurnSolid({ round(Blunt * radius, -this->Length), round(radius, point - this->Length), round(radius, 0.0) },
    this->Resolution, false, vtkPolyData::GetData(output));
  return 1;
}
