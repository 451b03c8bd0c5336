// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/io/FakeRealtimeService.h"

#include <array>
#include <stdexcept>

#include <csignal>
#include <dbus/dbus.h>
#include <sched.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace palpate::test
{
namespace
{

std::string firstLine(int file)
{
  std::string line;
  char c = 0;
  while (read(file, &c, 1) == 1 && c != '\n')
  {
    line += c;
  }
  return line;
}

} // namespace

PrivateBus::PrivateBus()
{
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0)
  {
    return;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  std::array<std::string, 4> words{ PALPATE_DBUS_DAEMON, "--session", "--nofork", "--print-address" };
  std::array<char*, 5> arguments{ words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr };
  const int refused = posix_spawn(&this->process_, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  this->address_ = refused == 0 ? firstLine(ends[0]) : "";
  close(ends[0]);
}

PrivateBus::~PrivateBus()
{
  if (this->process_ > 0)
  {
    kill(this->process_, SIGTERM);
    waitpid(this->process_, nullptr, 0);
  }
}

FakeRealtimeService::FakeRealtimeService(const DBusService& service, Manner manner)
  : service_(service), manner_(manner), connection_(dbus_connection_open_private(service.address.c_str(), nullptr))
{
  if (this->connection_ == nullptr || !dbus_bus_register(this->connection_, nullptr) ||
      dbus_bus_request_name(this->connection_, service.destination.c_str(), 0, nullptr) < 0)
  {
    throw std::runtime_error("the test's own bus does not work");
  }
  dbus_connection_set_exit_on_disconnect(this->connection_, FALSE);
  this->thread_ = std::jthread([this](const std::stop_token& stop) { this->serve(stop); });
}

void FakeRealtimeService::serve(const std::stop_token& stop)
{
  constexpr int pause_ms = 5;
  while (!stop.stop_requested() && dbus_connection_read_write(this->connection_, pause_ms))
  {
    while (DBusMessage* const question = dbus_connection_pop_message(this->connection_))
    {
      DBusMessage* const reply =
        dbus_message_get_type(question) == DBUS_MESSAGE_TYPE_METHOD_CALL && this->manner_ != Manner::IsSilent
          ? this->answer(question)
          : nullptr;
      if (reply != nullptr)
      {
        dbus_connection_send(this->connection_, reply, nullptr);
        dbus_message_unref(reply);
      }
      dbus_message_unref(question);
    }
  }
  dbus_connection_close(this->connection_);
  dbus_connection_unref(this->connection_);
}

DBusMessage* FakeRealtimeService::answer(DBusMessage* question)
{
  if (dbus_message_is_method_call(question, DBUS_INTERFACE_PROPERTIES, "Get"))
  {
    return this->property(question);
  }
  if (dbus_message_is_method_call(question, this->service_.interface.c_str(), this->service_.method.c_str()))
  {
    return this->makeRealtime(question);
  }
  return dbus_message_new_error(question, DBUS_ERROR_UNKNOWN_METHOD, "no such method");
}

DBusMessage* FakeRealtimeService::property(DBusMessage* question) const
{
  const char *interface = nullptr, *name = nullptr, *text = "many";
  dbus_message_get_args(question, nullptr, DBUS_TYPE_STRING, &interface, DBUS_TYPE_STRING, &name, DBUS_TYPE_INVALID);
  const bool priority = std::string(name) == "MaxRealtimePriority";
  const dbus_int32_t most = mostPriority;
  const dbus_int64_t longest_us = longestRun_us;
  const void* const number = priority ? static_cast<const void*>(&most) : &longest_us;
  const bool babbles = this->manner_ == Manner::Babbles;
  const int type = babbles ? DBUS_TYPE_STRING : priority ? DBUS_TYPE_INT32 : DBUS_TYPE_INT64;
  const std::string signature(1, static_cast<char>(type));
  DBusMessage* const reply = dbus_message_new_method_return(question);
  DBusMessageIter at, inner;
  dbus_message_iter_init_append(reply, &at);
  dbus_message_iter_open_container(&at, DBUS_TYPE_VARIANT, signature.c_str(), &inner);
  dbus_message_iter_append_basic(&inner, type, babbles ? static_cast<const void*>(&text) : number);
  dbus_message_iter_close_container(&at, &inner);
  return reply;
}

DBusMessage* FakeRealtimeService::makeRealtime(DBusMessage* question)
{
  dbus_uint64_t process = 0, thread = 0;
  dbus_uint32_t priority = 0;
  const bool understood = this->service_.takesProcess
                            ? dbus_message_get_args(question, nullptr, DBUS_TYPE_UINT64, &process, DBUS_TYPE_UINT64,
                                &thread, DBUS_TYPE_UINT32, &priority, DBUS_TYPE_INVALID)
                            : dbus_message_get_args(question, nullptr, DBUS_TYPE_UINT64, &thread, DBUS_TYPE_UINT32,
                                &priority, DBUS_TYPE_INVALID);
  rlimit limit{};
  getrlimit(RLIMIT_RTTIME, &limit); // the asking thread is one of this process
  this->asked_ = { process, thread, priority, limit.rlim_max, false };
  if (!understood || this->manner_ == Manner::Refuses || limit.rlim_max > static_cast<rlim_t>(longestRun_us))
  {
    return dbus_message_new_error(question, DBUS_ERROR_ACCESS_DENIED, "nobody is sitting\nat this computer");
  }
  if (this->manner_ == Manner::Grants)
  {
    sched_param parameters{};
    parameters.sched_priority = static_cast<int>(priority);
    this->asked_.granted =
      sched_setscheduler(static_cast<pid_t>(thread), SCHED_RR | SCHED_RESET_ON_FORK, &parameters) == 0;
  }
  return dbus_message_new_method_return(question);
}

} // namespace palpate::test
