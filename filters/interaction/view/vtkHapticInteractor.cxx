// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticInteractor.h"

#include <algorithm>
#include <string>
#include <vector>

#include "haptics/core/WordHash.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkHapticConversion.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticMouse.h"
#include "vtkHapticMouseInput.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkHapticToolProps.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

vtkStandardNewMacro(vtkHapticInteractor);

namespace
{
/// The data that an actor shows now, its pipeline brought up to date; null if none.
vtkDataObject* ShownBy(vtkActor* actor)
{
  const bool seen = actor->GetVisibility() && actor->GetProperty()->GetOpacity() > 0.0;
  vtkMapper* mapper = seen ? actor->GetMapper() : nullptr;
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  mapper->GetInputAlgorithm()->Update();
  return mapper->GetInputDataObject(0, 0);
}
} // namespace

class vtkHapticInteractor::Internals
{
public:
  vtkNew<vtkHapticSession> Session;
  vtkNew<vtkHapticToolProps> Props;
  vtkNew<vtkHapticMouse> Mouse;
  vtkNew<vtkHapticMouseInput> Input;
  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::uint64_t Key = 0; ///< of the data that the session was given
  bool Given = false;
};

vtkHapticInteractor::vtkHapticInteractor() : Impl(std::make_unique<Internals>())
{
  this->Impl->Mouse->SetSession(this->Impl->Session);
  this->Impl->Input->SetMouse(this->Impl->Mouse);
}

vtkHapticInteractor::~vtkHapticInteractor()
{
  this->Stop();
}

void vtkHapticInteractor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Actors: " << this->GetNumberOfActors() << "\n";
  this->Impl->Session->PrintSelf(os, indent.GetNextIndent());
  this->Impl->Props->PrintSelf(os, indent.GetNextIndent());
}

void vtkHapticInteractor::SetRenderer(vtkRenderer* renderer)
{
  this->Impl->Renderer = renderer;
  this->Impl->Props->AddToRenderer(renderer);
  this->Impl->Mouse->SetRenderer(renderer);
}

void vtkHapticInteractor::FollowMouse(vtkRenderWindowInteractor* interactor)
{
  this->Impl->Input->SetInteractor(interactor);
}

vtkHapticMouse* vtkHapticInteractor::GetMouse() const
{
  return this->Impl->Mouse;
}

void vtkHapticInteractor::AddActor(vtkActor* actor)
{
  auto& actors = this->Impl->Actors;
  if (actor && std::find(actors.begin(), actors.end(), actor) == actors.end())
  {
    actors.emplace_back(actor);
    this->Modified();
  }
}

void vtkHapticInteractor::RemoveActor(vtkActor* actor)
{
  std::erase(this->Impl->Actors, actor);
  this->Modified();
}

void vtkHapticInteractor::RemoveAllActors()
{
  this->Impl->Actors.clear();
  this->Modified();
}

int vtkHapticInteractor::GetNumberOfActors() const
{
  return static_cast<int>(this->Impl->Actors.size());
}

vtkHapticSession* vtkHapticInteractor::GetSession() const
{
  return this->Impl->Session;
}

vtkHapticToolProps* vtkHapticInteractor::GetToolProps() const
{
  return this->Impl->Props;
}

bool vtkHapticInteractor::HandOver()
{
  Internals& impl = *this->Impl;
  palpate::WordHash key;
  key.add(std::uint64_t{ impl.Session->GetSight()->GetMaterialTime() });
  std::vector<vtkDataObject*> shown;
  for (vtkActor* actor : impl.Actors)
  {
    shown.push_back(ShownBy(actor));
    key.add(shown.back() ? vtkHapticContentKey(shown.back(), actor->GetMatrix()) : std::uint64_t{ 0 });
    key.add(impl.Session->GetSight()->GetUsesMaterialArrays() ? vtkHapticArraysKey(shown.back()) : std::uint64_t{ 0 });
  }
  if (impl.Given && key.value() == impl.Key)
  {
    return false;
  }
  impl.Key = key.value();
  impl.Given = true;
  impl.Session->ClearSurfaces();
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    if (shown[i])
    {
      impl.Session->AddSurface(("actor " + std::to_string(i)).c_str(), shown[i], impl.Actors[i]->GetMatrix());
    }
  }
  impl.Session->CommitScene();
  return true;
}

void vtkHapticInteractor::FollowCamera()
{
  vtkRenderer* const renderer = this->Impl->Renderer;
  this->Impl->Session->GetSight()->FollowCamera(renderer ? renderer->GetActiveCamera() : nullptr);
}

bool vtkHapticInteractor::Start()
{
  this->HandOver();
  this->Impl->Session->FinishScene();
  this->FollowCamera();
  this->Impl->Session->TouchingOn();
  this->Update();
  return this->Impl->Session->GetTouching();
}

void vtkHapticInteractor::Stop()
{
  this->Impl->Session->TouchingOff();
  this->Impl->Props->UpdateFrom(this->Impl->Session);
}

void vtkHapticInteractor::Update()
{
  this->HandOver();
  this->FollowCamera();
  this->Impl->Session->Update();
  this->Impl->Mouse->Update();
  this->Impl->Props->UpdateFrom(this->Impl->Session);
}
