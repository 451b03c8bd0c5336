// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that knows Boost.
#include "devices/arm/link/WebSocketLink.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include <boost/asio/buffers_iterator.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

namespace palpate
{
namespace
{

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;

constexpr std::size_t longestMessage = 1U << 20U, longestAnswer = 1U << 16U;
constexpr int socketWrite_ms = 20;

asio::ip::tcp::endpoint loopback(std::uint16_t port)
{
  return { asio::ip::address_v4::loopback(), port };
}

/// One thing at a time in the caller's thread. None: it is not done in that time.
template<class Begin>
std::optional<error_code> within(asio::io_context& context, int timeout_ms, Begin begin)
{
  const auto done = std::make_shared<std::optional<error_code>>(); // outlives the wait
  begin([done](error_code error, auto...) { *done = error; });
  context.restart();
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout_ms);
  while (!*done && context.run_one_until(until) > 0)
  {
  }
  return *done;
}

class WebSocketLink final : public ByteLink
{
public:
  WebSocketLink() : socket_(context_) {}
  /// Pending operations end with the socket, before the buffers to which they write.
  ~WebSocketLink() override
  {
    error_code ignored;
    this->tcp().shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
    this->tcp().close(ignored);
    this->context_.restart();
    this->context_.run_for(std::chrono::milliseconds(socketWrite_ms));
  }
  WebSocketLink(const WebSocketLink&) = delete;
  WebSocketLink& operator=(const WebSocketLink&) = delete;

  /// Empty, or a phrase.
  [[nodiscard]] std::string begin(std::uint16_t port, int timeout_ms, bool& nobodyListens)
  {
    const auto connected = within(
      this->context_, timeout_ms, [&](auto done) { this->socket_.next_layer().async_connect(loopback(port), done); });
    if (!connected || *connected)
    {
      nobodyListens = connected && *connected == asio::error::connection_refused;
      return connected ? connected->message() : "it does not accept a connection";
    }
    error_code ignored;
    this->tcp().set_option(asio::ip::tcp::no_delay(true), ignored);
    this->socket_.read_message_max(longestMessage);
    const auto greeted =
      within(this->context_, timeout_ms, [&](auto done) { this->socket_.async_handshake("127.0.0.1", "/", done); });
    return !greeted ? "it does not answer as a WebSocket" : *greeted ? greeted->message() : std::string();
  }

  bool send(std::span<const std::uint8_t> bytes) noexcept override
  {
    const auto sent = within(this->context_, socketWrite_ms,
      [&](auto done) { this->socket_.async_write(asio::buffer(bytes.data(), bytes.size()), done); });
    this->error_ = sent ? *sent : error_code(asio::error::timed_out);
    if (!sent)
    {
      error_code ignored;
      this->tcp().close(ignored); // it still reads the bytes of the caller
      this->context_.restart();
      this->context_.run_for(std::chrono::milliseconds(socketWrite_ms));
    }
    return !this->error_;
  }
  int receive(std::span<std::uint8_t> bytes, int timeout_ms) noexcept override
  {
    if (!this->reading_)
    {
      this->reading_ = true;
      this->read_.reset();
      this->buffer_.clear();
      this->socket_.async_read(this->buffer_, [this](error_code error, std::size_t) { this->read_ = error; });
    }
    this->context_.restart();
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout_ms);
    while (!this->read_ && (timeout_ms > 0 ? this->context_.run_one_until(until) : this->context_.poll_one()) > 0)
    {
    }
    if (!this->read_)
    {
      return 0;
    }
    this->reading_ = false;
    this->error_ = *this->read_;
    if (this->error_ || this->buffer_.size() > bytes.size())
    {
      return -1;
    }
    std::copy_n(asio::buffers_begin(this->buffer_.data()), this->buffer_.size(), bytes.begin());
    return static_cast<int>(this->buffer_.size());
  }
  std::string error() const override { return this->error_.message(); }
  std::string gone() const override
  {
    return "the program at the other end does not hold the connection: " + this->error();
  }
  std::string unsent() const override { return this->gone(); }
  bool keepsBorders() const noexcept override { return true; }

private:
  asio::ip::tcp::socket& tcp() { return this->socket_.next_layer(); }

  asio::io_context context_;
  beast::flat_buffer buffer_; ///< before the socket, which writes to it
  websocket::stream<asio::ip::tcp::socket> socket_;
  bool reading_ = false; ///< a message is under way
  std::optional<error_code> read_;
  error_code error_;
};

} // namespace

LoopbackSocket openLoopbackSocket(std::uint16_t port, int timeout_ms)
{
  LoopbackSocket opened;
  auto link = std::make_unique<WebSocketLink>();
  opened.problem = link->begin(port, timeout_ms, opened.nobodyListens);
  opened.link = opened.problem.empty() ? std::move(link) : nullptr;
  return opened;
}

Outcome<std::string> askLoopback(std::uint16_t port, const std::string& target, int timeout_ms)
{
  asio::io_context context;
  asio::ip::tcp::socket socket(context);
  http::request<http::empty_body> request(http::verb::get, target, 11);
  request.set(http::field::host, "127.0.0.1");
  request.set(http::field::connection, "close");
  http::response_parser<http::string_body> answer;
  answer.body_limit(longestAnswer);
  beast::flat_buffer buffer;
  const auto connected = within(context, timeout_ms, [&](auto done) { socket.async_connect(loopback(port), done); });
  const auto asked = connected && !*connected
                       ? within(context, timeout_ms, [&](auto done) { http::async_write(socket, request, done); })
                       : connected;
  const auto heard = asked && !*asked
                       ? within(context, timeout_ms, [&](auto done) { http::async_read(socket, buffer, answer, done); })
                       : asked;
  error_code ignored;
  socket.close(ignored);
  context.restart();
  context.run_for(std::chrono::milliseconds(socketWrite_ms)); // pending operations still have their data here
  if (!heard || *heard)
  {
    return { {}, heard ? heard->message() : "it does not answer" };
  }
  return answer.get().result() == http::status::ok ? Outcome<std::string>{ answer.get().body(), {} }
                                                   : Outcome<std::string>{ {}, "it does not know the question" };
}

} // namespace palpate
