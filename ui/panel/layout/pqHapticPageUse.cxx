// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticPageUse.h"

#include "pqActiveObjects.h"
#include "vtkHapticSession.h"

#include <QObject>

#include <cmath>

namespace
{
bool Names(vtkHapticSession& session, const char* setting)
{
  return *session.GetSettingText(setting) != '\0';
}

bool FeelsLines(vtkHapticSession& session)
{
  return session.GetPlaneWorld() || session.GetSetting("LineRadius") > 0.0;
}

bool FeelsField(vtkHapticSession& session)
{
  return Names(session, "FieldArray") || Names(session, "FieldVectors") || Names(session, "FieldResistance");
}
} // namespace

QMap<QString, QString> pqHapticPageReasons(vtkHapticSession* session)
{
  const auto tr = [](const char* text) { return QObject::tr(text); };
  const auto unless = [](bool used, const QString& reason) { return used ? QString() : reason; };
  if (!session)
  {
    return {};
  }
  return {
    { "material", unless(pqActiveObjects::instance().activeSource(), tr("There is no source: open or make one.")) },
    { "field", unless(FeelsField(*session), tr("No field is felt: choose an array of a visible volume here.")) },
    { "lines",
      unless(FeelsLines(*session), tr("No lines are felt: set 'Radius of lines' on the page Main to more than 0.")) },
    { "tool", unless(Names(*session, "ToolSource"), tr("No tool is held: choose one here. The ball touches.")) },
    { "tissue", unless(Names(*session, "SoftSource"), tr("No soft body is held: choose one here.")) },
    { "mechanism", unless(Names(*session, "MechanismSource"), tr("No mechanism is held: choose one here.")) },
    { "device", unless(!session->GetFollowsMouse(), tr("The mouse is the device: it has no switch, no link and no "
                                                       "check.")) },
    { "stability", unless(std::isfinite(session->GetLargestStiffness()),
                     tr("This device renders no force: every stiffness is stable.")) },
  };
}
