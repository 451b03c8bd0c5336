// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSceneUnit.h"

#include "haptics/session/settings/SessionSettings.h"
#include "pqHapticFields.h"
#include "pqHapticUnits.h"
#include "pqHapticViewFollower.h"
#include "vtkHapticSession.h"

#include <QObject>

#include <string>

namespace
{
/// Looking at all sources costs much: once a second.
constexpr int refreshesToLook = 10;

QString ChosenUnit(const vtkHapticSession& session)
{
  const auto chosen = static_cast<std::size_t>(session.GetSetting("SceneUnit"));
  return chosen == 0 ? QString()
                     : QString::fromStdString(std::string(palpate::sessionSetting("SceneUnit").choices[chosen]));
}
} // namespace

void pqHapticSceneUnit::refresh(QWidget& panel, vtkHapticSession* session, const pqHapticViewFollower& follower)
{
  if (!session || this->Refreshes++ % refreshesToLook != 0)
  {
    return;
  }
  QString unit = ChosenUnit(*session);
  this->Sentence = QObject::tr("Lengths are in %1, as chosen.").arg(unit);
  if (unit.isEmpty())
  {
    unit = follower.lengthUnit(this->Sentence);
    this->Sentence = this->Sentence.isEmpty()
                       ? QObject::tr("No file names a unit of lengths, and u is the unit of the data.")
                       : this->Sentence;
  }
  if (pqHapticSetLengthUnit(unit))
  {
    pqHapticFollowUnit(panel);
  }
}
