// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/arm/FakeService.h"

#include <chrono>
#include <cstdio>
#include <sys/socket.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>

namespace palpate::test
{

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Json = nlohmann::json;
using asio::ip::tcp;
using boost::system::error_code;
using Answer = FakeService::Says::Answer;
using Asked = FakeService::Says::Asked;

namespace
{

constexpr int session = 7;

Json vectorOf(const Vec3& v)
{
  return { { "x", v.x() }, { "y", v.y() }, { "z", v.z() } };
}

Json turnOf(const Quat& q)
{
  return { { "w", q.w() }, { "x", q.x() }, { "y", q.y() }, { "z", q.z() } };
}

} // namespace

struct FakeService::Parts
{
  asio::io_context context;
  tcp::acceptor states{ context, { asio::ip::address_v4::loopback(), 0 } };
  tcp::acceptor events{ context, { asio::ip::address_v4::loopback(), 0 } };
  tcp::acceptor questions{ context, { asio::ip::address_v4::loopback(), 0 } };
  mutable std::mutex mutex; ///< of the members below
  Says says;
  Vec3 force_N = Vec3::Zero();
  bool identity = false;
  std::string name;
  int messages = 0, answered = 0;
  std::vector<int> sockets;
  bool over = false;
  std::vector<std::thread> threads;

  Json stateOf()
  {
    const Vec3 one = Vec3::Ones();
    const Vec3 shift = this->identity && !this->says.keepsTransform ? Vec3(Vec3::Zero()) : Vec3(0.5, 0.0, 0.0);
    const Json transform{ { "position", vectorOf(shift) }, { "rotation", turnOf(Quat::Identity()) },
      { "scale", vectorOf(one) } };
    const Json arm{ { "device_id", this->says.answer == Answer::OtherArm ? "FFFF" : "049D" },
      { "config", { { "type", this->says.type }, { "preset", this->says.preset } } },
      { "state", { { "cursor_position", vectorOf(this->says.position_m) },
                   { "cursor_velocity", vectorOf(this->says.velocity_m_per_s) }, { "transform", transform } } },
      { "status", { { "calibrated", this->says.calibrated }, { "ready", this->says.ready },
                    { "in_use", this->says.inUse }, { "power_supply", this->says.power } } } };
    const unsigned b = this->says.buttons;
    const Json grip{ { "device_id", "62" },
      { "state", { { "orientation", turnOf(this->says.turn) },
                   { "buttons", { { "a", (b & 1) != 0 }, { "b", (b & 2) != 0 }, { "c", (b & 4) != 0 } } } } } };
    return { { "session_id", session }, { "inverse3", Json::array({ arm }) },
      { "wireless_verse_grip", Json::array({ grip }) } };
  }

  void hear(const std::string& message)
  {
    const Json json = Json::parse(message, nullptr, false);
    const std::lock_guard lock(this->mutex);
    ++this->messages;
    this->force_N.setZero();
    if (json.contains("session"))
    {
      this->name = json["session"]["configure"]["profile"]["name"].get<std::string>();
    }
    const Json commands = json["inverse3"][0]["commands"];
    if (commands.contains("set_transform"))
    {
      const Json t = commands["set_transform"]["transform"];
      this->identity = t["position"]["x"] == 0.0 && t["rotation"]["w"] == 1.0 && t["scale"]["x"] == 1.0;
    }
    int major = 0, minor = 0;
    std::sscanf(this->says.version.c_str(), "%d.%d", &major, &minor);
    const std::string key = major > 3 || (major == 3 && minor >= 5) ? "vector" : "values";
    if (commands.contains("set_cursor_force") && commands["set_cursor_force"].contains(key))
    {
      const Json v = commands["set_cursor_force"][key];
      this->force_N = { v["x"].get<double>(), v["y"].get<double>(), v["z"].get<double>() };
    }
  }

  /// False: the connection ends.
  bool answer(websocket::stream<tcp::socket>& socket, error_code& error)
  {
    std::unique_lock lock(this->mutex);
    std::string text = this->stateOf().dump();
    const Answer answer = this->says.answer;
    const std::vector<std::string> between = this->says.between;
    lock.unlock();
    for (const std::string& other : between)
    {
      socket.write(asio::buffer(other), error);
    }
    switch (answer)
    {
      case Answer::Nothing:
        return true;
      case Answer::Broken:
        text.resize(text.size() / 2);
        break;
      case Answer::Huge:
        text.resize(2U << 20U, ' ');
        break;
      case Answer::Endless:
        socket.write_some(false, asio::buffer(text.data(), text.size() / 2), error);
        return !error;
      case Answer::Closes:
        socket.next_layer().shutdown(tcp::socket::shutdown_both, error);
        return false;
      default:
        break;
    }
    socket.write(asio::buffer(text), error);
    return !error;
  }

  void tellVersion(tcp::socket& plain, unsigned protocol, Asked Says::*how)
  {
    std::unique_lock lock(this->mutex);
    const Asked asked = this->says.*how;
    http::response<http::string_body> version(
      asked == Asked::KnowsNot ? http::status::not_found : http::status::ok, protocol);
    version.body() = Json{ { "version", asked == Asked::KnowsNot ? "none" : this->says.version } }.dump();
    lock.unlock();
    error_code error;
    if (asked == Asked::Keeps)
    {
      char nothing = 0;
      plain.read_some(asio::buffer(&nothing, 1), error); // until the other end lets go
    }
    else if (asked != Asked::Closes)
    {
      version.prepare_payload();
      http::write(plain, version, error);
    }
  }

