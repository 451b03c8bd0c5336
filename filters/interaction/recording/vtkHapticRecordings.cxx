// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticRecordings.h"

#include <ctime>
#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "devices/ReplayDevice.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/recording/writing/EndedRecording.h"
#include "haptics/session/RecordingText.h"
#include "vtkCommand.h"
#include "vtkHapticSessionInternals.h"

namespace
{
namespace fs = std::filesystem;

/// Its own name: among the files that are temporary, named by the time, the process and a number.
std::string WorkingFile()
{
  static int number = 0;
  std::error_code none;
  const std::time_t now = std::time(nullptr);
  char when[32];
  std::strftime(when, sizeof when, "%Y-%m-%d-%H%M%S", std::localtime(&now));
  const std::string name =
    std::string("palpate-") + when + "-" + std::to_string(getpid()) + "-" + std::to_string(++number) + ".palpate";
  return (fs::temp_directory_path(none) / name).string();
}

/// Empty, or why not. A file that had the name is there until the copy is whole.
std::string CopyTo(const std::string& from, const std::string& to)
{
  const std::string part = to + ".part";
  std::error_code failed;
  fs::copy_file(from, part, fs::copy_options::overwrite_existing, failed);
  if (!failed)
  {
    fs::rename(part, to, failed);
  }
  std::error_code ignored;
  fs::remove(part, ignored);
  return failed ? to + " could not be written (" + failed.message() + "): the recording is still at " + from : "";
}
} // namespace

std::string vtkHapticRecordings::NextFile() const
{
  const std::string& file = this->Behind.Settings.text("RecordFile");
  return file.empty() ? WorkingFile() : file;
}

std::string vtkHapticRecordings::FileOfTouch() const
{
  const palpate::SettingStore& settings = this->Behind.Settings;
  return settings.isOn("Recording") || !settings.text("RecordFile").empty() ? this->NextFile() : "";
}

void vtkHapticRecordings::FollowTouch()
{
  this->Begun_s = 0.0;
  if (this->Behind.Settings.isOn("Recording") != this->Behind.Core.recording())
  {
    this->Behind.Settings.put("Recording", this->Behind.Core.recording() ? 1.0 : 0.0);
    this->Behind.Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

std::string vtkHapticRecordings::FollowWish()
{
  std::string problem;
  if (this->Behind.Settings.isOn("Recording") && this->Behind.Core.running())
  {
    problem = this->Behind.Core.record(this->NextFile());
    this->Begun_s = this->Behind.Core.state().time_s;
  }
  else
  {
    this->Behind.Core.endRecording();
  }
  if (problem.empty())
  {
    this->Follow();
  }
  return problem;
}

void vtkHapticRecordings::Follow()
{
  palpate::HapticSession& core = this->Behind.Core;
  this->Seconds = core.recording() ? core.state().time_s - this->Begun_s : this->Seconds;
  bool ended = false;
  while (const std::optional<palpate::EndedRecording> recorded = core.takeRecorded())
  {
    ended = true;
    this->Behind.Refuse(recorded->problem);
    if (!recorded->file.empty())
    {
      this->File = recorded->file;
      this->Behind.Settings.put("ReplayFile", recorded->file);
      this->Saved = recorded->file == this->Behind.Settings.text("RecordFile");
    }
  }
  if (ended)
  {
    this->Behind.Settings.put("Recording", core.recording() ? 1.0 : 0.0);
    this->Behind.Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

void vtkHapticRecordings::Save(const std::string& name)
{
  if (name.empty() || name == this->File)
  {
    return;
  }
  const std::string problem = this->Behind.Settings.isOn("Recording")
                                ? "the recording is still running: stop recording, then save"
                              : this->File.empty() ? "there is no recording to save: record first"
                                                   : CopyTo(this->File, name);
  this->Behind.Refuse(problem);
  this->Behind.Follow("SaveRecording", problem);
  if (problem.empty())
  {
    if (!this->Saved)
    {
      std::error_code ignored;
      fs::remove(this->File, ignored);
    }
    if (this->Behind.Settings.text("ReplayFile") == this->File)
    {
      this->Behind.Settings.put("ReplayFile", name);
    }
    this->File = name;
    this->Saved = true;
    this->Behind.Session.Modified();
    this->Behind.Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

const char* vtkHapticRecordings::Say()
{
  palpate::RecordingGlance glance;
  glance.wanted = this->Behind.Settings.isOn("Recording");
  glance.running = this->Behind.Core.recording();
  glance.length_s = this->Seconds;
  glance.file = this->File;
  glance.saved = this->Saved;
  this->Text = palpate::recordingText(glance);
  return this->Text.c_str();
}

void vtkHapticRecordings::Play(palpate::HapticDevice& device)
{
  auto* replay = dynamic_cast<palpate::ReplayDevice*>(&device);
  if (replay && replay->open().empty()) // a fault is reported when the file is opened to play
  {
    const bool fits = this->Behind.FitsNow();
    this->Played = replay->hand();
    this->SceneKnown = false;
    this->Behind.Change([&](palpate::HapticParameters& p) { p.map = this->Played->map; });
    this->Behind.LastFitted = fits ? this->Played->map : this->Behind.LastFitted;
    this->Behind.Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

void vtkHapticRecordings::FollowPlayed()
{
  if (this->Played)
  {
    const auto& felt = this->Behind.Core.scene();
    const std::uint64_t shown = felt && !felt->empty() ? felt->geometryHash() : 0;
    const std::string other = palpate::otherSceneText(*this->Played, shown);
    this->SceneKnown = this->SceneKnown || other.empty();
    this->PlayedText = this->SceneKnown || this->Behind.Scene.worker().building() ? "" : other;
  }
}

// Of the session -----------------------------------------------------------------------------------------------------

void vtkHapticSession::SaveRecording(const char* file)
{
  this->Impl->Recorded.Save(file ? file : "");
}

std::string vtkHapticSession::Internals::FollowRecordingWish()
{
  return this->Recorded.FollowWish();
}
