// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticReadout.h"

#include "vtkHapticSession.h"

namespace
{
QString Quantity(double value, int decimals, const char* unit)
{
  const QString text = QString::number(value, 'f', decimals);
  return QString("%1 %2").arg(text.toDouble() == 0.0 ? QString::number(0.0, 'f', decimals) : text, unit); // never -0
}

QString Percentiles(double p50_us, double p99_us)
{
  return QString("%1 / %2 us").arg(p50_us, 0, 'f', 1).arg(p99_us, 0, 'f', 1);
}

QString Millijoules(double energy_J)
{
  return Quantity(1e3 * energy_J, 2, "mJ");
}

/// The stiffness of the spring now, and the one that was set where that differs.
QString StiffnessOf(const vtkHapticSession& session)
{
  const QString used = Quantity(session.GetStiffnessUsed(), 0, "N/m");
  return session.GetStiffnessLimited()
           ? QString("%1, limited from %2").arg(used, Quantity(session.GetSetting("Stiffness"), 0, "N/m"))
           : used;
}

/// Friction now, and the limit on the kinetic coefficient where there is one.
QString FrictionOf(const vtkHapticSession& session)
{
  const QString text = QString::fromUtf8(session.GetFrictionText());
  const QString now = text.isEmpty() ? QString("none") : text;
  const double used = session.GetFrictionKineticUsed();
  return used < session.GetSetting("FrictionKinetic")
           ? QString("%1, kinetic limited to the static %2").arg(now).arg(used, 0, 'f', 2)
           : now;
}

/// A fault has a reason, a warning comes next; otherwise the person must know the last thing that was refused.
QString ReasonOf(const vtkHapticSession& session)
{
  const QString fault = QString::fromUtf8(session.GetFaultText());
  const QString warning = QString::fromUtf8(session.GetWarning());
  return !fault.isEmpty() ? fault : !warning.isEmpty() ? warning : QString::fromUtf8(session.GetProblem());
}
} // namespace

pqHapticReadout pqHapticReadout::of(vtkHapticSession& session)
{
  pqHapticReadout now;
  now.State = QString::fromUtf8(session.GetStateText());
  now.Reason = ReasonOf(session);
  now.Force =
    QString("%1, peak %2").arg(Quantity(session.GetForceMagnitude(), 2, "N"), Quantity(session.GetPeakForce(), 2, "N"));
  now.Stiffness = StiffnessOf(session);
  now.Energy = QString("%1 delivered, %2 in excess, at most %3")
                 .arg(Millijoules(session.GetDeliveredEnergy()), Millijoules(session.GetExcessEnergy()),
                   Millijoules(session.GetPeakExcessEnergy()));
  now.Stabiliser = Quantity(session.GetStabiliserForce(), 2, "N");
  now.Friction = FrictionOf(session);
  now.Contact =
    QString("%1 planes, %2 in all").arg(session.GetContacts()).arg(Quantity(session.GetContactSeconds(), 1, "s"));
  now.MotionLag = Quantity(1e3 * session.GetMotionLag(), 0, "ms");
  now.Rate = Quantity(session.GetRate(), 0, "Hz");
  now.Lateness = Percentiles(session.GetLatenessP50(), session.GetLatenessP99());
  now.Cost = QString("%1 / %2 / %3 us")
               .arg(session.GetCostP50(), 0, 'f', 1)
               .arg(session.GetCostP99(), 0, 'f', 1)
               .arg(session.GetCostP999(), 0, 'f', 1);
  now.Ticks = QString("%1, missed %2").arg(session.GetTicks()).arg(session.GetMissed());
  now.Stability =
    QString("This device can stably render walls of %1.").arg(QString::fromUtf8(session.GetStabilityText()));
  now.Scheduling = QString::fromUtf8(session.GetSchedulingReport());
  now.Plan = QString::fromUtf8(session.GetPlanText());
  now.Scene = QString::fromUtf8(session.GetSceneReport());
  return now;
}
