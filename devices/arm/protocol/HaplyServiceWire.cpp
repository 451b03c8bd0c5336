// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/protocol/HaplyServiceWire.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{

using Json = nlohmann::json;

constexpr double farthest = 1e3; ///< [m, N]: beyond it nothing is a device's
constexpr std::array<const char*, 4> safetyEvents{ "ebrake_triggered", "fod_stage_changed", "stall_detected",
  "stability_ceiling" };
constexpr std::array<const char*, 2> otherEvents{ "device-disconnected", "device-busy" };

/// Null where there is no such member.
const Json& memberOf(const Json& json, const char* name)
{
  static const Json none;
  const auto found = json.is_object() ? json.find(name) : json.end();
  return json.is_object() && found != json.end() ? *found : none;
}

std::optional<double> numberOf(const Json& json, const char* name)
{
  const Json& member = memberOf(json, name);
  const double value = member.is_number() ? member.get<double>() : farthest + 1.0;
  return std::fabs(value) <= farthest ? std::optional(value) : std::nullopt;
}

std::optional<Vec3> vectorOf(const Json& json)
{
  const auto x = numberOf(json, "x"), y = numberOf(json, "y"), z = numberOf(json, "z");
  return x && y && z ? std::optional(Vec3(*x, *y, *z)) : std::nullopt;
}

/// None: no turn.
std::optional<Quat> turnOf(const Json& json)
{
  const std::optional<Vec3> v = vectorOf(json);
  const std::optional<double> w = numberOf(json, "w");
  const Quat q = v && w ? Quat(*w, v->x(), v->y(), v->z()) : Quat(0.0, 0.0, 0.0, 0.0);
  constexpr double tooShort = 0.1;
  return q.norm() > tooShort ? std::optional(q.normalized()) : std::nullopt;
}

bool isTrue(const Json& json, const char* name)
{
  const Json& member = memberOf(json, name);
  return member.is_boolean() && member.get<bool>();
}

std::string textOf(const Json& json, const char* name)
{
  const Json& member = memberOf(json, name);
  return member.is_string() ? member.get<std::string>() : std::string();
}

/// Devices of a kind; empty: there are none.
const Json& devicesOf(const Json& json, const char* kind)
{
  static const Json none = Json::array();
  const Json& all = memberOf(json, kind);
  return all.is_array() ? all : none;
}

