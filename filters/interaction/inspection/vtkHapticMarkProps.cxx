// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMarkProps.h"

#include <vector>

#include "vtkActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkHapticInspection.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextProperty.h"
#include "vtkWeakPointer.h"

vtkStandardNewMacro(vtkHapticMarkProps);

namespace
{
constexpr float ballSize_px = 12.0f;
constexpr int labelOffset_px = 10, labelSize_pt = 16;
constexpr double ballColour[] = { 1.0, 0.85, 0.1 };
/// Half of a ball would be hidden by the surface that its mark lies on. Units of depth, more than a 16 bit buffer has.
constexpr double inFrontOfEverything = -66000.0;

vtkSmartPointer<vtkBillboardTextActor3D> LabelOf(const std::string& text, double position[3])
{
  auto label = vtkSmartPointer<vtkBillboardTextActor3D>::New();
  label->SetInput(text.c_str());
  label->SetPosition(position);
  label->SetDisplayOffset(labelOffset_px, labelOffset_px);
  label->GetTextProperty()->SetFontSize(labelSize_pt);
  label->GetTextProperty()->SetBackgroundColor(0.0, 0.0, 0.0); // readable on any data
  label->GetTextProperty()->SetBackgroundOpacity(0.6);
  label->PickableOff();
  label->UseBoundsOff();
  return label;
}
} // namespace

class vtkHapticMarkProps::Internals
{
public:
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkNew<vtkPolyData> Points;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Balls;
  std::vector<vtkSmartPointer<vtkBillboardTextActor3D>> Labels;

  void Add()
  {
    if (this->Renderer)
    {
      this->Renderer->AddActor(this->Balls);
      for (const auto& label : this->Labels)
      {
        this->Renderer->AddActor(label);
      }
    }
  }

  void Remove()
  {
    if (this->Renderer)
    {
      this->Renderer->RemoveActor(this->Balls);
      for (const auto& label : this->Labels)
      {
        this->Renderer->RemoveActor(label);
      }
    }
  }
};

vtkHapticMarkProps::vtkHapticMarkProps() : Impl(std::make_unique<Internals>())
{
  this->Impl->Mapper->SetInputData(this->Impl->Points);
  this->Impl->Mapper->ScalarVisibilityOff();
  this->Impl->Mapper->SetRelativeCoincidentTopologyPointOffsetParameter(inFrontOfEverything);
  this->Impl->Balls->SetMapper(this->Impl->Mapper);
  this->Impl->Balls->GetProperty()->SetColor(ballColour[0], ballColour[1], ballColour[2]);
  this->Impl->Balls->GetProperty()->SetPointSize(ballSize_px);
  this->Impl->Balls->GetProperty()->RenderPointsAsSpheresOn();
  this->Impl->Balls->PickableOff();
  this->Impl->Balls->UseBoundsOff();
}

vtkHapticMarkProps::~vtkHapticMarkProps()
{
  this->Impl->Remove();
}

void vtkHapticMarkProps::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMarks: " << this->GetNumberOfMarks() << "\n";
}

void vtkHapticMarkProps::SetRenderer(vtkRenderer* renderer)
{
  if (renderer != this->Impl->Renderer)
  {
    this->Impl->Remove();
    this->Impl->Renderer = renderer;
    this->Impl->Add();
  }
}

void vtkHapticMarkProps::UpdateFrom(vtkHapticSession* session)
{
  this->Impl->Remove();
  this->Impl->Labels.clear();
  this->Impl->Points->Initialize();
  if (session)
  {
    session->GetInspection()->GetMarks(this->Impl->Points);
  }
  for (int mark = 0; mark < this->Impl->Points->GetNumberOfPoints(); ++mark)
  {
    const std::string name = session->GetInspection()->GetMarkName(mark);
    const std::string text = std::to_string(mark + 1) + (name.empty() ? "" : " " + name);
    this->Impl->Labels.push_back(LabelOf(text, this->Impl->Points->GetPoint(mark)));
  }
  this->Impl->Add();
}

int vtkHapticMarkProps::GetNumberOfMarks() const
{
  return static_cast<int>(this->Impl->Labels.size());
}

std::string vtkHapticMarkProps::GetLabel(int mark) const
{
  const bool there = mark >= 0 && mark < this->GetNumberOfMarks();
  return there ? this->Impl->Labels[static_cast<std::size_t>(mark)]->GetInput() : "";
}

vtkActor* vtkHapticMarkProps::GetBallsActor() const
{
  return this->Impl->Balls;
}
