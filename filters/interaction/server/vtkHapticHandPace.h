// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHandPace_h
#define vtkHapticHandPace_h

/// Distance that a hand moves before its surroundings are updated.
struct vtkHapticHandPace
{
  static constexpr double fastest_m_per_s = 0.3; ///< of a hand that feels its way
  /// Until the next look and until a worker or a server has answered, twice: half of the margin is used up before more
  /// is asked for.
  static constexpr double ahead_s = 0.2;
};

#endif
