// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include "vtkDataObject.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"

namespace palpate::testing
{

inline constexpr double period_s = 1e-3;
inline constexpr int ticksToEngage = 1100;   // arming, the ramp of 1 s, and some to spare
inline constexpr int ticksToSettle = 1500;   // e^-50 of the effect of a new scene is left
inline constexpr double stiffness = 500.0;   // N/m
inline constexpr double scale = 1000.0;      // u/m: a unit is a millimetre
inline constexpr double notNoticed = 0.07;   // of a depth of 1 mm
inline constexpr double depth = 2.0;         // u, to which a hand presses
inline constexpr double half = 100.0;        // u, of the side of a plane
inline constexpr double sphereRadius = 50.0; // u

/// A session in virtual time.
class VirtualSession : public ::testing::Test
{
protected:
  VirtualSession()
  {
    this->session_->SetSetting("VirtualTime", true);
    this->session_->SetSetting("Stiffness", stiffness);
    this->session_->SetSetting("Scale", scale);
  }

  /// It is all of the scene, and is felt from the next tick on.
  void show(vtkDataObject* surface)
  {
    this->session_->ClearSurfaces();
    ASSERT_TRUE(this->session_->AddSurface("surface", surface, nullptr)) << this->session_->GetProblem();
    this->session_->CommitScene();
    ASSERT_TRUE(this->session_->FinishScene()) << this->session_->GetSceneReport();
  }

  void startTouching()
  {
    this->session_->TouchingOn();
    ASSERT_TRUE(this->session_->GetTouching()) << this->session_->GetProblem();
  }

  vtkNew<vtkHapticSession> session_;
};

} // namespace palpate::testing
