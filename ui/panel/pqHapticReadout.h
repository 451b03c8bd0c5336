// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticReadout_h
#define pqHapticReadout_h

#include <QString>

class vtkHapticSession;

/// The session's numbers as the panel shows them: rounded, each with its unit.
struct pqHapticReadout
{
  QString State;
  QString Reason;
  QString Force;
  QString Stiffness;
  QString Energy;
  QString Stabiliser;
  QString Friction;
  QString Contact;
  QString MotionLag;
  QString Rate;
  QString Lateness;
  QString Cost;
  QString Ticks;
  QString Stability;
  QString Scheduling;
  QString Plan;
  QString Scene;

  static pqHapticReadout of(vtkHapticSession& session);
};

#endif
