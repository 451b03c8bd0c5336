// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "VirtualSession.h"
#include "haptics/core/Types.h"
#include "vtkHapticSession.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace palpate::testing
{

/// A session in virtual time with a plate that moves, deforms or is replaced under a hand.
class HapticSessionMotion : public ::testing::Test
{
protected:
  void start(double stiffness_N_per_m, vtkPolyData* surface, vtkMatrix4x4* matrix, double hand_z)
  {
    this->session_->SetSetting("VirtualTime", true);
    this->session_->SetSetting("Stiffness", stiffness_N_per_m);
    this->session_->SetSetting("Scale", scale);
    this->show(surface, matrix);
    ASSERT_TRUE(this->session_->FinishScene());
    this->session_->SetHandPosition(0.0, 0.0, hand_z);
    this->session_->TouchingOn();
    ASSERT_TRUE(this->session_->GetTouching()) << this->session_->GetProblem();
    this->session_->Step(ticksToEngage);
  }

  void show(vtkPolyData* surface, vtkMatrix4x4* matrix = nullptr)
  {
    this->session_->ClearSurfaces();
    ASSERT_TRUE(this->session_->AddSurface("plate", surface, matrix)) << this->session_->GetProblem();
    this->session_->CommitScene();
  }

  void place(vtkMatrix4x4* matrix)
  {
    ASSERT_TRUE(this->session_->SetSurfacePose("plate", matrix)) << this->session_->GetProblem();
    this->session_->CommitScene();
    this->session_->Update();
  }

  [[nodiscard]] Vec3 force() const { return Vec3(this->session_->GetForce()); }
  [[nodiscard]] Vec3 proxy_W() const { return Vec3(this->session_->GetProxyPosition()); }

  vtkNew<vtkHapticSession> session_;
};

} // namespace palpate::testing
