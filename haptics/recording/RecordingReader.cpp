// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "haptics/recording/Recording.h"
#include "haptics/recording/RecordingLayout.h"

namespace palpate
{
namespace
{

RecordedChange readChange(ByteReader& in)
{
  RecordedChange change;
  bool hasParameters = false;
  layChange(Get{ in }, change);
  in.get(hasParameters);
  if (hasParameters)
  {
    change.parameters.emplace();
    layParameters(Get{ in }, *change.parameters);
    if (!change.parameters->validate().empty())
    {
      in.fail();
    }
  }
  return change;
}

std::vector<double> readNumbers(ByteReader& in)
{
  std::vector<double> numbers(in.count(sizeof(double)));
  for (double& number : numbers)
  {
    in.get(number);
  }
  return numbers;
}

std::shared_ptr<const MaterialFields> readFields(ByteReader& in)
{
  auto fields = std::make_shared<MaterialFields>();
  for (std::vector<double>* const field :
    { &fields->stiffness_N_per_m, &fields->frictionStatic, &fields->frictionKinetic, &fields->height_u })
  {
    *field = readNumbers(in);
  }
  return fields->empty() ? nullptr : fields;
}

RecordedScene readScene(ByteReader& in)
{
  RecordedScene scene;
  in.get(scene.geometryHash);
  const std::uint64_t surfaces = in.count(1);
  for (std::uint64_t s = 0; s < surfaces && in.ok(); ++s)
  {
    SurfaceInput input;
    auto mesh = std::make_shared<TriangleMesh>();
    in.get(input.name);
    layMaterial(Get{ in }, input.material);
    input.fields = readFields(in);
    double lineRadius_u = 0.0; // 0: triangles
    in.get(lineRadius_u);
    input.lineRadius_u = lineRadius_u != 0.0 ? std::optional(lineRadius_u) : std::nullopt;
    mesh->vertices_W.resize(in.count(3 * sizeof(double)));
    for (Vec3& v : mesh->vertices_W)
    {
      in.get(v);
    }
    mesh->triangles.resize(in.count(3 * sizeof(std::uint32_t)));
    for (auto& t : mesh->triangles)
    {
      for (std::uint32_t& corner : t)
      {
        in.get(corner);
      }
    }
    input.mesh = std::move(mesh);
    input.ordered = true;
    scene.surfaces.push_back(std::move(input));
  }
  const bool standIns = in.ok() && in.left() != 0;
  for (std::size_t s = 0; standIns && s < scene.surfaces.size(); ++s)
  {
    StandIn& standsFor = scene.surfaces[s].standsFor;
    in.get(standsFor.full);
    in.get(standsFor.bound_u);
    if (!std::isfinite(standsFor.bound_u) || standsFor.bound_u < 0.0)
    {
      in.fail();
    }
  }
  return scene;
}

std::shared_ptr<const VertexStart> readStart(ByteReader& in)
{
  std::uint64_t continues = 0;
  in.get(continues);
  std::vector<Vec3> vertices_W(in.count(3 * sizeof(double)));
  for (Vec3& v : vertices_W)
  {
    in.get(v);
  }
  return vertices_W.empty() ? nullptr : std::make_shared<const VertexStart>(std::move(vertices_W), continues);
}

RecordedMotion readMotion(ByteReader& in)
{
  RecordedMotion motion;
  in.get(motion.contentHash);
  in.get(motion.geometryHash);
  in.get(motion.motion_s);
  motion.motions.resize(in.count(2 * 7 * sizeof(double) + 2 * sizeof(std::uint64_t)));
  for (RigidMotion& m : motion.motions)
  {
    in.get(m.begin_WS);
    in.get(m.end_WS);
    motion.starts.push_back(readStart(in));
  }
  return motion;
}

/// Features and history of an untrusted state must not be used as indices; a recording starts without them.
bool plausible(const RendererState& state)
{
  return state.contact.count == 0 && state.velocity.count == 0 && !state.tracked;
}

/// Reads the chunks after the header; empty, or what is wrong.
std::string readChunks(ByteReader& in, Recording& recording)
{
  while (in.ok())
  {
    ChunkType type{};
    std::uint64_t size = 0;
    in.get(type);
    in.get(size);
    if (!in.has(size))
    {
      return "is cut short: it ends without its closing mark";
    }
    ByteReader payload(in.at(), size);
    in.skip(size);
    switch (type)
    {
      case ChunkType::Tick:
      {
        TickRecord record;
        layTick(Get{ payload }, record);
        recording.entries.emplace_back(record);
        break;
      }
      case ChunkType::Change:
        recording.entries.emplace_back(readChange(payload));
        break;
      case ChunkType::Scene:
        recording.scenes.push_back(readScene(payload));
        break;
      case ChunkType::Motion:
        recording.motions.push_back(readMotion(payload));
        break;
      case ChunkType::End:
        payload.get(recording.lost);
        return payload.ok() && in.left() == 0 ? "" : "is damaged: something follows its closing mark";
      default:
        return "is damaged: it has a part of unknown kind " + std::to_string(static_cast<std::uint32_t>(type));
    }
    if (!payload.ok() || payload.left() != 0)
    {
      return "is damaged: a part of kind " + std::to_string(static_cast<std::uint32_t>(type)) +
             " is not what it should be";
    }
  }
  return "is cut short: it ends without its closing mark";
}

} // namespace

std::variant<Recording, std::string> parseRecording(const std::vector<char>& bytes, const std::string& name)
{
  const std::string text(
    bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(bytes.size(), 4096)));
  if (!text.starts_with(recordingMagic))
  {
    return name + " is not a recording of Palpate";
  }
  const std::string version = text.substr(recordingMagic.size(), text.find('\n') - recordingMagic.size());
  if (version != std::to_string(Recording::formatVersion))
  {
    return name + " is a recording of format " + version.substr(0, 16) + ", this program reads format " +
           std::to_string(Recording::formatVersion) + ": record it again";
  }
  const std::size_t end = text.find("\nend\n");
  if (end == std::string::npos)
  {
    return name + " is cut short: its header does not end";
  }
  Recording recording;
  const std::size_t device = text.find("\ndevice: ");
  if (device != std::string::npos && device < end)
  {
    recording.device = text.substr(device + 9, text.find('\n', device + 9) - device - 9);
  }
  ByteReader in(bytes.data() + end + 5, bytes.size() - end - 5);
  layParameters(Get{ in }, recording.parameters);
  layState(Get{ in }, recording.initialState);
  if (!in.ok())
  {
    return name + " is cut short: its header does not end";
  }
  if (!plausible(recording.initialState) || !recording.parameters.validate().empty())
  {
    return name + " is damaged: its initial state cannot be";
  }
  const std::string wrong = readChunks(in, recording);
  if (!wrong.empty())
  {
    return name + " " + wrong;
  }
  return recording;
}

std::variant<Recording, std::string> readRecording(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    return path + " cannot be opened";
  }
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  return parseRecording(bytes, path);
}

} // namespace palpate