/// Empty: the message says none.
std::string sessionOf(const Json& json)
{
  const Json& session = memberOf(json, "session_id");
  return session.is_null() ? std::string() : session.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The device in a message of this session; null: it has no state of that device.
const Json& stateOf(const Json& json, const std::string& device, const std::string& session)
{
  static const Json none;
  const Json& all = devicesOf(json, "inverse3");
  const std::string said = sessionOf(json);
  const bool isOurs = said.empty() || session.empty() || said == session;
  const auto found = std::find_if(all.begin(), all.end(),
    [&device](const Json& one) { return textOf(one, "device_id") == device && !memberOf(one, "state").is_null(); });
  return isOurs && found != all.end() ? *found : none;
}

/// The device that an event is about; empty: it names none.
std::string deviceOfEvent(const Json& event)
{
  const std::string inData = textOf(memberOf(event, "data"), "device_id");
  return inData.empty() ? textOf(event, "device_id") : inData;
}

bool isIdentity(const Json& transform)
{
  constexpr double nearly = 1e-6;
  const std::optional<Vec3> position = vectorOf(memberOf(transform, "position"));
  const std::optional<Quat> rotation = turnOf(memberOf(transform, "rotation"));
  const std::optional<Vec3> scale = vectorOf(memberOf(transform, "scale"));
  return position && rotation && scale && position->norm() < nearly && rotation->vec().norm() < nearly &&
         (*scale - Vec3::Ones()).norm() < nearly;
}

/// Buttons and rotation of a grip, whose messages differ by kind.
void addGrip(const Json& json, WireReading& reading)
{
  for (const char* const kind : { "wireless_verse_grip", "verse_grip" })
  {
    const Json& grips = devicesOf(json, kind);
    if (grips.empty())
    {
      continue;
    }
    const Json& inner = memberOf(grips[0], "state");
    const Json& state = inner.is_null() ? grips[0] : inner;
    const Json& buttons = memberOf(state, "buttons");
    reading.buttons = (isTrue(buttons, "a") || isTrue(state, "button") ? 1U : 0U) | (isTrue(buttons, "b") ? 2U : 0U) |
                      (isTrue(buttons, "c") ? 4U : 0U);
    if (const std::optional<Quat> q = turnOf(memberOf(state, "orientation")); q && reading.pose_D)
    {
      reading.pose_D->q = *q;
    }
    return;
  }
}

void addStatus(const Json& device, WireReading& reading)
{
  const Json& status = memberOf(device, "status");
  reading.homed = isTrue(status, "ready") && isTrue(status, "calibrated");
  const Json& power = memberOf(status, "power_supply");
  if (power.is_boolean() && !power.get<bool>())
  {
    reading.stopped = "the device has no power supply: plug it in";
  }
  const Json& transform = memberOf(memberOf(device, "state"), "transform");
  if (!transform.is_null() && !isIdentity(transform))
  {
    reading.stopped = "another program moves the space of this device in the vendor's service: close that program";
  }
}

std::string commands(const std::string& device, const Json& what, Json message = Json::object())
{
  message["inverse3"] = Json::array({ { { "device_id", device }, { "commands", what } } });
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace

WireBytes HaplyServiceWire::greeting() const
{
  const Json zero{ { "x", 0.0 }, { "y", 0.0 }, { "z", 0.0 } }, one{ { "x", 1.0 }, { "y", 1.0 }, { "z", 1.0 } };
  const Json none{ { "w", 1.0 }, { "x", 0.0 }, { "y", 0.0 }, { "z", 0.0 } };
  const Json identity{ { "transform", { { "position", zero }, { "rotation", none }, { "scale", one } } } };
  const Json session{ { "configure", { { "profile", { { "name", "Palpate" } } } } },
    { "force_render_full_state", Json::object() } };
  const std::string text = commands(this->device_, { { "set_transform", identity } }, { { "session", session } });
  return { text.begin(), text.end() };
}

void HaplyServiceWire::encode(const WireOrder& order, WireBytes& bytes) const
{
  Vec3 force_N = order.wrench_D.force;
  force_N = force_N.allFinite() ? force_N : Vec3(Vec3::Zero());
  const Json vector{ { "x", force_N.x() }, { "y", force_N.y() }, { "z", force_N.z() } };
  const std::string text =
    commands(this->device_, { { "set_cursor_force", { { this->vector_ ? "vector" : "values", vector } } } });
  bytes.assign(text.begin(), text.end());
}

std::optional<WireReading> HaplyServiceWire::decode(std::span<const std::uint8_t> answer) const
{
  const Json json = Json::parse(answer.begin(), answer.end(), nullptr, false);
  const Json& device = stateOf(json, this->device_, this->session_);
  const Json& state = memberOf(device, "state");
  const std::optional<Vec3> position = vectorOf(memberOf(state, "cursor_position"));
  if (!position)
  {
    return std::nullopt;
  }
  WireReading reading;
  reading.pose_D = Pose{ *position - this->centre_D_, Quat::Identity() };
  if (const std::optional<Vec3> velocity = vectorOf(memberOf(state, "cursor_velocity")))
  {
    reading.velocity_D = Twist{ *velocity, Vec3::Zero() };
  }
  addStatus(device, reading);
  addGrip(json, reading);
  return reading;
}

bool HaplyServiceWire::isOthers(std::span<const std::uint8_t> message) const
{
  const Json json = Json::parse(message.begin(), message.end(), nullptr, false);
  return json.is_object() && stateOf(json, this->device_, this->session_).is_null();
}

std::string haplySession(std::string_view message)
{
  return sessionOf(Json::parse(message.begin(), message.end(), nullptr, false));
}

std::optional<std::vector<HaplyDevice>> haplyInventory(std::string_view message)
{
  const Json json = Json::parse(message.begin(), message.end(), nullptr, false);
  if (!json.is_object())
  {
    return std::nullopt;
  }
  std::vector<HaplyDevice> all;
  for (const Json& device : devicesOf(json, "inverse3"))
  {
    const Json &config = memberOf(device, "config"), &status = memberOf(device, "status");
    HaplyDevice one{ textOf(device, "device_id"), textOf(config, "type"), isTrue(status, "in_use"),
      textOf(config, "preset").ends_with("_centered"), isTrue(status, "ready"), isTrue(status, "calibrated") };
    if (!one.id.empty())
    {
      all.push_back(std::move(one));
    }
  }
  return all;
}

/// Of JSON its member "version"; of another text, whatever stands around it: the first number, a point, a number.
std::optional<bool> haplyHasVector(std::string_view answer)
{
  const std::string version = textOf(Json::parse(answer.begin(), answer.end(), nullptr, false), "version");
  const std::string_view text = version.empty() ? answer : std::string_view(version);
  const auto digit = [&text](std::size_t at)
  { return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0; };
  for (std::size_t at = 0; at < text.size(); ++at)
  {
    if (digit(at) && !(at > 0 && (digit(at - 1) || text[at - 1] == '.')) && at + 2 < text.size() &&
        text[at + 1] == '.' && digit(at + 2))
    {
      const int major = text[at] - '0', minor = text[at + 2] - '0';
      const bool longer = digit(at + 3);
      return major > 3 || (major == 3 && (minor >= 5 || longer));
    }
  }
  return std::nullopt;
}

std::string haplyStop(std::string_view message, const std::string& device)
{
  const auto says = [message](const char* name) { return message.find(name) != std::string_view::npos; };
  const auto* const safety = std::find_if(safetyEvents.begin(), safetyEvents.end(), says);
  const auto* const other = std::find_if(otherEvents.begin(), otherEvents.end(), says);
  const std::string named = deviceOfEvent(Json::parse(message.begin(), message.end(), nullptr, false));
  const bool isOthers = !named.empty() && named != device;
  return safety != safetyEvents.end()              ? *safety
         : says("device-safety-triggered")         ? "device-safety-triggered"
         : other != otherEvents.end() && !isOthers ? *other
                                                   : "";
}

} // namespace palpate
