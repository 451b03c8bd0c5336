// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "vtkDataObject.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"

namespace palpate::testing
{

inline constexpr int ticksToEngage = 1100; // arming, the ramp of 1 s, and some to spare
inline constexpr double stiffness = 500.0; // N/m
inline constexpr double scale = 1000.0;    // u/m: a unit is a millimetre

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
