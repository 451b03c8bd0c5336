// SPDX-License-Identifier: GPL-3.0-or-later
// What is recorded of a session, where it is kept, and what is played again.
#include <ctime>
#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "devices/ReplayDevice.h"
#include "haptics/session/RecordingSentence.h"
#include "vtkCommand.h"
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
  return failed ? to + " could not be written (" + failed.message() + "): the recording still is " + from : "";
}
} // namespace

std::string vtkHapticSession::Internals::NextRecording() const
{
  return this->RecordFile.empty() ? WorkingFile() : this->RecordFile;
}

void vtkHapticSession::SetRecordFile(const char* file)
{
  this->Impl->RecordFile = file ? file : "";
  this->Modified();
}

const char* vtkHapticSession::GetRecordFile() const
{
  return this->Impl->RecordFile.c_str();
}

void vtkHapticSession::SetReplayFile(const char* file)
{
  this->Impl->ReplayFile = file ? file : "";
  this->Modified();
}

const char* vtkHapticSession::GetReplayFile() const
{
  return this->Impl->ReplayFile.c_str();
}

void vtkHapticSession::SetRecording(bool on)
{
  Internals& impl = *this->Impl;
  if (on == impl.Recording)
  {
    return;
  }
  impl.Recording = on;
  if (on && this->GetTouching())
  {
    const std::string problem = impl.Core.record(impl.NextRecording());
    impl.Recording = problem.empty();
    impl.RecordingBegun_s = impl.Core.state().time_s;
    this->Refuse(problem);
    impl.Follow("Recording", problem);
  }
  else
  {
    impl.Core.endRecording();
  }
  this->Modified();
  this->FollowRecording();
}

bool vtkHapticSession::GetRecording() const
{
  return this->Impl->Recording;
}

void vtkHapticSession::FollowRecording()
{
  Internals& impl = *this->Impl;
  if (impl.Core.recording())
  {
    impl.RecordedSeconds = impl.Core.state().time_s - impl.RecordingBegun_s;
  }
  bool ended = false;
  while (const std::optional<palpate::EndedRecording> recorded = impl.Core.takeRecorded())
  {
    ended = true;
    this->Refuse(recorded->problem);
    if (!recorded->file.empty())
    {
      impl.Recorded = impl.ReplayFile = recorded->file;
      impl.Saved = recorded->file == impl.RecordFile;
    }
  }
  if (ended)
  {
    impl.Recording = impl.Core.recording();
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

void vtkHapticSession::SaveRecording(const char* file)
{
  Internals& impl = *this->Impl;
  const std::string name = file ? file : "";
  if (name.empty() || name == impl.Recorded)
  {
    return;
  }
  const std::string problem = impl.Recording          ? "it is still recorded: stop recording, then save it"
                              : impl.Recorded.empty() ? "there is nothing to save: record first"
                                                      : CopyTo(impl.Recorded, name);
  this->Refuse(problem);
  impl.Follow("SaveRecording", problem);
  if (problem.empty())
  {
    if (!impl.Saved)
    {
      std::error_code ignored;
      fs::remove(impl.Recorded, ignored);
    }
    impl.ReplayFile = impl.ReplayFile == impl.Recorded ? name : impl.ReplayFile;
    impl.Recorded = name;
    impl.Saved = true;
    this->Modified();
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

const char* vtkHapticSession::GetRecordedFile() const
{
  return this->Impl->Recorded.c_str();
}

const char* vtkHapticSession::GetRecordingText() const
{
  const Internals& impl = *this->Impl;
  palpate::RecordingGlance glance;
  glance.wanted = impl.Recording;
  glance.running = impl.Core.recording();
  glance.length_s = impl.RecordedSeconds;
  glance.file = impl.Recorded;
  glance.saved = impl.Saved;
  this->Impl->RecordingText = palpate::recordingSentence(glance);
  return this->Impl->RecordingText.c_str();
}

void vtkHapticSession::Play(palpate::HapticDevice& device)
{
  Internals& impl = *this->Impl;
  auto* replay = dynamic_cast<palpate::ReplayDevice*>(&device);
  if (replay && replay->open().empty()) // what is wrong is said when it is opened to play
  {
    const bool fits = impl.FitsNow();
    impl.Played = replay->hand();
    impl.SceneKnown = false;
    this->Change([&](palpate::HapticParameters& p) { p.map = impl.Played->map; });
    impl.LastFitted = fits ? impl.Played->map : impl.LastFitted;
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
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
