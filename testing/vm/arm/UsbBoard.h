// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "testing/devices/arm/FalconRig.h"
#include "testing/devices/arm/TwoDiyModel.h"
#include "testing/vm/UsbPort.h"

namespace palpate::test
{

/// A board on the virtual bus that takes and gives plain bytes by bulk endpoints 2 and 1, with a supply of its own:
/// without its cable it goes on as it was told last.
class UsbBoard : public RunningDevice
{
public:
  [[nodiscard]] const std::string& serial() const noexcept { return this->identity_.serial; }

protected:
  explicit UsbBoard(PlugIdentity identity) : identity_(std::move(identity)) {}

  /// A request of its own kind on endpoint 0. False: it knows none such. All three while the firmware stands still.
  [[nodiscard]] virtual bool order(const UsbRequest& request) = 0;
  virtual void take(std::span<const std::uint8_t> bytes) = 0;
  /// The answer to a read that waits; none: nothing yet.
  [[nodiscard]] virtual std::optional<std::vector<std::uint8_t>> give(bool millisecondIsOver) = 0;

private:
  void powerOn() override {}
  void attach() override { this->port_.attach(); }
  void detach() noexcept override;
  void serve(Instant until) override;
  void passMillisecond() override;

  void submit(UsbRequest request);
  void control(const UsbRequest& request);
  void flush(bool millisecondIsOver);

  PlugIdentity identity_;
  UsbPort port_;
  std::deque<UsbRequest> outs_, ins_, others_;
};

/// A Falcon behind its chip, which tells its two bytes each millisecond whether there is more or not.
class UsbFalcon final : public UsbBoard
{
public:
  explicit UsbFalcon(std::string serial);
  ~UsbFalcon() override { this->unplug(); }

  template<class Body>
  auto alone(Body body)
  {
    return this->still([&] { return body(*this->model_); });
  }
  template<class Body>
  auto aloneWithLoader(Body body)
  {
    return this->still([&] { return body(*this->loader_); });
  }

private:
  bool order(const UsbRequest& request) override;
  void take(std::span<const std::uint8_t> bytes) override { static_cast<void>(this->chip_.write(bytes)); }
  std::optional<std::vector<std::uint8_t>> give(bool millisecondIsOver) override;

  ModelTime time_; ///< of nobody
  std::shared_ptr<FalconModel> model_ = std::make_shared<FalconModel>();
  std::shared_ptr<FalconChip::Loader> loader_ = std::make_shared<FalconChip::Loader>();
  FalconChip chip_{ model_, loader_, time_ };
  int awaited_ms_ = 0; ///< by the transfer that waits
};

/// A 2DIY's board, which the kernel's own driver makes a serial line of.
class UsbTwoDiy final : public UsbBoard
{
public:
  explicit UsbTwoDiy(std::string serial);
  ~UsbTwoDiy() override { this->unplug(); }

  template<class Body>
  auto alone(Body body)
  {
    return this->still([&] { return body(this->model_); });
  }

private:
  bool order(const UsbRequest& request) override;
  void take(std::span<const std::uint8_t> bytes) override { this->model_.take(bytes); }
  std::optional<std::vector<std::uint8_t>> give(bool millisecondIsOver) override;

  TwoDiyModel model_;
};

} // namespace palpate::test