  void serveQuestions(tcp::socket plain)
  {
    beast::flat_buffer buffer;
    http::request<http::string_body> request;
    error_code error;
    http::read(plain, buffer, request, error);
    if (!error)
    {
      this->tellVersion(plain, request.version(), &Says::askedElsewhere);
    }
  }

  void serveStates(tcp::socket plain)
  {
    beast::flat_buffer buffer;
    http::request<http::string_body> request;
    error_code error;
    http::read(plain, buffer, request, error);
    if (error)
    {
      return;
    }
    if (!websocket::is_upgrade(request))
    {
      this->tellVersion(plain, request.version(), &Says::asked);
      return;
    }
    websocket::stream<tcp::socket> socket(std::move(plain));
    socket.accept(request, error);
    std::unique_lock lock(this->mutex);
    const std::string inventory = this->stateOf().dump();
    lock.unlock();
    socket.write(asio::buffer(inventory), error);
    while (!error)
    {
      beast::flat_buffer message;
      socket.read(message, error);
      if (!error)
      {
        this->hear(beast::buffers_to_string(message.data()));
        if (!this->answer(socket, error))
        {
          return;
        }
        const std::lock_guard counting(this->mutex);
        ++this->answered;
      }
    }
  }

  void serveEvents(tcp::socket plain)
  {
    websocket::stream<tcp::socket> socket(std::move(plain));
    error_code error;
    socket.accept(error);
    for (bool ends = false; !error && !ends;)
    {
      std::vector<std::string> happened;
      {
        const std::lock_guard lock(this->mutex);
        std::swap(happened, this->says.events);
        ends = this->over;
      }
      for (const std::string& event : happened)
      {
        socket.write(asio::buffer(event), error);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  void accept(tcp::acceptor& acceptor, void (Parts::*serve)(tcp::socket))
  {
    for (;;)
    {
      tcp::socket socket(this->context);
      error_code error;
      acceptor.accept(socket, error);
      const std::lock_guard lock(this->mutex);
      if (error || this->over)
      {
        return;
      }
      this->sockets.push_back(::dup(socket.native_handle()));
      this->threads.emplace_back([this, serve, s = std::move(socket)]() mutable { (this->*serve)(std::move(s)); });
    }
  }
};

FakeService::FakeService() : parts_(std::make_unique<Parts>())
{
  Parts& parts = *this->parts_;
  std::thread states([&parts] { parts.accept(parts.states, &Parts::serveStates); });
  std::thread events([&parts] { parts.accept(parts.events, &Parts::serveEvents); });
  std::thread questions([&parts] { parts.accept(parts.questions, &Parts::serveQuestions); });
  const std::lock_guard lock(parts.mutex);
  parts.threads.push_back(std::move(states));
  parts.threads.push_back(std::move(events));
  parts.threads.push_back(std::move(questions));
}

FakeService::~FakeService()
{
  Parts& parts = *this->parts_;
  std::vector<std::thread> threads;
  {
    const std::lock_guard lock(parts.mutex);
    parts.over = true;
    for (const int socket : parts.sockets)
    {
      ::shutdown(socket, SHUT_RDWR);
      ::close(socket);
    }
    ::shutdown(parts.states.native_handle(), SHUT_RDWR);
    ::shutdown(parts.events.native_handle(), SHUT_RDWR);
    ::shutdown(parts.questions.native_handle(), SHUT_RDWR);
    threads = std::move(parts.threads);
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

std::uint16_t FakeService::port() const noexcept
{
  return this->parts_->states.local_endpoint().port();
}

std::uint16_t FakeService::eventPort() const noexcept
{
  return this->parts_->events.local_endpoint().port();
}

std::uint16_t FakeService::questionPort() const noexcept
{
  return this->parts_->questions.local_endpoint().port();
}

std::string FakeService::eventOf(const std::string& name, const std::string& device, const std::string& reason)
{
  Json data{ { "device_family", "inverse3" }, { "device_id", device } };
  if (!reason.empty())
  {
    data["reason"] = reason;
  }
  return Json{ { "name", name }, { "category", "device" }, { "level", "warning" }, { "data", data } }.dump();
}

std::vector<std::string> FakeService::messagesOfOthers()
{
  const Vec3 elsewhere_m(0.3, 0.3, 0.3);
  return { eventOf("device-connected", "62"), stateOf("FFFF", 7, elsewhere_m), stateOf("049D", 8, elsewhere_m),
    R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{"type":"inverse3"}}]})", R"({"session_id":7})" };
}

std::string FakeService::stateOf(const std::string& device, int ofSession, const Vec3& position_m)
{
  const Json state{ { "cursor_position", vectorOf(position_m) }, { "cursor_velocity", vectorOf(Vec3::Zero()) } };
  const Json arm{ { "device_id", device }, { "state", state },
    { "status", { { "calibrated", true }, { "ready", true } } } };
  return Json{ { "session_id", ofSession }, { "inverse3", Json::array({ arm }) } }.dump();
}

void FakeService::say(const Says& says)
{
  const std::lock_guard lock(this->parts_->mutex);
  this->parts_->says = says;
}

Vec3 FakeService::force_N() const
{
  const std::lock_guard lock(this->parts_->mutex);
  return this->parts_->force_N;
}

bool FakeService::transformIsIdentity() const
{
  const std::lock_guard lock(this->parts_->mutex);
  return this->parts_->identity;
}

std::string FakeService::programsName() const
{
  const std::lock_guard lock(this->parts_->mutex);
  return this->parts_->name;
}

int FakeService::messages() const
{
  const std::lock_guard lock(this->parts_->mutex);
  return this->parts_->messages;
}

int FakeService::answered() const
{
  const std::lock_guard lock(this->parts_->mutex);
  return this->parts_->answered;
}

} // namespace palpate::test
