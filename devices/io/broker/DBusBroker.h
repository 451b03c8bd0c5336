// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/realtime/RealtimeThread.h"

namespace palpate
{

/// A service on D-Bus that makes threads real-time ones.
struct DBusService
{
  std::string name;    ///< name for the user
  std::string address; ///< of the bus; empty: there is none
  std::string destination;
  std::string path;
  std::string interface;
  std::string method;        ///< of that interface
  bool takesProcess = false; ///< the method's first argument is the process; thread and priority follow
  int patience_ms = 1000;    ///< for all requests together
};

/// RealtimeKit itself: for programs of a user who sits at the computer.
[[nodiscard]] DBusService realtimeKit(std::string systemBus);
/// The desktop portal, which forwards the request: for programs in a sandbox.
[[nodiscard]] DBusService realtimePortal(std::string sessionBus);

/// Asks such a service. The low RLIMIT_RTTIME that the service requires is set only after its answer. Without libdbus
/// in this build each request is refused with that reason.
class DBusBroker final : public RealtimeBroker
{
public:
  explicit DBusBroker(DBusService service);

  [[nodiscard]] std::string name() const override { return this->service_.name; }
  [[nodiscard]] Granted request(int wantedPriority) override;

private:
  DBusService service_;
};

/// The brokers of this computer in the order in which they are asked: RealtimeKit, the portal. Reads the environment:
/// not while another thread writes it.
[[nodiscard]] RealtimeBrokers systemBrokers();

} // namespace palpate
