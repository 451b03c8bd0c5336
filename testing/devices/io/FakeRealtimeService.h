// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <thread>

#include <sys/types.h>

#include "devices/io/broker/DBusBroker.h"

struct DBusMessage;
struct DBusConnection;

namespace palpate::test
{

/// A message bus for this test alone.
class PrivateBus
{
public:
  PrivateBus();
  ~PrivateBus();
  PrivateBus(const PrivateBus&) = delete;
  PrivateBus& operator=(const PrivateBus&) = delete;

  /// Empty: it could not be started.
  [[nodiscard]] const std::string& address() const { return this->address_; }

private:
  pid_t process_ = -1;
  std::string address_;
};

/// The service's reaction to a request.
enum class Manner : std::uint8_t
{
  Grants,   ///< as RealtimeKit does: only if RLIMIT_RTTIME is low enough, and as far as the system lets the test
  Refuses,  ///< with a reason of two lines
  IsSilent, ///< takes every question and never answers
  Lies,     ///< agrees and does nothing
  Babbles,  ///< gives texts where numbers belong
};

/// The last request.
struct Asked
{
  std::uint64_t process = 0; ///< 0: the method has no such argument
  std::uint64_t thread = 0;
  std::uint32_t priority = 0;
  std::uint64_t hardLimit_us = 0; ///< RLIMIT_RTTIME at that moment
  bool granted = false;           ///< the system let the service do it
};

/// Stands in for RealtimeKit or the portal, in a thread of its own.
class FakeRealtimeService
{
public:
  static constexpr std::int32_t mostPriority = 20;
  static constexpr std::int64_t longestRun_us = 200'000;

  FakeRealtimeService(const DBusService& service, Manner manner);

  /// Valid once the question has been answered.
  [[nodiscard]] const Asked& asked() const { return this->asked_; }

private:
  void serve(const std::stop_token& stop);
  [[nodiscard]] DBusMessage* answer(DBusMessage* question);
  [[nodiscard]] DBusMessage* property(DBusMessage* question) const;
  [[nodiscard]] DBusMessage* makeRealtime(DBusMessage* question);

  DBusService service_;
  Manner manner_;
  DBusConnection* connection_ = nullptr;
  Asked asked_;
  std::jthread thread_;
};

} // namespace palpate::test
