// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as the next answer of an arm, to a link that pushes. After bytes that are no answer of its wire, by
// conditions written here, the next order asks for no force, and the one after a good answer for the force as before.
// No order asks for more than its motors give for the largest force. First byte: whose answer it is, and whether the
// rest are the bytes or changes to a good answer, which reach further than random bytes do. With PALPATE_FUZZED_ARM all
// inputs are for the arm of that name.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "devices/arm/ArmLink.h"
#include "devices/arm/ListedArmBus.h"
#include "devices/arm/WireLine.h"
#include "devices/arm/kit/WoodenHapticsFile.h"
#include "devices/arm/protocol/FalconWire.h"
#include "devices/arm/protocol/HaplyServiceWire.h"
#include "devices/arm/protocol/TwoDiyWire.h"
#include "devices/arm/protocol/WoodenHapticsWire.h"
#include "haptics/arm/file/ArmFile.h"
#include "testing/devices/arm/ModelTime.h"
#include "testing/devices/arm/WoodenHapticsModel.h"
#include "testing/fuzz/Require.h"

namespace
{

using namespace palpate;
using Bytes = std::vector<std::uint8_t>;
using View = std::span<const std::uint8_t>;

/// A link that answers a request with these bytes, so many at a time.
class AnsweringLink final : public ByteLink
{
public:
  struct Talk
  {
    Bytes asked, answer;
    std::size_t piece = 0; ///< 0: all at once
  };
  AnsweringLink(std::shared_ptr<Talk> talk, bool keepsBorders) : talk_(std::move(talk)), keepsBorders_(keepsBorders) {}

  bool send(View bytes) noexcept override
  {
    this->talk_->asked.assign(bytes.begin(), bytes.end());
    this->at_ = 0;
    return true;
  }
  int receive(std::span<std::uint8_t> bytes, int /*timeout_ms*/) noexcept override
  {
    const std::size_t left = this->talk_->answer.size() - std::min(this->at_, this->talk_->answer.size());
    const std::size_t count = std::min({ left, bytes.size(), this->talk_->piece != 0 ? this->talk_->piece : left });
    std::copy_n(this->talk_->answer.begin() + static_cast<std::ptrdiff_t>(this->at_), count, bytes.begin());
    this->at_ += count;
    return static_cast<int>(count);
  }
  std::string error() const override { return "none"; }
  bool keepsBorders() const noexcept override { return this->keepsBorders_; }

private:
  std::shared_ptr<Talk> talk_;
  bool keepsBorders_;
  std::size_t at_ = 0;
};

/// A kind of arm, as its kit has it.
struct Kind
{
  const char* name;
  ArmSetup setup;
  std::shared_ptr<const WireProtocol> wire;
  bool keepsBorders;                     ///< of messages; else its answers come in pieces
  Bytes inPose, good;                    ///< answers that push, once its counters are set
  std::function<bool(View)> mayBeAnswer; ///< else no force follows
  std::function<bool(View)> isLimited;   ///< an order, for a force of at most 1 N
};

Bytes bytesOf(const std::string& text)
{
  return { text.begin(), text.end() };
}

double numberAt(View bytes, std::size_t at)
{
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8U));
}

