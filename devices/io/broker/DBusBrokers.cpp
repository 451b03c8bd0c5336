// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <utility>

#include "devices/io/broker/DBusBroker.h"

namespace palpate
{
namespace
{

std::string variable(const char* name)
{
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string systemBus()
{
  const std::string named = variable("DBUS_SYSTEM_BUS_ADDRESS");
  return named.empty() ? "unix:path=/run/dbus/system_bus_socket" : named;
}

std::string sessionBus()
{
  const std::string named = variable("DBUS_SESSION_BUS_ADDRESS"), folder = variable("XDG_RUNTIME_DIR");
  return named.empty() && !folder.empty() ? "unix:path=" + folder + "/bus" : named;
}

} // namespace

DBusService realtimeKit(std::string systemBus)
{
  return { "RTKit", std::move(systemBus), "org.freedesktop.RealtimeKit1", "/org/freedesktop/RealtimeKit1",
    "org.freedesktop.RealtimeKit1", "MakeThreadRealtime", false };
}

DBusService realtimePortal(std::string sessionBus)
{
  return { "desktop portal", std::move(sessionBus), "org.freedesktop.portal.Desktop", "/org/freedesktop/portal/desktop",
    "org.freedesktop.portal.Realtime", "MakeThreadRealtimeWithPID", true };
}

DBusBroker::DBusBroker(DBusService service) : service_(std::move(service)) {}

RealtimeBrokers systemBrokers()
{
  return { std::make_shared<DBusBroker>(realtimeKit(systemBus())),
    std::make_shared<DBusBroker>(realtimePortal(sessionBus())) };
}

} // namespace palpate
