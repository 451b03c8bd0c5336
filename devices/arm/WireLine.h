// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/arm/ArmLine.h"
#include "devices/arm/link/ByteLink.h"
#include "devices/arm/link/Guard.h"

namespace palpate
{

/// A protocol on a link of bytes. Whatever came before a request is no answer to it and is thrown away; a link that
/// takes its time to look is asked only where something may have come.
class WireLine final : public ArmLine
{
public:
  WireLine(std::unique_ptr<ByteLink> link, std::shared_ptr<const WireProtocol> protocol, Guard guard = {});

  /// Says the greeting. Empty, or why not.
  [[nodiscard]] std::string begin();
  [[nodiscard]] Answer exchange(const WireOrder& order, int timeout_ms) override;
  void letGo() noexcept override;
  [[nodiscard]] std::string error() const override { return this->error_; }

private:
  [[nodiscard]] bool send();
  [[nodiscard]] Said receive(int timeout_ms, WireReading& reading);
  [[nodiscard]] Said take(std::size_t count, WireReading& reading);
  void drop() noexcept;

  std::unique_ptr<ByteLink> link_;
  std::shared_ptr<const WireProtocol> protocol_;
  Guard guard_;
  WireBytes request_;
  WireBytes came_;
  std::size_t cameBytes_ = 0;
  bool mayHoldMore_ = true; ///< the link may hold bytes that belong to no later request
  std::string error_;
};

} // namespace palpate
