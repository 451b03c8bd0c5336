// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace palpate::test
{

/// The handle of a virtual joystick: a mass with friction between two stops on each axis. Positions are shares of half
/// the travel and forces of the largest force, x to the right and y towards the person, as HID has them.
struct VirtualHandle
{
  using Axes = std::array<double, 2>;
  static constexpr double handleMass = 0.01, handleFriction = 0.6;

  Axes position{}, velocity{};
  Axes push{}; ///< of the hand

  /// A millisecond; `force`: that of the motors at the handle's place.
  template<class Force>
  void advanceHandle(Force force)
  {
    constexpr int parts = 4;
    constexpr double dt_s = 1e-3 / parts;
    for (int part = 0; part < parts; ++part)
    {
      const Axes pulled = force();
      for (const std::size_t axis : { 0U, 1U })
      {
        double& v = this->velocity[axis];
        v += dt_s / handleMass * (pulled[axis] + this->push[axis] - handleFriction * v);
        this->position[axis] += dt_s * v;
        if (std::fabs(this->position[axis]) >= 1.0)
        {
          this->position[axis] = std::copysign(1.0, this->position[axis]);
          v = 0.0;
        }
      }
    }
  }
};

} // namespace palpate::test
