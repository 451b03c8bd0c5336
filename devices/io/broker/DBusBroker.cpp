// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/broker/DBusBroker.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

#include <dbus/dbus.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace palpate
{
namespace
{

using Message = std::unique_ptr<DBusMessage, decltype(&dbus_message_unref)>;

/// An error of libdbus.
class Error
{
public:
  Error() { dbus_error_init(&this->error_); }
  ~Error() { dbus_error_free(&this->error_); }
  Error(const Error&) = delete;
  Error& operator=(const Error&) = delete;

  [[nodiscard]] DBusError* get() { return &this->error_; }
  [[nodiscard]] bool is(const char* name) const { return dbus_error_has_name(&this->error_, name); }
  /// The reason in one line, whatever the service wrote.
  [[nodiscard]] std::string message() const
  {
    std::string text = this->error_.message == nullptr ? "no reason given" : this->error_.message;
    std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20; }, ' ');
    return text;
  }

private:
  DBusError error_{};
};

std::string sentence(const Error& error, int patience_ms)
{
  if (error.is(DBUS_ERROR_NO_REPLY) || error.is(DBUS_ERROR_TIMEOUT))
  {
    return "it did not answer within " + std::to_string(patience_ms) + " ms";
  }
  if (error.is(DBUS_ERROR_SERVICE_UNKNOWN) || error.is(DBUS_ERROR_NAME_HAS_NO_OWNER))
  {
    return "it is not there";
  }
  return "it refused: " + error.message();
}

/// A private connection to a bus, with one deadline for all requests over it.
class Conversation
{
public:
  explicit Conversation(const DBusService& service)
    : service_(service), until_(std::chrono::steady_clock::now() + std::chrono::milliseconds(service.patience_ms))
  {
  }
  ~Conversation()
  {
    if (this->connection_ != nullptr)
    {
      dbus_connection_close(this->connection_);
      dbus_connection_unref(this->connection_);
    }
  }
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  /// Empty, or the reason for the failure.
  std::string begin()
  {
    if (this->service_.address.empty())
    {
      return "there is no bus to ask it on";
    }
    Error error;
    this->connection_ = dbus_connection_open_private(this->service_.address.c_str(), error.get());
    if (this->connection_ == nullptr)
    {
      return "its bus cannot be reached: " + error.message();
    }
    dbus_connection_set_exit_on_disconnect(this->connection_, FALSE);
    const Message hello(dbus_message_new_method_call(DBUS_SERVICE_DBUS, DBUS_PATH_DBUS, DBUS_INTERFACE_DBUS, "Hello"),
      dbus_message_unref);
    return this->ask(hello.get()) == nullptr ? this->problem_ : "";
  }

  /// An integer among the service's properties, of any width.
  std::optional<std::int64_t> property(const char* name)
  {
    const Message message(dbus_message_new_method_call(this->service_.destination.c_str(), this->service_.path.c_str(),
                            DBUS_INTERFACE_PROPERTIES, "Get"),
      dbus_message_unref);
    const char* const interface = this->service_.interface.c_str();
    if (!message || !dbus_message_append_args(
                      message.get(), DBUS_TYPE_STRING, &interface, DBUS_TYPE_STRING, &name, DBUS_TYPE_INVALID))
    {
      return std::nullopt;
    }
    const Message reply = this->ask(message.get());
    return reply ? this->number(reply.get(), name) : std::nullopt;
  }

  /// Empty, or the reason for the failure.
  std::string makeRealtime(int priority)
  {
    const Message message(dbus_message_new_method_call(this->service_.destination.c_str(), this->service_.path.c_str(),
                            this->service_.interface.c_str(), this->service_.method.c_str()),
      dbus_message_unref);
    const dbus_uint64_t process = static_cast<dbus_uint64_t>(getpid());
    const dbus_uint64_t thread = static_cast<dbus_uint64_t>(syscall(SYS_gettid));
    const dbus_uint32_t wanted = static_cast<dbus_uint32_t>(priority);
    const bool filled =
      message &&
      (!this->service_.takesProcess ||
        dbus_message_append_args(message.get(), DBUS_TYPE_UINT64, &process, DBUS_TYPE_INVALID)) &&
      dbus_message_append_args(message.get(), DBUS_TYPE_UINT64, &thread, DBUS_TYPE_UINT32, &wanted, DBUS_TYPE_INVALID);
    return filled && this->ask(message.get()) ? "" : this->problem_;
  }

  [[nodiscard]] const std::string& problem() const { return this->problem_; }

private:
  /// The answer, or null with the problem set.
  Message ask(DBusMessage* message)
  {
    const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(this->until_ - std::chrono::steady_clock::now()).count();
    Error error;
    Message reply(message == nullptr ? nullptr
                                     : dbus_connection_send_with_reply_and_block(this->connection_, message,
                                         static_cast<int>(std::max<long>(left, 1)), error.get()),
      dbus_message_unref);
    if (!reply)
    {
      this->problem_ = sentence(error, this->service_.patience_ms);
    }
    return reply;
  }

  std::optional<std::int64_t> number(DBusMessage* reply, const char* name)
  {
    this->problem_ = std::string("it gave no number as ") + name;
    DBusMessageIter at, inner;
    if (!dbus_message_iter_init(reply, &at) || dbus_message_iter_get_arg_type(&at) != DBUS_TYPE_VARIANT)
    {
      return std::nullopt;
    }
    dbus_message_iter_recurse(&at, &inner);
    const int type = dbus_message_iter_get_arg_type(&inner);
    if (type == DBUS_TYPE_INT32)
    {
      dbus_int32_t value = 0;
      dbus_message_iter_get_basic(&inner, &value);
      return value;
    }
    if (type == DBUS_TYPE_INT64)
    {
      dbus_int64_t value = 0;
      dbus_message_iter_get_basic(&inner, &value);
      return value;
    }
    return std::nullopt;
  }

  const DBusService& service_;
  std::chrono::steady_clock::time_point until_;
  DBusConnection* connection_ = nullptr;
  std::string problem_ = "there is no memory to ask it";
};

} // namespace

Granted DBusBroker::request(int wantedPriority)
{
  Conversation conversation(this->service_);
  std::string problem = conversation.begin();
  if (!problem.empty())
  {
    return { false, problem };
  }
  const std::optional<std::int64_t> most = conversation.property("MaxRealtimePriority");
  const std::optional<std::int64_t> longest_us = most ? conversation.property("RTTimeUSecMax") : std::nullopt;
  if (!longest_us)
  {
    return { false, conversation.problem() };
  }
  if (*most < 1)
  {
    return { false, "it gives no priority" };
  }
  const Granted limited = limitRealtimeRuns(*longest_us);
  if (!limited.ok)
  {
    return limited;
  }
  problem = conversation.makeRealtime(static_cast<int>(std::min<std::int64_t>(wantedPriority, *most)));
  return { problem.empty(), problem };
}

} // namespace palpate
