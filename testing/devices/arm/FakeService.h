// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate::test
{

/// A service like that of Haply's arms on a port of this computer, with one arm: an inventory on connecting, then a
/// state for each message; commands are applied once. The service understands a force by one key alone, that of its
/// version.
class FakeService
{
public:
  /// Its kind and its faults.
  struct Says
  {
    std::string version = "3.5.2";
    enum class Asked
    {
      Answers,
      KnowsNot, ///< the question: it says so
      Closes,
      Keeps, ///< the connection without an answer
    };
    Asked asked = Asked::Answers;         ///< for its version on the port of its states
    Asked askedElsewhere = Asked::Closes; ///< and on the port for questions alone, which older versions have
    std::string type = "inverse3";
    std::string preset = "defaults";
    Vec3 position_m{ 0.01, -0.1, 0.15 }, velocity_m_per_s{ 0.0, 0.02, 0.0 };
    Quat turn = Quat::Identity(); ///< of the grip
    bool ready = true, calibrated = true, inUse = false, power = true;
    bool keepsTransform = false; ///< of another program's
    unsigned buttons = 0;
    enum class Answer
    {
      State,
      Nothing,
      Broken,   ///< JSON that ends in its middle
      Huge,     ///< two megabytes
      Endless,  ///< a message that never ends
      OtherArm, ///< a state without this arm
      Closes,
    } answer = Answer::State;
    std::vector<std::string> events;  ///< to be sent once on the channel of events
    std::vector<std::string> between; ///< messages about something else, before each answer
  };

  FakeService();
  ~FakeService();
  FakeService(const FakeService&) = delete;
  FakeService& operator=(const FakeService&) = delete;

  [[nodiscard]] std::uint16_t port() const noexcept;
  [[nodiscard]] std::uint16_t eventPort() const noexcept;
  [[nodiscard]] std::uint16_t questionPort() const noexcept;
  void say(const Says& says);
  /// The force of the last message; none if it had no command that this version knows [N].
  [[nodiscard]] Vec3 force_N() const;
  [[nodiscard]] bool transformIsIdentity() const;
  [[nodiscard]] std::string programsName() const;
  [[nodiscard]] int messages() const;
  /// Those of them whose answers are on their way.
  [[nodiscard]] int answered() const;
  /// An event of that name, of one of its devices; `reason`: why a device was stopped.
  [[nodiscard]] static std::string eventOf(
    const std::string& name, const std::string& device, const std::string& reason = {});
  /// A state of that device in that session.
  [[nodiscard]] static std::string stateOf(const std::string& device, int session, const Vec3& position_m);
  /// Messages that are no answer to one of 049D's in session 7, with a hand somewhere else.
  [[nodiscard]] static std::vector<std::string> messagesOfOthers();

private:
  struct Parts; ///< Boost's

  std::unique_ptr<Parts> parts_;
};

} // namespace palpate::test
