// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordingChunks.h"

#include <algorithm>

#include "haptics/core/Checksum.h"
#include "haptics/recording/NamedParts.h"
#include "haptics/recording/RecordedBodies.h"
#include "haptics/recording/RecordedBricks.h"
#include "haptics/recording/RecordedMechanisms.h"
#include "haptics/recording/RecordedStages.h"
#include "haptics/recording/RecordedTools.h"
#include "haptics/recording/RecordingLayout.h"

namespace palpate
{
namespace
{

std::uint32_t checksumOf(const ByteWriter& bytes)
{
  return crc32c(bytes.bytes().data(), bytes.bytes().size());
}

std::vector<char> chunk(const ChunkKind& kind, const ByteWriter& payload)
{
  ByteWriter head;
  for (std::size_t i = 0; i < ChunkKind::nameSize; ++i)
  {
    head.put(i < kind.name.size() ? kind.name[i] : '\0');
  }
  head.put(kind.version);
  head.put(static_cast<std::uint64_t>(payload.bytes().size()));
  head.put(checksumOf(payload));
  head.put(checksumOf(head));
  std::vector<char> bytes = head.bytes();
  bytes.insert(bytes.end(), payload.bytes().begin(), payload.bytes().end());
  return bytes;
}

ByteWriter bytesOf(const HapticParameters& parameters)
{
  ByteWriter bytes;
  putParameters(bytes, parameters);
  return bytes;
}

void putFields(const MaterialFields* fields, ByteWriter& payload)
{
  const MaterialFields none;
  const MaterialFields& f = fields != nullptr ? *fields : none;
  for (const std::vector<double>* const field :
    { &f.stiffness_N_per_m, &f.frictionStatic, &f.frictionKinetic, &f.height_u })
  {
    payload.put(static_cast<std::uint64_t>(field->size()));
    for (const double number : *field)
    {
      payload.put(number);
    }
  }
}

void putStart(const VertexStart* start, ByteWriter& payload)
{
  payload.put(start != nullptr ? start->continues : std::uint64_t{ 0 });
  payload.put(static_cast<std::uint64_t>(start != nullptr ? start->vertices_W.size() : 0));
  for (std::size_t i = 0; start != nullptr && i < start->vertices_W.size(); ++i)
  {
    payload.put(start->vertices_W[i]);
  }
}

/// At the end, and only where there are any.
void putStandIns(const std::vector<Surface>& surfaces, ByteWriter& payload)
{
  if (std::any_of(surfaces.begin(), surfaces.end(), [](const Surface& s) { return s.standsFor.full != 0; }))
  {
    for (const Surface& surface : surfaces)
    {
      payload.put(surface.standsFor.full);
      payload.put(surface.standsFor.bound_u);
    }
  }
}

} // namespace

std::string recordingHeader(const std::string& device)
{
  const std::string text =
    std::string(recordingMagic) + std::to_string(Recording::formatVersion) +
    "\nunits: seconds, metres and newtons in the device frame; scene units in the scene\ndevice: " + device +
    "\nbinary: little-endian chunks (name of " + std::to_string(ChunkKind::nameSize) +
    " bytes, version u32, size u64, CRC-32C of the payload u32, CRC-32C of this head u32, payload)" +
    std::string(headerCheck);
  return text + checkDigits(crc32c(text.data(), text.size())) + std::string(headerEnd);
}

std::vector<char> startChunk(const HapticParameters& parameters, const RendererState& state)
{
  ByteWriter payload;
  putPart(payload, parametersPart, bytesOf(parameters));
  ByteWriter first;
  putState(first, state);
  putPart(payload, statePart, first);
  return chunk(chunks::start, payload);
}

std::vector<char> tickChunk(const TickRecord& record)
{
  ByteWriter payload;
  inputFields(Put{ payload }, record);
  outputFields(Put{ payload }, record);
  const PoseRecord pose = record.pose.value_or(PoseRecord{});
  poseFields(Put{ payload }, pose);
  return chunk(chunks::tick, payload);
}

std::vector<char> changeChunk(const RecordedChange& change)
{
  ByteWriter payload;
  layChange(Put{ payload }, change);
  if (change.parameters)
  {
    putPart(payload, parametersPart, bytesOf(*change.parameters));
  }
  return chunk(chunks::change, payload);
}

std::vector<char> sceneChunk(const Scene& scene)
{
  ByteWriter payload;
  payload.put(scene.geometryHash());
  payload.put(static_cast<std::uint64_t>(scene.surfaces().size()));
  for (const Surface& surface : scene.surfaces())
  {
    const TriangleMesh& mesh = surface.tree->mesh();
    payload.put(surface.name);
    layMaterial(Put{ payload }, surface.material);
    putFields(surface.fields.get(), payload);
    payload.put(surface.tree->coat_u());
    payload.put(static_cast<std::uint64_t>(mesh.vertices_W.size()));
    for (const Vec3& v : mesh.vertices_W)
    {
      payload.put(v);
    }
    payload.put(static_cast<std::uint64_t>(mesh.triangles.size()));
    for (const auto& t : mesh.triangles)
    {
      for (const std::uint32_t corner : t)
      {
        payload.put(corner);
      }
    }
  }
  putStandIns(scene.surfaces(), payload);
  return chunk(chunks::scene, payload);
}

std::vector<char> motionChunk(const Scene& scene)
{
  ByteWriter payload;
  payload.put(scene.contentHash());
  payload.put(scene.geometryHash());
  payload.put(scene.motion_s());
  payload.put(static_cast<std::uint64_t>(scene.surfaces().size()));
  for (const Surface& surface : scene.surfaces())
  {
    payload.put(surface.motion.begin_WS);
    payload.put(surface.motion.end_WS);
    putStart(surface.from.get(), payload);
  }
  return chunk(chunks::motion, payload);
}

std::vector<char> brickChunk(const Brick& brick)
{
  ByteWriter payload;
  putBrick(payload, brick);
  return chunk(chunks::brick, payload);
}

std::vector<char> toolChunk(const ToolContacts& contacts)
{
  ByteWriter payload;
  putTool(payload, contacts);
  return chunk(chunks::tool, payload);
}

std::vector<char> bodyChunk(const PressedBody& body)
{
  ByteWriter payload;
  putBody(payload, body);
  payload.put(body.beside);
  putKnots(payload, body);
  putHeld(payload, body);
  return chunk(chunks::body, payload);
}

std::vector<char> mechanismChunk(const FeltMechanism& mechanism)
{
  ByteWriter payload;
  putMechanism(payload, mechanism);
  return chunk(chunks::mechanism, payload);
}

std::vector<char> endChunk(std::uint64_t lost)
{
  ByteWriter payload;
  payload.put(lost);
  return chunk(chunks::end, payload);
}

} // namespace palpate
