// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/RecordingFormat.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

namespace palpate
{
namespace
{

constexpr char magic[] = "PALPATE-RECORDING";

/// Puts or gets, so that the layout of each type is written down once.
struct Put
{
  ByteWriter& stream;
  template<class T>
  void operator()(const T& value) const
  {
    this->stream.put(value);
  }
};

struct Get
{
  ByteReader& stream;
  template<class T>
  void operator()(T& value) const
  {
    this->stream.get(value);
  }
};

template<class Io, class T>
void layWrench(const Io& io, T& w)
{
  io(w.force);
  io(w.torque);
}

template<class Io, class T>
void layMap(const Io& io, T& m)
{
  io(m.scale_u_per_m);
  io(m.q_WD);
  io(m.offset_W);
}

template<class Io, class T>
void layTick(const Io& io, T& r)
{
  io(r.tick);
  io(r.dt_s);
  io(r.sample.time_s);
  io(r.sample.pose_D);
  io(r.sample.velocity_D.linear);
  io(r.sample.velocity_D.angular);
  layWrench(io, r.sample.sensed_D);
  io(r.sample.buttons);
  io(r.sample.grip);
  io(r.status);
  io(r.lateness.stiffnessFactor);
  io(r.lateness.fault);
  io(r.tool);
  layWrench(io, r.wrench_D);
  io(r.proxy_W);
  io(r.contacts);
  io(r.sceneRevision);
  io(r.delivered_J);
  io(r.excess_J);
  io(r.flags);
  for (auto& offset_m : r.walls.offset_m)
  {
    io(offset_m);
  }
  io(r.walls.mask);
  io(r.walls.stiffness_N_per_m);
  io(r.walls.viscosity_Ns_per_m);
}

template<class Io, class T>
void layParameters(const Io& io, T& p)
{
  io(p.stiffness_N_per_m);
  io(p.damping_Ns_per_m);
  io(p.limitStiffness);
  io(p.stiffnessLimit_N_per_m);
  io(p.passivity.enabled);
  io(p.passivity.delay_ticks);
  io(p.passivity.reserve);
  io(p.passivity.repay);
  io(p.velocity.method);
  io(p.velocity.resolution_m);
  io(p.velocity.lowPass_s);
  io(p.velocity.window);
  io(p.sceneBlend_s);
  io(p.contact.radius_u);
  io(p.contact.friction.statical);
  io(p.contact.friction.kinetic);
  io(p.contact.shading);
  io(p.contact.passCap);
  io(p.contact.nodeBudget);
  io(p.walls.hold);
  io(p.walls.every_s);
  io(p.walls.step_m);
  io(p.walls.viscosity_Ns_per_m);
  io(p.guide.on);
  io(p.guide.point_W);
  io(p.guide.normal_W);
  io(p.guide.stiffness_N_per_m);
  io(p.guide.largest_N);
  io(p.guide.ramp_s);
  io(p.game.on);
  io(p.game.start_W);
  io(p.game.exit_W);
  io(p.game.exitReach_u);
  io(p.game.lead_m_per_s);
  io(p.game.stiffness_N_per_m);
  io(p.game.damping_Ns_per_m);
  io(p.game.largest_N);
  io(p.game.near_m);
  io(p.game.fade_s);
  io(p.game.shake_N);
  io(p.game.shake_Hz);
  io(p.game.shake_s);
  layMap(io, p.map);
  io(p.safety.maxForce_N);
  io(p.safety.maxRise_N_per_s);
  io(p.safety.engageRamp_s);
  io(p.safety.engageBelow_N);
  io(p.safety.releaseRamp_s);
  io(p.safety.faultRamp_s);
  io(p.safety.needsEngage);
  io(p.safety.deadMan.buttons);
  io(p.safety.deadMan.grip);
  io(p.safety.hand.speed_m_per_s);
  io(p.safety.hand.excess_J);
  io(p.safety.frozenAbove_N);
}

template<class Io, class T>
void layState(const Io& io, T& s)
{
  io(s.contact.x_W);
  io(s.contact.placed);
  io(s.contact.slips);
  io(s.contact.count);
  for (auto& f : s.contact.features)
  {
    io(f.surface);
    io(f.a);
    io(f.b);
    io(f.kind);
    io(f.side);
    io(f.stuck);
  }
  io(s.engage);
  io(s.fault);
  io(s.gain);
  io(s.watch.same_s);
  io(s.lastForce_D);
  io(s.lastRendered_D);
  io(s.blend_D);
  io(s.velocity.count);
  io(s.tracked);
  layMap(io, s.map);
  io(s.radius_u);
  io(s.sceneRevision);
  io(s.sceneGeometry);
  io(s.sceneAge_s);
  io(s.sinceBad_s);
  io(s.sinceBadBefore_s);
}

std::vector<char> chunk(ChunkType type, const ByteWriter& payload)
{
  ByteWriter whole;
  whole.put(type);
  whole.put(static_cast<std::uint64_t>(payload.bytes().size()));
  std::vector<char> bytes = whole.bytes();
  bytes.insert(bytes.end(), payload.bytes().begin(), payload.bytes().end());
  return bytes;
}

RecordedChange readChange(ByteReader& in)
{
  RecordedChange change;
  bool hasParameters = false;
  in.get(change.event.tick);
  in.get(change.event.kind);
  in.get(change.event.value);
  in.get(change.sceneHash);
  in.get(change.sceneRevision);
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
    in.get(input.material.stiffness_N_per_m);
    in.get(input.material.frictionStatic);
    in.get(input.material.frictionKinetic);
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

void putStart(const VertexStart* start, ByteWriter& payload)
{
  payload.put(start != nullptr ? start->continues : std::uint64_t{ 0 });
  payload.put(static_cast<std::uint64_t>(start != nullptr ? start->vertices_W.size() : 0));
  for (std::size_t i = 0; start != nullptr && i < start->vertices_W.size(); ++i)
  {
    payload.put(start->vertices_W[i]);
  }
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

std::uint32_t recordFlags(const HapticState& s) noexcept
{
  std::uint32_t flags = 0;
  for (const bool flag : { s.stiffnessLimited, s.held, s.infeasible, s.overBudget, s.capped, s.riseLimited, s.clamped })
  {
    flags = flags << 1 | static_cast<std::uint32_t>(flag);
  }
  return flags;
}

namespace
{

/// Wall i of a command stands across one of the four directions; which says its normal.
DeviceWalls wallsOf(const DeviceCommand& command) noexcept
{
  DeviceWalls walls;
  for (std::size_t i = 0; i < command.wallCount; ++i)
  {
    const HeldWall& wall = command.walls[i];
    for (int k = 0; k < AxisWalls::count; ++k)
    {
      if (wall.normal_D == AxisWalls::direction(k))
      {
        walls.mask = static_cast<std::uint8_t>(walls.mask | 1u << k);
        walls.offset_m[static_cast<std::size_t>(k)] = wall.offset_m;
        walls.stiffness_N_per_m = wall.stiffness_N_per_m;
      }
    }
  }
  walls.viscosity_Ns_per_m = command.viscosity_Ns_per_m;
  return walls;
}

} // namespace

TickRecord makeRecord(const TickInput& input, const TickOutput& output) noexcept
{
  return { input.tick, input.dt_s, input.sample, input.status, input.lateness, 0, output.command.wrench_D,
    output.state.proxy_W, output.state.contacts, output.state.sceneRevision, output.state.energy.delivered_J,
    output.state.energy.excess_J, recordFlags(output.state), wallsOf(output.command) };
}

std::string recordingHeader(const std::string& device, const HapticParameters& parameters, const RendererState& state)
{
  ByteWriter binary;
  layParameters(Put{ binary }, parameters);
  layState(Put{ binary }, state);
  std::string header =
    std::string(magic) + " " + std::to_string(Recording::formatVersion) +
    "\nunits: seconds, metres and newtons in the device frame; scene units in the scene\ndevice: " + device +
    "\nbinary: little-endian, initial parameters and state of " + std::to_string(binary.bytes().size()) +
    " bytes, then chunks (type u32, size u64, payload)\nend\n";
  header.append(binary.bytes().begin(), binary.bytes().end());
  return header;
}

std::vector<char> tickChunk(const TickRecord& record)
{
  ByteWriter payload;
  layTick(Put{ payload }, record);
  return chunk(ChunkType::Tick, payload);
}

std::vector<char> changeChunk(const RecordedChange& change)
{
  ByteWriter payload;
  payload.put(change.event.tick);
  payload.put(change.event.kind);
  payload.put(change.event.value);
  payload.put(change.sceneHash);
  payload.put(change.sceneRevision);
  payload.put(change.parameters.has_value());
  if (change.parameters)
  {
    layParameters(Put{ payload }, *change.parameters);
  }
  return chunk(ChunkType::Change, payload);
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
    payload.put(surface.material.stiffness_N_per_m);
    payload.put(surface.material.frictionStatic);
    payload.put(surface.material.frictionKinetic);
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
  return chunk(ChunkType::Scene, payload);
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
  return chunk(ChunkType::Motion, payload);
}

std::vector<char> endChunk(std::uint64_t lost)
{
  ByteWriter payload;
  payload.put(lost);
  return chunk(ChunkType::End, payload);
}

std::variant<Recording, std::string> parseRecording(const std::vector<char>& bytes, const std::string& name)
{
  const std::string text(
    bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(bytes.size(), 4096)));
  const std::string start = std::string(magic) + " ";
  if (text.compare(0, start.size(), start) != 0)
  {
    return name + " is not a recording of Palpate";
  }
  const std::string version = text.substr(start.size(), text.find('\n') - start.size());
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
