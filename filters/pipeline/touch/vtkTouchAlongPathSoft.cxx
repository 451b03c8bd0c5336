// SPDX-License-Identifier: GPL-3.0-or-later
// Over a body that gives way.
#include <cmath>

#include "haptics/session/PathTouch.h"
#include "haptics/session/settings/Setting.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkTouchAlongPath.h"

namespace
{
/// Largest |F - 1| within which a law of small strains is true to 1 %, and from which on any is qualitative.
constexpr double SmallStrain = 0.1, LargeStrain = 0.5;
} // namespace

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
  const palpate::BodyShape shape = body.shape();
  if (shape.mostGradient > SmallStrain)
  {
    vtkWarningMacro("At the end of the path the strain is "
                    << palpate::quantity(100.0 * shape.mostGradient, "%") << " at " << shape.worst_W.transpose()
                    << (shape.mostGradient > LargeStrain ? ": what is felt is qualitative"
                                                         : ": a linear law is off by more than 1 %"));
  }
}
