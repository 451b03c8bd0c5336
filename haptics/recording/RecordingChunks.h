// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/recording/Recording.h"

namespace palpate
{

/// The parts of a recording as bytes: its header, then its chunks.
[[nodiscard]] std::string recordingHeader(const std::string& device);
[[nodiscard]] std::vector<char> startChunk(const HapticParameters& parameters, const RendererState& state);
[[nodiscard]] std::vector<char> tickChunk(const TickRecord& record);
[[nodiscard]] std::vector<char> changeChunk(const RecordedChange& change);
/// The meshes and curves of a scene, wherever its surfaces are.
[[nodiscard]] std::vector<char> sceneChunk(const Scene& scene);
/// Where the surfaces of a scene that moves are and where their vertices come from, by the hash of its meshes.
[[nodiscard]] std::vector<char> motionChunk(const Scene& scene);
/// A field with its values.
[[nodiscard]] std::vector<char> brickChunk(const Brick& brick);
/// What a tool touches.
[[nodiscard]] std::vector<char> toolChunk(const ToolContacts& contacts);
/// A packet of a soft body.
[[nodiscard]] std::vector<char> bodyChunk(const PressedBody& body);
/// A mechanism with the packets of its soft bodies.
[[nodiscard]] std::vector<char> mechanismChunk(const FeltMechanism& mechanism);
[[nodiscard]] std::vector<char> endChunk(std::uint64_t lost);

} // namespace palpate
