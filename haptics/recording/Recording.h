// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "haptics/field/Brick.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/recording/SkippedParts.h"
#include "haptics/recording/TickRecord.h"
#include "haptics/tick/ForceRenderer.h"
#include "haptics/tick/HapticEvent.h"
#include "haptics/tick/HapticParameters.h"

namespace palpate
{

/// What happened before a tick was computed: an event, new parameters, another scene (by content hash, 0: none),
/// another field (by the event's value, likewise), other contacts of a tool, another packet of a soft body or another
/// mechanism (by their revision, likewise).
struct RecordedChange
{
  HapticEvent event;
  std::optional<HapticParameters> parameters;
  std::uint64_t sceneHash = 0;
  std::uint64_t sceneRevision = 0;
};

using RecordedEntry = std::variant<TickRecord, RecordedChange>;

/// How the surfaces of a scene move, apart from the meshes, which are stored once.
struct RecordedMotion
{
  std::uint64_t contentHash = 0; ///< of the scene as a whole
  std::uint64_t geometryHash = 0;
  double motion_s = 0.0;
  std::vector<RigidMotion> motions;                       ///< one a surface
  std::vector<std::shared_ptr<const VertexStart>> starts; ///< one a surface; null: its vertices stand
};

/// A scene as a recording keeps it: the cleaned surfaces it was built from.
struct RecordedScene
{
  std::uint64_t geometryHash = 0;
  std::vector<SurfaceInput> surfaces;
};

/// A mechanism as a recording keeps it.
struct RecordedMechanism
{
  /// A soft body of it, without its scene.
  struct Body
  {
    std::uint64_t sceneHash = 0;
    std::uint64_t sceneRevision = 0;
    std::shared_ptr<const PressedBody> body;
  };

  std::uint64_t revision = 0;
  MechanismPlan plan;
  std::vector<Body> bodies; ///< in the plan's order
};

/// A whole recording: a text header, then little-endian chunks, then a closing chunk, each with its checksum
/// (RecordingLayout.h). What a program does not know it skips and says; what a recording lacks keeps its default.
struct Recording
{
  static constexpr int formatVersion = 7;        ///< that is written
  static constexpr int checkedFormatVersion = 7; ///< the first with checksums
  static constexpr int oldestFormatVersion = 5;  ///< that is still read

  int format = formatVersion; ///< that it was read from
  std::string device;
  HapticParameters parameters;
  RendererState initialState;
  std::vector<RecordedScene> scenes; ///< each once; empty when they were left out
  std::vector<RecordedMotion> motions;
  std::vector<std::shared_ptr<const Brick>> bricks;       ///< each once
  std::vector<ToolContacts> tools;                        ///< in the order in which they were taken
  std::vector<std::shared_ptr<const PressedBody>> bodies; ///< without their scenes
  std::vector<RecordedMechanism> mechanisms;
  std::vector<RecordedEntry> entries;
  SkippedParts skipped;
  std::uint64_t lost = 0; ///< ticks the writer could not take: such a recording cannot be recomputed

  /// Empty, or one phrase: in a file of an older format damage may have gone unnoticed.
  [[nodiscard]] std::string describeUnchecked() const;
};

/// Reads a recording; on failure one sentence with the file and the reason. Never allocates by a number in the file
/// that the file's own size does not bear out.
[[nodiscard]] std::variant<Recording, std::string> readRecording(const std::string& path);
/// The same from memory; `name` stands for the file in messages.
[[nodiscard]] std::variant<Recording, std::string> parseRecording(
  const std::vector<char>& bytes, const std::string& name);

/// The result of computing a recording again.
struct ReplayResult
{
  std::uint64_t ticks = 0;
  std::string difference; ///< empty: every bit as recorded; else the first tick and quantity that differ
  std::string problem;    ///< not empty: it could not be recomputed, and why
};

/// Computes every tick again and compares force, proxy, contacts, energy, flags and what the device is asked to do by
/// itself (walls, viscosity, signal) bit for bit. Scenes come from the recording, or from `given` (by their meshes'
/// hash) where it left them out. `visit` sees each recomputed tick.
[[nodiscard]] ReplayResult replay(const Recording& recording,
  const std::vector<std::shared_ptr<const Scene>>& given = {}, unsigned workers = 1,
  const std::function<void(const TickOutput&)>& visit = {});

} // namespace palpate
