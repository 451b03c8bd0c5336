// SPDX-License-Identifier: GPL-3.0-or-later
// What is recorded of a session, where it is kept, and what is played again.
#include <ctime>
#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "devices/RecordedHand.h"
#include "devices/ReplayDevice.h"
#include "haptics/recording/writing/EndedRecording.h"
#include "haptics/session/RecordingSentence.h"
#include "vtkCommand.h"
#include "vtkHapticRecordingState.h"
#include "vtkHapticSessionInternals.h"

namespace
{
namespace fs = std::filesystem;

/// Nobody else's: among the files that are temporary, named by the time, the process and a number.
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

/// Empty, or why not. What had the name is there until the copy is whole.
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

std::string vtkHapticSession::Internals::NextRecording() const
{
  const std::string& file = this->Settings.text("RecordFile");
  return file.empty() ? WorkingFile() : file;
}

void vtkHapticSession::Internals::FollowRecording()
{
  if (this->Core.recording())
  {
    this->Recorded.Seconds = this->Core.state().time_s - this->Recorded.Begun_s;
  }
  bool ended = false;
  while (const std::optional<palpate::EndedRecording> recorded = this->Core.takeRecorded())
  {
    ended = true;
    this->Refuse(recorded->problem);
    if (!recorded->file.empty())
    {
      this->Recorded.File = recorded->file;
      this->Settings.put("ReplayFile", recorded->file);
      this->Recorded.Saved = recorded->file == this->Settings.text("RecordFile");
    }
  }
  if (ended)
  {
    this->Settings.put("Recording", this->Core.recording() ? 1.0 : 0.0);
    this->Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

void vtkHapticSession::SaveRecording(const char* file)
{
  Internals& impl = *this->Impl;
  const std::string name = file ? file : "";
  if (name.empty() || name == impl.Recorded.File)
  {
    return;
  }
  const std::string problem = impl.Settings.isOn("Recording")
                                ? "the recording is still running: stop recording, then save"
                              : impl.Recorded.File.empty() ? "there is no recording to save: record first"
                                                           : CopyTo(impl.Recorded.File, name);
  this->Impl->Refuse(problem);
  impl.Follow("SaveRecording", problem);
  if (problem.empty())
  {
    if (!impl.Recorded.Saved)
    {
      std::error_code ignored;
      fs::remove(impl.Recorded.File, ignored);
    }
    if (impl.Settings.text("ReplayFile") == impl.Recorded.File)
    {
      impl.Settings.put("ReplayFile", name);
    }
    impl.Recorded.File = name;
    impl.Recorded.Saved = true;
    this->Modified();
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

void vtkHapticSession::Internals::Play(palpate::HapticDevice& device)
{
  auto* replay = dynamic_cast<palpate::ReplayDevice*>(&device);
  if (replay && replay->open().empty()) // what is wrong is said when it is opened to play
  {
    const bool fits = this->FitsNow();
    this->Played = replay->hand();
    this->SceneKnown = false;
    this->Change([&](palpate::HapticParameters& p) { p.map = this->Played->map; });
    this->LastFitted = fits ? this->Played->map : this->LastFitted;
    this->Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

void vtkHapticSession::Internals::FollowReplay()
{
  if (this->Played)
  {
    const auto& felt = this->Core.scene();
    const std::uint64_t shown = felt && !felt->empty() ? felt->geometryHash() : 0;
    this->SceneKnown = this->SceneKnown || palpate::otherSceneSentence(*this->Played, shown).empty();
    this->PlayedSentence =
      this->SceneKnown || this->Scene.worker().building() ? "" : palpate::otherSceneSentence(*this->Played, shown);
  }
}

std::string vtkHapticSession::Internals::FollowRecordingWish()
{
  std::string problem;
  if (this->Settings.isOn("Recording") && this->Core.running())
  {
    problem = this->Core.record(this->NextRecording());
    this->Recorded.Begun_s = this->Core.state().time_s;
  }
  else
  {
    this->Core.endRecording();
  }
  if (problem.empty())
  {
    this->FollowRecording();
  }
  return problem;
}

const char* vtkHapticSession::Internals::SayRecordingText()
{
  palpate::RecordingGlance glance;
  glance.wanted = this->Settings.isOn("Recording");
  glance.running = this->Core.recording();
  glance.length_s = this->Recorded.Seconds;
  glance.file = this->Recorded.File;
  glance.saved = this->Recorded.Saved;
  this->Recorded.Text = palpate::recordingSentence(glance);
  return this->Recorded.Text.c_str();
}