float floatAt(View bytes, std::size_t at)
{
  float value = 0.0F;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// Is there a message of that length anywhere?
bool hasWindow(View bytes, std::size_t length, const std::function<bool(View)>& isMessage)
{
  for (std::size_t at = 0; at + length <= bytes.size(); ++at)
  {
    if (isMessage(bytes.subspan(at, length)))
    {
      return true;
    }
  }
  return false;
}

constexpr double longestLever_m = 0.7; ///< of these arms, whatever their posture

Kind woodenHaptics()
{
  const Outcome<WiredArm> arm = readWoodenHapticsFile(test::WoodenHapticsModel::file());
  require(arm.ok());
  const Bytes answer{ 0, 0, 0, 0, 0x70, 0x17, 0, 0, 0, 0, 0, 0, 0, 0 }; // 0 0 6000
  return { "woodenhaptics", setupOf(arm.value), std::make_shared<WoodenHapticsWire>(constantsOf(arm.value.plan), true),
    true, answer, answer, [](View bytes) { return bytes.size() >= 14; },
    [](View order)
    {
      constexpr double capstanOverBody = 0.010 / 0.120, kt = 0.0259;
      const double most_mA = 1e3 * longestLever_m * capstanOverBody / kt + 0.5;
      bool within = order.size() == 14;
      for (std::size_t i = 0; i < 3 && within; ++i)
      {
        within =
          std::fabs(numberAt(order, 2 * i)) <= (numberAt(order, 6) == 1 ? 0.0 : most_mA) || numberAt(order, 6) == 1;
      }
      return within;
    } };
}

ArmSetup setupOf(const char* arm)
{
  const Outcome<ArmPlan> plan = readArmFile(std::string(PALPATE_ARMS) + "/" + arm + ".json");
  require(plan.ok());
  ArmSetup setup;
  setup.plan = plan.value;
  setup.force_N = { 1.0, true };
  return setup;
}

Kind falcon()
{
  ArmSetup setup = setupOf("falcon");
  setup.counterBits = 16;
  setup.homing = "home it";
  const auto isPacket = [](View packet)
  {
    const auto isNibble = [](std::uint8_t c) { return c >= 'A' && c < 'A' + 16; };
    return packet[0] == '<' && packet[15] == '>' && std::all_of(packet.begin() + 1, packet.begin() + 13, isNibble) &&
           packet[13] >= 'A' + 0x70 && packet[13] < 'A' + 0x80;
  };
  const Bytes answer = bytesOf(std::string("<AAAAAAAAAAAA") + static_cast<char>('A' + 0x70) + "A>");
  return { "falcon", setup, std::make_shared<FalconWire>(), false, answer, answer,
    [isPacket](View bytes) { return hasWindow(bytes, 16, isPacket); },
    [](View order)
    {
      constexpr double most = 10000.0 * longestLever_m;
      bool within = order.size() == 16 && order[0] == '<' && order[15] == '>';
      for (std::size_t at = 1; at < 13 && within; at += 4)
      {
        int number = 0;
        for (std::size_t k = 0; k < 4; ++k)
        {
          number |= (order[at + k] - 'A') << 4 * k;
        }
        within = std::abs(number >= 0x8000 ? number - 0x10000 : number) <= most;
      }
      return within;
    } };
}

Kind twoDiy()
{
  ArmSetup setup = setupOf("pantograph");
  setup.tellsAngles = true;
  setup.pose = "stretch it";
  setup.counters = { 180, 0 };
  setup.poseTolerance = 3.0;
  const auto isAnswer = [](View answer)
  { return answer[0] == 5 && std::fabs(floatAt(answer, 1)) <= 7200.0 && std::fabs(floatAt(answer, 5)) <= 7200.0; };
  const TwoDiyWire::Setup board{ 5, {}, {}, { 180.0, 0.0 }, { 13824.0, 13824.0 } };
  return { "2diy", setup, std::make_shared<TwoDiyWire>(board), false,
    { 5, 0, 0, 0x34, 0x43, 0, 0, 0, 0 },       // 180 and 0 degrees
    { 5, 0, 0, 0x0C, 0x43, 0, 0, 0x20, 0x42 }, // 140 and 40
    [isAnswer](View bytes) { return hasWindow(bytes, 9, isAnswer); },
    [](View order)
    {
      const std::size_t at = order.size() - 8; // behind a set-up, if there is one
      return order.size() >= 10 && std::fabs(floatAt(order, at)) <= 0.1231 &&
             std::fabs(floatAt(order, at + 4)) <= 0.1231;
    } };
}

/// A device that is ready, calibrated, and has power as far as it says.
bool isReady(const nlohmann::json& device)
{
  const auto truth = [&device](const char* name, bool otherwise)
  {
    const auto status = device.find("status");
    const bool there = status != device.end() && status->is_object() && status->contains(name);
    return there && (*status)[name].is_boolean() ? (*status)[name].get<bool>() : otherwise;
  };
  return device.is_object() && device.contains("device_id") && device["device_id"] == "049D" && truth("ready", false) &&
         truth("calibrated", false) && truth("power_supply", true);
}

Kind haply()
{
  ArmSetup setup;
  setup.turns = true;
  setup.force_N = { 1.0, true };
  const Bytes answer =
    bytesOf(R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0.01,"y":-0.1,"z":0.2}},)"
            R"("status":{"calibrated":true,"ready":true,"power_supply":true}}]})");
  return { "haply", setup, std::make_shared<HaplyServiceWire>("049D", true), true, answer, answer,
    [](View bytes)
    {
      const nlohmann::json json = nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false);
      const auto all = json.is_object() ? json.find("inverse3") : json.end();
      return json.is_object() && all != json.end() && all->is_array() && std::any_of(all->begin(), all->end(), isReady);
    },
    [](View order)
    {
      const nlohmann::json json = nlohmann::json::parse(order.begin(), order.end(), nullptr, false);
      const nlohmann::json force = json["inverse3"][0]["commands"]["set_cursor_force"]["vector"];
      return std::hypot(force["x"].get<double>(), force["y"].get<double>(), force["z"].get<double>()) <= 1.0 + 1e-12;
    } };
}

