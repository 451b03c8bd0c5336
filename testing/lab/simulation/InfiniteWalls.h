// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "devices/simulated/SimulatedDevice.h"

namespace palpate::lab
{

/// Force [N] that pushes a handle out of a wall, from how deep it is [m], once a tick; negative depth: before the wall.
using WallLaw = std::function<double(double depth_m)>;

/// K depth and an integral of it, so that a hand is walked back to the surface (Massie 1996: "infinitely stiff"). The
/// integral leaks in 50 ms where nothing touches, and is never below zero nor above `most_N`.
struct IntegralWall
{
  double stiffness_N_per_m = 1000.0;
  double integral_N_per_ms = 0.0; ///< K_i [N/(m s)]
  double period_s = 1e-3;
  double most_N = 20.0;
  bool bothSides = false; ///< holds from both sides and never leaks: the linear loop that eigenvalues speak of
  double integral_N = 0.0;

  double operator()(double depth_m);
};

/// A spring, and in the first tick inside a force that takes the speed away, - m v / T (Salcudean & Vlaar 1997). The
/// speed is the difference of two depths, as an encoder shows them.
struct BrakingWall
{
  double stiffness_N_per_m = 1000.0;
  double mass_kg = 0.1; ///< that it believes in
  double period_s = 1e-3;
  double most_N = 1e9;
  std::optional<double> before_m = std::nullopt;

  double operator()(double depth_m);
};

/// A spring, and from the first tick inside on a cosine that dies away, as high as the impact was fast (Fiene &
/// Kuchenbecker 2006). Open loop: it goes on whatever the handle does.
struct TransientWall
{
  double stiffness_N_per_m = 1000.0;
  double height_Ns_per_m = 20.0; ///< A: of the force at first, over the speed
  double decay_s = 0.01;
  double frequency_Hz = 125.0;
  double period_s = 1e-3;
  std::optional<double> before_m = std::nullopt;
  double speed_m_per_s = 0.0; ///< of the impact; 0: there was none yet
  double since_s = 0.0;

  double operator()(double depth_m);
};

/// A handle that nobody holds and a wall that keeps it at x <= 0.
struct AtWall
{
  DeviceModel model;
  double period_s = 1e-3;
  double x_m = 0.0;
  double speed_m_per_s = 0.0; ///< along x
  double push_N = 0.0;        ///< along x
};

/// Ticks of a wall on a simulated device.
class WallTicks
{
public:
  WallTicks(const AtWall& start, WallLaw law);

  /// One period; the wall's force for it [N].
  double tick();
  [[nodiscard]] double x_m() const { return this->device_.position_D().x(); }
  [[nodiscard]] double speed_m_per_s() const { return this->device_.speed_D().x(); }

private:
  SimulatedDevice device_;
  WallLaw law_;
  double period_s_;
  int ticks_ = 0;
};

} // namespace palpate::lab
