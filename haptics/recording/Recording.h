// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "haptics/recording/TickRecord.h"
#include "haptics/recording/inputs/Inputs.h"
#include "haptics/tick/ForceRenderer.h"
#include "haptics/tick/HapticEvent.h"
#include "haptics/tick/HapticParameters.h"

namespace palpate
{

/// An event before a tick was computed: new parameters, or another input by its name (input::RecordedName, whose id is
/// the event's value).
struct RecordedChange
{
  HapticEvent event;
  std::optional<HapticParameters> parameters;
  std::uint64_t sceneHash = 0;
  std::uint64_t sceneRevision = 0;
};

using RecordedEntry = std::variant<TickRecord, RecordedChange>;

/// A whole recording: a text header, then little-endian chunks, then a closing chunk, each with its checksum
/// (RecordingLayout.h). A part that the program does not know is refused; a plan or a field that a recording lacks
/// keeps its default.
struct Recording : TickInputs::Recorded
{
  static constexpr int formatVersion = 8;

  std::string device;
  HapticParameters parameters;
  RendererState initialState;
  std::vector<RecordedEntry> entries;
  std::uint64_t lost = 0; ///< ticks the writer could not take: such a recording cannot be recomputed
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

/// Computes every tick again and compares force, proxy, contacts, energy, flags and the device's own walls, viscosity
/// and signal bit for bit. Scenes come from the recording, or from `given` (by their meshes' hash) where it left them
/// out. `visit` sees each recomputed tick.
[[nodiscard]] ReplayResult replay(const Recording& recording,
  const std::vector<std::shared_ptr<const Scene>>& given = {}, unsigned workers = 1,
  const std::function<void(const TickOutput&)>& visit = {});

} // namespace palpate
