// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "vtkHapticInteractor.h"
#include "vtkHapticMouse.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

class vtkPolyData;

namespace palpate::testing
{

inline constexpr int width_px = 400;
inline constexpr int height_px = 300;
inline constexpr int frame = 16;          // ticks between two frames of 60 Hz
inline constexpr int framesToEngage = 80; // arming, the ramp of 1 s, and some to spare
inline constexpr int framesToArrive = 60; // across the scene at 0.5 m/s of the hand
inline constexpr double depth_m = 0.002;  // of the session's default
inline constexpr double force_N = stiffness * depth_m;
/// Of a proxy in free air, that is where a hand 300 u away is.
inline constexpr double rounding_N = stiffness / scale * 300.0 * 4 * std::numeric_limits<double>::epsilon();
inline constexpr double fastest_m = 0.5e-3; // of the hand in a tick
inline constexpr double viewAngle = 30.0;
inline constexpr double parallelScale = 60.0;

/// A camera's ray by its formula: where it begins, and its direction.
struct FormulaRay
{
  Vec3 from;
  Vec3 along;

  double distanceTo(const Vec3& p) const { return (p - this->from).cross(this->along).norm(); }
  /// Where it meets the plane z = height.
  Vec3 atHeight(double height) const { return this->from + (height - this->from.z()) / this->along.z() * this->along; }
};

/// A pinhole with the eye at `eye_W` that looks at the origin, z up on the screen; or the same without perspective.
FormulaRay rayOf(const Vec3& eye_W, bool parallel, double x_px, double y_px);
/// Where on the screen a point is seen [pixels]: the same formula backwards.
std::pair<double, double> pixelOf(const Vec3& eye_W, bool parallel, const Vec3& p_W);

/// Surfaces in a window that is never opened, touched in virtual time by a mouse that speaks once a frame.
class HapticMouse : public ::testing::Test
{
protected:
  void SetUp() override;

  void show(vtkPolyData* surface);
  void look(const Vec3& eye_W, bool parallel);
  FormulaRay ray(double x_px, double y_px) const { return rayOf(this->eye_W_, this->parallel_, x_px, y_px); }

  /// Frames in which nothing is said.
  void rest(int frames);
  void engage();
  void press(double x_px, double y_px);
  void say(unsigned long event, int x_px, int y_px, bool shift = false, const char* key = nullptr);

  /// Counts those of these events that are left to the window's own style.
  void count(std::initializer_list<unsigned long> events, int& heard);

  double depthOf(const Vec3& p_W) const { return (p_W - this->eye_W_).dot(-this->eye_W_.normalized()); }
  Vec3 hand() const { return Vec3(this->session_->GetHandPosition()); }
  Vec3 proxy() const { return Vec3(this->session_->GetProxyPosition()); }
  Vec3 force() const { return Vec3(this->session_->GetForce()); }

  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  vtkNew<vtkHapticInteractor> touch_;
  vtkHapticSession* session_ = this->touch_->GetSession();
  vtkHapticMouse* mouse_ = this->touch_->GetMouse();
  Vec3 eye_W_ = Vec3::Zero();
  bool parallel_ = false;
};

} // namespace palpate::testing
