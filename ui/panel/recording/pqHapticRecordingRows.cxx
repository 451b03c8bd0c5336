// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticRecordingRows.h"

#include "pqHapticButton.h"
#include "pqHapticController.h"
#include "pqHapticFields.h"
#include "pqHapticLines.h"
#include "pqHapticLink.h"
#include "pqHapticRecordings.h"
#include "pqPropertyLinks.h"
#include "vtkHapticSession.h"
#include "vtkSMProxy.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>

#include <cstring>

namespace
{
/// Four of them are no wider than the other rows.
QPushButton* NarrowButton(QHBoxLayout* row, const char* name, const QString& text, const QString& tip)
{
  constexpr int leastWidth = 30; // pixels
  QPushButton* const button = pqHapticButton(row, name, text, tip);
  button->setMinimumWidth(leastWidth);
  return button;
}

} // namespace

pqHapticRecordingRows::pqHapticRecordingRows(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("recording");
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  auto* buttons = new QHBoxLayout;
  rows->addLayout(buttons);
  this->Record =
    NarrowButton(buttons, "record", pqHapticTitle("Recording"), pqHapticTip("Recording") + " (Ctrl+Shift+R)");
  this->Record->setCheckable(true);
  pqHapticSetProperty(this->Record, "Recording");
  this->Save = NarrowButton(buttons, "saveRecording", tr("Save..."), tr("Save the last recording to a file"));
  this->Replay = NarrowButton(buttons, "replay", tr("Replay"), tr("Replay the recording as the hand"));
  this->Way =
    NarrowButton(buttons, "showWay", tr("Path"), tr("Open the path of the hand in the pipeline, with its forces"));
  this->Text = new pqHapticLines(this, "recordingText", pqHapticReadoutTip("RecordingText"), 1);
  rows->addWidget(this->Text);
  this->Played = new QWidget(this);
  rows->addWidget(this->Played);
  auto* played = new QHBoxLayout(this->Played);
  played->setContentsMargins(0, 0, 0, 0);
  this->Played->setObjectName("played");
  this->ReplayFile = new QLineEdit(this->Played);
  this->ReplayFile->setObjectName("replayFile");
  this->ReplayFile->setPlaceholderText(tr("Recording to play"));
  this->ReplayFile->setToolTip(pqHapticTip("ReplayFile"));
  played->addWidget(this->ReplayFile, 1);
  this->Browse = NarrowButton(played, "browse", tr("Open..."), tr("Choose the recording to play"));
  auto* recordings = pqHapticController::instance()->recordings();
  this->connect(this->Save, &QPushButton::clicked, recordings, &pqHapticRecordings::save);
  this->connect(this->Replay, &QPushButton::clicked, recordings, &pqHapticRecordings::replay);
  this->connect(this->Way, &QPushButton::clicked, recordings, &pqHapticRecordings::showWay);
  this->connect(this->Browse, &QPushButton::clicked, recordings, &pqHapticRecordings::open);
}

pqHapticRecordingRows::~pqHapticRecordingRows() = default;

void pqHapticRecordingRows::link(vtkSMProxy* proxy, pqPropertyLinks& links)
{
  pqHapticLink::add(links, this->Record, "checked", SIGNAL(toggled(bool)), proxy, "Recording");
  pqHapticLink::add(links, this->ReplayFile, "text", SIGNAL(editingFinished()), proxy, "ReplayFile");
}

void pqHapticRecordingRows::refresh(vtkHapticSession* session)
{
  const bool plays = session && std::strcmp(session->GetSettingText("DeviceName"), "replay") == 0;
  const bool hasFile = session && *session->GetSettingText("ReplayFile") != '\0';
  this->Save->setEnabled(session && !session->IsOn("Recording") && *session->GetRecordedFile() != '\0');
  this->Replay->setEnabled(hasFile || (session && session->IsOn("Recording") && session->GetTouching()));
  this->Way->setEnabled(hasFile);
  this->Played->setVisible(plays);
  this->Text->say(session ? QString::fromUtf8(session->GetRecordingText()) : QString());
}

QList<QWidget*> pqHapticRecordingRows::fields() const
{
  return { this->Record, this->Save, this->Replay, this->Way, this->ReplayFile, this->Browse };
}
