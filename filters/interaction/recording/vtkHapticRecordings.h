// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticRecordings_h
#define vtkHapticRecordings_h

#include "devices/RecordedHand.h"
#include "vtkHapticSession.h"

#include <optional>
#include <string>

namespace palpate
{
class HapticDevice;
}

/// The recordings of a session: the running one, the last that is whole, and the one that is played again.
class vtkHapticRecordings
{
public:
  explicit vtkHapticRecordings(vtkHapticSession::Internals& behind) : Behind(behind) {}

  std::string File;                            ///< the last that is whole
  std::optional<palpate::RecordedHand> Played; ///< by the running device
  std::string PlayedText;                      ///< that it was recorded on something else; "": it was not

  /// The file that the next touch is recorded to; "": none.
  std::string FileOfTouch() const;
  /// Touching has begun, or could not begin.
  void FollowTouch();
  /// Begins or ends as the setting Recording says. Empty, or why it cannot be.
  std::string FollowWish();
  /// Takes over recordings that have ended, and reports their faults.
  void Follow();
  void Save(const std::string& name);
  const char* Say();

  /// A device that plays a recording moves the hand where it moved: the map of the recording.
  void Play(palpate::HapticDevice& device);
  /// Whether the played recording was made on the data that are shown.
  void FollowPlayed();

private:
  std::string NextFile() const;

  vtkHapticSession::Internals& Behind;
  bool Saved = false; ///< under a name that the person gave
  double Begun_s = 0.0;
  double Seconds = 0.0;
  std::string Text;
  bool SceneKnown = false; ///< the played recording was made on the shown data
};

#endif