/// A link that pushes an arm of that kind with 1 N.
class Pushed
{
public:
  explicit Pushed(const Kind& kind) : kind_(kind)
  {
    this->kind_.wire->encode({}, this->none_);
    require(this->link_->attach().empty());
    this->link_->limit(1.0);
    this->ask({});
    this->exchange(this->kind_.inPose);
    this->link_->stepDone("");
    for (int i = 0; i < 3; ++i)
    {
      this->exchange(this->kind_.inPose);
    }
    this->askToPush();
    this->pushed_ = this->talk_->asked;
    require(this->pushed_ != this->none_ && this->kind_.isLimited(this->pushed_));
  }

  /// True: it pushes as it did at first, so the answer has left nothing.
  [[nodiscard]] bool judge(View answer)
  {
    this->exchange({ answer.begin(), answer.end() }, this->kind_.keepsBorders ? 0 : answer.size() / 3 + 1);
    this->exchange(this->kind_.good);
    const bool maybe = this->kind_.mayBeAnswer(answer);
    require(maybe || this->talk_->asked == this->none_);
    require(this->kind_.isLimited(this->talk_->asked));
    this->exchange(this->kind_.good);
    if (!maybe && this->maySayNo() && this->talk_->asked == this->none_)
    {
      // The answer was one that lets the arm push no more, and only a person brings the force back.
      this->ask({});
      this->exchange(this->kind_.good);
      this->askToPush();
    }
    require(maybe || this->talk_->asked == this->pushed_);
    require(this->kind_.isLimited(this->talk_->asked));
    ++(maybe ? this->answers_ : this->refused_);
    return this->talk_->asked == this->pushed_;
  }

private:
  void ask(const DeviceCommand& command) { this->command_ = command; }
  void askToPush()
  {
    DeviceCommand push;
    push.wrench_D.force = Vec3(0.6, 0.8, 0.0);
    this->ask(push);
    this->exchange(this->kind_.good);
    this->exchange(this->kind_.good);
  }
  /// Its answers have a place for "not homed" or "not ready".
  [[nodiscard]] bool maySayNo() const { return !this->kind_.setup.homing.empty() || !this->kind_.setup.plan; }
  /// Good answers come in one piece: whoever waits for another one may be late on a machine with other work.
  void exchange(const Bytes& answer, std::size_t piece = 0)
  {
    this->talk_->answer = answer;
    this->talk_->piece = piece;
    this->link_->command(this->command_);
    require(this->link_->pass());
    this->time_.pass(perMs_ns);
    const std::optional<HandExchange::Hand> hand = this->link_->heard().hand;
    require(!hand || (hand->p_D.allFinite() && hand->q_D.coeffs().allFinite()));
  }

public:
  std::uint64_t answers_ = 0, refused_ = 0;

private:
  const Kind& kind_;
  test::ModelTime time_;
  std::shared_ptr<AnsweringLink::Talk> talk_ = std::make_shared<AnsweringLink::Talk>();
  std::shared_ptr<ArmBus> bus_ =
    std::make_shared<ListedArmBus>(ListedArmBus::Ways{ [] {
                                                        return std::vector<HidEntry>{ { "arm", 1, 2, "3", "arm" } };
                                                      },
      [this](const HidEntry&) -> ArmBus::Opened
      {
        auto line = std::make_unique<WireLine>(
          std::make_unique<AnsweringLink>(this->talk_, this->kind_.keepsBorders), this->kind_.wire);
        require(line->begin().empty());
        return { std::move(line), {} };
      },
      [](const HidEntry&) { return ""; } });
  std::unique_ptr<ArmLink> link_ =
    std::make_unique<ArmLink>(bus_, HidEntry{ "arm", 1, 2, "3", "arm" }, kind_.setup, time_);
  DeviceCommand command_;
  Bytes none_, pushed_;
};

