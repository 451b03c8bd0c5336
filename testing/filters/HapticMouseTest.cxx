// SPDX-License-Identifier: GPL-3.0-or-later
#include "HapticMouseTest.h"

#include <numbers>

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

namespace palpate::testing
{

FormulaRay rayOf(const Vec3& eye_W, bool parallel, double x_px, double y_px)
{
  const Vec3 forward = -eye_W.normalized();
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  const Vec3 up = right.cross(forward);
  const double half = parallel ? parallelScale : std::tan(0.5 * viewAngle * std::numbers::pi / 180.0);
  const Vec3 shift =
    half * ((2 * x_px / width_px - 1) * width_px / height_px * right + (2 * y_px / height_px - 1) * up);
  return parallel ? FormulaRay{ eye_W + shift, forward } : FormulaRay{ eye_W, (forward + shift).normalized() };
}

std::pair<double, double> pixelOf(const Vec3& eye_W, bool parallel, const Vec3& p_W)
{
  const Vec3 forward = -eye_W.normalized();
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  const Vec3 way = p_W - eye_W;
  const double half =
    parallel ? parallelScale : std::tan(0.5 * viewAngle * std::numbers::pi / 180.0) * way.dot(forward);
  return { 0.5 * width_px * (1 + way.dot(right) / half * height_px / width_px),
    0.5 * height_px * (1 + way.dot(right.cross(forward)) / half) };
}

void HapticMouse::SetUp()
{
  this->window_->SetOffScreenRendering(1);
  this->window_->SetSize(width_px, height_px);
  this->window_->AddRenderer(this->renderer_);
  this->interactor_->SetRenderWindow(this->window_);
  this->touch_->SetRenderer(this->renderer_);
  this->touch_->FollowMouse(this->interactor_);
  this->session_->SetSetting("DeviceName", "mouse");
  this->session_->SetSetting("VirtualTime", true);
  this->session_->SetSetting("Stiffness", stiffness);
  this->session_->SetSetting("Scale", scale);
  this->session_->SetSetting("Passivity", false);
}

void HapticMouse::show(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  mapper->SetInputData(surface);
  actor->SetMapper(mapper);
  this->renderer_->AddActor(actor);
  this->touch_->AddActor(actor);
}

void HapticMouse::look(const Vec3& eye_W, bool parallel)
{
  vtkCamera* camera = this->renderer_->GetActiveCamera();
  camera->SetPosition(eye_W.data());
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(viewAngle);
  camera->SetParallelScale(parallelScale);
  camera->SetParallelProjection(parallel);
  this->renderer_->ResetCameraClippingRange();
  this->eye_W_ = eye_W;
  this->parallel_ = parallel;
}

void HapticMouse::rest(int frames)
{
  for (int i = 0; i < frames; ++i)
  {
    this->touch_->Update();
    this->session_->Step(frame);
  }
}

void HapticMouse::engage()
{
  ASSERT_TRUE(this->touch_->Start()) << this->session_->GetProblem();
  this->rest(framesToEngage);
  ASSERT_EQ(this->session_->GetEngageState(), vtkHapticSession::Engaged);
}

void HapticMouse::press(double x_px, double y_px)
{
  this->mouse_->SetPointer(x_px, y_px);
  this->mouse_->SetPressing(true);
  this->rest(framesToArrive);
}

void HapticMouse::say(unsigned long event, int x_px, int y_px, bool shift, const char* key)
{
  this->interactor_->SetEventInformation(x_px, y_px, 0, shift ? 1 : 0, 0, 0, key);
  this->interactor_->InvokeEvent(event);
}

void HapticMouse::count(std::initializer_list<unsigned long> events, int& heard)
{
  vtkNew<vtkCallbackCommand> style;
  style->SetClientData(&heard);
  style->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  for (const unsigned long event : events)
  {
    this->interactor_->AddObserver(event, style);
  }
}

} // namespace palpate::testing
