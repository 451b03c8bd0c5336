// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/realtime/RealtimeThread.h"

namespace palpate
{

/// A service on D-Bus that makes threads real-time ones.
struct DBusService
{
  std::string name;    ///< as a person knows it
  std::string address; ///< of the bus; empty: there is none
  std::string destination;
  std::string path;
  std::string interface;
  std::string method;        ///< of that interface
  bool takesProcess = false; ///< the method's first argument is the process; thread and priority follow
  int patience_ms = 1000;    ///< for everything together
};

/// RealtimeKit, directly: for programs of a person who sits at the computer.
[[nodiscard]] DBusService realtimeKit(std::string systemBus);
/// The desktop portal, which passes it on: for programs in a sandbox.
[[nodiscard]] DBusService realtimePortal(std::string sessionBus);

/// Asks such a service. What it wants first, a low RLIMIT_RTTIME, is set only when it has answered. Without libdbus in
/// this build it refuses and says so.
class DBusBroker final : public RealtimeBroker
{
public:
  explicit DBusBroker(DBusService service);

  [[nodiscard]] std::string name() const override { return this->service_.name; }
  [[nodiscard]] Granted request(int wantedPriority) override;

private:
  DBusService service_;
};

/// Those of this computer, to be asked in that order: RealtimeKit, the portal. Reads the environment: not while another
/// thread writes it.
[[nodiscard]] RealtimeBrokers systemBrokers();

} // namespace palpate
