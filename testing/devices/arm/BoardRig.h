// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <memory>

#include "devices/arm/ArmDevice.h"
#include "devices/arm/ListedArmBus.h"
#include "devices/arm/WireLine.h"
#include "testing/devices/arm/BoardModel.h"
#include "testing/devices/arm/ModelTime.h"
#include "testing/devices/arm/ServoSide.h"

namespace palpate::test
{

/// A link to a board in virtual time: a message takes a quarter of a millisecond, a wait for nothing all of its time.
class BoardLink
{
public:
  BoardLink(std::shared_ptr<BoardModel> board, ModelTime& time) : board_(std::move(board)), time_(time) {}

  bool write(std::span<const std::uint8_t> bytes)
  {
    constexpr std::int64_t message_ns = 250000;
    if (!this->answers())
    {
      return false;
    }
    this->time_.pass(message_ns);
    this->board_->take(bytes);
    return true;
  }
  int read(std::span<std::uint8_t> bytes, int timeout_ms)
  {
    if (!this->answers())
    {
      return -1;
    }
    if (this->board_->said.empty())
    {
      this->time_.pass(timeout_ms * perMs_ns);
      return 0;
    }
    const std::size_t count = std::min(bytes.size(), this->board_->said.size());
    const auto end = this->board_->said.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(this->board_->said.begin(), end, bytes.begin());
    this->board_->said.erase(this->board_->said.begin(), end);
    return static_cast<int>(count);
  }

private:
  bool answers()
  {
    int& left = this->board_->callsUntilUnplugged;
    this->board_->present = this->board_->present && left != 0;
    left -= left > 0 ? 1 : 0;
    return this->board_->present;
  }

  std::shared_ptr<BoardModel> board_;
  ModelTime& time_;
};

/// The same as a serial line.
class BoardSerial final : public ByteLink
{
public:
  BoardSerial(std::shared_ptr<BoardModel> board, ModelTime& time) : link_(std::move(board), time) {}
  bool send(std::span<const std::uint8_t> bytes) noexcept override { return this->link_.write(bytes); }
  int receive(std::span<std::uint8_t> bytes, int timeout_ms) noexcept override
  {
    return this->link_.read(bytes, timeout_ms);
  }
  std::string error() const override { return "No such device"; }
  bool keepsBorders() const noexcept override { return false; }

private:
  BoardLink link_;
};

/// An arm whose board is such a model: a tick of the servo, then an exchange.
struct BoardRig : ServoSide
{
  using Open = std::function<ArmBus::Opened()>;

  BoardRig(ModelTime& itsTime, std::shared_ptr<BoardModel> model, const ArmSetup& setup, const Open& open)
    : time(itsTime), board(std::move(model)),
      bus(std::make_shared<ListedArmBus>(
        ListedArmBus::Ways{ [this] { return this->board->present ? std::vector{ entry } : std::vector<HidEntry>(); },
          [open](const HidEntry&) { return open(); }, [](const HidEntry&) { return ""; } })),
      device("arm", bus, entry, setup, { false, &time })
  {
    this->device.prove();
  }

  void tick() { ServoSide::tick(this->device, this->time.now_ns()); }
  /// A millisecond, or as long as the exchange takes.
  void pass()
  {
    const std::int64_t due_ns = this->time.now_ns() + perMs_ns;
    static_cast<void>(this->device.link().pass());
    this->time.pass(std::max<std::int64_t>(0, due_ns - this->time.now_ns()));
  }
  void run(int duration_ms)
  {
    const std::int64_t until_ns = this->time.now_ns() + duration_ms * perMs_ns;
    while (this->time.now_ns() < until_ns)
    {
      this->tick();
      this->pass();
    }
  }

  ModelTime& time;
  std::shared_ptr<BoardModel> board;
  HidEntry entry{ "board", 1, 2, "7", "board" };
  std::shared_ptr<ArmBus> bus;
  ArmDevice device;
};

} // namespace palpate::test
