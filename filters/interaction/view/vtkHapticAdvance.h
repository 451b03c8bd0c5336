// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticAdvance_h
#define vtkHapticAdvance_h

#include "haptics/core/Types.h"

#include <optional>

/// The depth of a hand that a pointer leads where no surface stands under the pointer: the pointer aims the tip across
/// an axis, and the tip is advanced along the axis. A hand that something resists goes no further than a given distance
/// beyond its proxy, so that the force is limited, and does not run ahead.
class vtkHapticAdvance
{
public:
  /// One frame, all of it in W [u]. Positions are those of the tip.
  struct Frame
  {
    palpate::Vec3 Hand, Proxy; ///< where they are
    palpate::Vec3 Led;         ///< where the hand was led to last
    palpate::Vec3 Axis;        ///< unit
    double Pace;               ///< most that the hand goes
    double Depth;              ///< beyond the proxy
    double Firm;               ///< beyond the proxy while it presses
    double Press;              ///< how far it goes on while it presses against nothing
    double PressOn;            ///< and against a resistance
    bool Pressing;
    bool
      Held; ///< a thing is advanced, which stays where it is stopped; otherwise a hand, which comes back to its plane
  };

  bool IsPlaced() const { return this->Placed; }
  /// Begins at a point, along an axis, not advanced.
  void Place(const palpate::Vec3& anchor_W, const palpate::Vec3& axis_W);
  void Forget() { this->Placed = false; }
  /// Has the axis go through the tip from now on where it has turned.
  void FollowAxis(const Frame& frame);
  /// The point of the axis that it has been advanced to: the pointer aims in the plane through it.
  palpate::Vec3 Middle() const { return this->Anchor + this->Along * this->Axis; }
  void Advance(double way_u) { this->Along = this->Chosen = this->Along + way_u; }
  /// Which may be before where it began.
  void AdvanceTo(double along_u) { this->Along = this->Chosen = along_u; }
  /// Back to where it began.
  void Retract() { this->Along = this->Chosen = 0.0; }
  double GetAlong() const { return this->Along; }
  double GetAlongOf(const palpate::Vec3& p_W) const { return this->Axis.dot(p_W - this->Anchor); }

  /// Where the tip is led to now; `aimed_W`: where the pointer's ray meets the plane.
  palpate::Vec3 Next(const palpate::Vec3& aimed_W, const Frame& frame);
  /// Where the tip rests while no pointer leads it: without force.
  palpate::Vec3 Rest(const Frame& frame);

private:
  bool IsResisted(const Frame& frame) const;
  void Stop(const palpate::Vec3& at_W, const Frame& frame);
  void Press(const Frame& frame);

  bool Placed = false;
  bool Pressed = false; ///< in the frame before
  palpate::Vec3 Anchor = palpate::Vec3::Zero();
  palpate::Vec3 Axis = palpate::Vec3::UnitZ();
  double Along = 0.0;
  double Chosen = 0.0; ///< without a resistance: a hand in a field comes back to there
  double Gap = 0.0;    ///< most that the hand goes beyond the proxy now
};

#endif
