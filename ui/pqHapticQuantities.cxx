// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticQuantities.h"

#include "vtkHapticLabyrinthGame.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkHapticTouchedMechanism.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>
#include <map>
#include <string_view>

namespace
{
bool PhaseIs(vtkHapticSession& session, std::string_view phase)
{
  return session.GetLabyrinth()->GetPhase() == phase;
}

/// Of a held mechanism: those whose shaft is in a body.
double ConstraintsInside(vtkHapticSession& session)
{
  vtkNew<vtkTable> laws;
  session.GetMechanism()->GetTable(laws);
  double inside = 0.0;
  for (vtkIdType row = 0; row < laws->GetNumberOfRows(); ++row)
  {
    inside += laws->GetValueByName(row, "Phase").ToString() == "inside" ? 1.0 : 0.0;
  }
  return inside;
}

/// Of the proxy from the origin [u].
double DistanceOfProxy(vtkHapticSession& session)
{
  const double* const p = session.GetProxyPosition();
  return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
}

/// Sine of half the angle by which the workspace is turned.
double TurnOf(vtkHapticSession& session)
{
  const double* const q = session.GetSettingNumbers("Rotation");
  return std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}
} // namespace

std::function<double(vtkHapticSession&)> pqHapticQuantityOf(const QString& name)
{
  using S = vtkHapticSession&;
  static const std::map<QString, std::function<double(S)>> quantities = {
    { "force", [](S s) { return s.GetForceMagnitude(); } },
    { "recorded", [](S s) { return *s.GetRecordedFile() != '\0' ? 1.0 : 0.0; } },
    { "turned", [](S s) { return TurnOf(s); } },
    { "clutch", [](S s) { return s.IsOn("Clutch") ? 1.0 : 0.0; } },
    { "precision", [](S s) { return s.IsOn("Precision") ? 1.0 : 0.0; } },
    { "cancelled", [](S s) { return static_cast<double>(s.GetSight()->GetScenesCancelled()); } },
    { "arrived", [](S s) { return PhaseIs(s, "arrived") || PhaseIs(s, "rests") ? 1.0 : 0.0; } },
    { "depth", [](S s) { return s.GetDepth(); } },
    { "inside", [](S s) { return ConstraintsInside(s); } },
    { "contacts", [](S s) { return static_cast<double>(s.GetContacts()); } },
    { "distance", [](S s) { return DistanceOfProxy(s); } },
    { "scale", [](S s) { return s.GetSetting("Scale"); } },
    { "radius", [](S s) { return s.GetSetting("Radius"); } },
    { "ticks", [](S s) { return static_cast<double>(s.GetTicks()); } },
    { "missed", [](S s) { return static_cast<double>(s.GetMissed()); } },
    { "largestStiffness", [](S s) { return s.GetLargestStiffness(); } },
    { "limitStiffness", [](S s) { return s.IsOn("LimitStiffness") ? 1.0 : 0.0; } },
    { "passivity", [](S s) { return s.IsOn("Passivity") ? 1.0 : 0.0; } },
    { "delay", [](S s) { return s.GetSetting("Delay"); } },
    { "velocityMethod", [](S s) { return s.GetSetting("VelocityMethod"); } },
  };
  const auto found = quantities.find(name);
  return found == quantities.end() ? nullptr : found->second;
}