/// One kind's link, made anew where an answer has left something: counters to be set, or a way that wrapped.
class Judge
{
public:
  explicit Judge(Kind kind) : kind_(std::move(kind)), pushed_(std::make_unique<Pushed>(kind_)) {}
  ~Judge()
  {
    this->count();
    if (this->answers_ + this->refused_ > 0)
    {
      std::printf("%-14s %llu answers that may push, %llu that may not\n", this->kind_.name,
        static_cast<unsigned long long>(this->answers_), static_cast<unsigned long long>(this->refused_));
    }
  }
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;

  [[nodiscard]] const char* name() const { return this->kind_.name; }
  [[nodiscard]] const Bytes& good() const { return this->kind_.good; }
  void judge(View answer)
  {
    if (!this->pushed_->judge(answer))
    {
      this->count();
      this->pushed_ = std::make_unique<Pushed>(this->kind_);
    }
  }

private:
  void count()
  {
    this->answers_ += this->pushed_->answers_;
    this->refused_ += this->pushed_->refused_;
  }

  Kind kind_;
  std::unique_ptr<Pushed> pushed_;
  std::uint64_t answers_ = 0, refused_ = 0;
};

std::vector<std::unique_ptr<Judge>> judgesOf(const char* only)
{
  std::vector<std::unique_ptr<Judge>> judges;
  for (const auto& kind : { woodenHaptics, falcon, twoDiy, haply })
  {
    judges.push_back(std::make_unique<Judge>(kind()));
  }
  if (only != nullptr)
  {
    std::erase_if(judges, [only](const auto& judge) { return std::strcmp(judge->name(), only) != 0; });
    require(!judges.empty());
  }
  return judges;
}

/// The answer after changes of three bytes each: place, kind of the change and new byte.
Bytes changed(Bytes answer, View changes)
{
  constexpr std::size_t longest = 4096;
  const Bytes good = answer;
  for (; changes.size() >= 3 && !answer.empty() && answer.size() < longest; changes = changes.subspan(3))
  {
    const auto at = answer.begin() + static_cast<std::ptrdiff_t>(changes[0] % answer.size());
    switch (changes[1] % 6)
    {
      case 0:
        *at = changes[2];
        break;
      case 1:
        *at ^= static_cast<std::uint8_t>(1U << changes[2] % 8U);
        break;
      case 2:
        answer.insert(at, changes[2]);
        break;
      case 3:
        answer.erase(at);
        break;
      case 4:
        answer.erase(at, answer.end());
        break;
      default:
        answer.insert(answer.end(), good.begin(), good.end());
    }
  }
  return answer;
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::vector<std::unique_ptr<Judge>> judges = judgesOf(std::getenv("PALPATE_FUZZED_ARM"));
  if (size == 0)
  {
    return 0;
  }
  const View rest(data + 1, size - 1);
  constexpr unsigned kinds = 4;
  Judge& judge = *judges[data[0] % kinds % judges.size()];
  const bool changes = data[0] / kinds % 2 == 1;
  const Bytes answer = changes ? changed(judge.good(), rest) : Bytes(rest.begin(), rest.end());
  judge.judge(answer);
  return 0;
}
