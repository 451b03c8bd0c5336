// SPDX-License-Identifier: GPL-3.0-or-later
// Over a body that gives way.
#include <cmath>

#include "haptics/session/path/PathTouch.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkTouchAlongPath.h"

std::string vtkTouchAlongPath::BesideBody() const
{
  const bool rate = this->LowRate >= 0.0 && std::isfinite(this->LowRate);
  const char* const set = this->LineRadius > 0.0      ? "lines"
                          : this->ForceShading        ? "shading"
                          : !this->Materials->Empty() ? "material from data"
                                                      : "";
  return !rate  ? "the low rate must be a finite number of hertz, 0 or above"
         : *set ? std::string("a soft body is not felt with ") + set + ": turn that off"
                : "";
}

void vtkTouchAlongPath::Press(vtkDataObject* body, palpate::PathTouch& touch, std::string& problem) const
{
  const vtkHapticSoftBodyResult read = vtkHapticToSoftBody(body);
  problem = this->BesideBody();
  auto maker = problem.empty() ? palpate::BodyMaker::make(*read.Input, "body", 0, problem) : nullptr;
  problem = problem.empty() ? "" : "The soft body cannot be touched: " + problem;
  if (maker)
  {
    touch.press(std::move(maker), this->LowRate);
  }
}

void vtkTouchAlongPath::TellOfBody(const palpate::BodyMaker& body)
{
  if (const std::string left = body.checked().report.summary(); !left.empty())
  {
    vtkWarningMacro("Of the soft body: " << left);
  }
  if (const palpate::BodyShape shape = body.shape(); shape.mostGradient > vtkHapticStrain::Small)
  {
    vtkWarningMacro("At the end of the path the largest strain is " << vtkHapticStrainText(shape));
  }
  if (body.wentThroughItself())
  {
    vtkWarningMacro("Of the soft body: " << palpate::throughItselfText);
  }
}
