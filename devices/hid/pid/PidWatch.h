// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "devices/hid/pid/PidEngine.h"

namespace palpate
{

/// Notices that somebody else made or wiped effects, on devices too that report nothing: the kernel's own driver resets
/// a device once any program uploads an effect to it. The device's answer about the effect that was made last then
/// differs, unless it has only one and no count of its memory. One thread, not the servo's.
class PidWatch
{
public:
  explicit PidWatch(PidEngine& engine) noexcept : engine_(engine) {}

  /// After the last effect was made. A device that answers differently twice, or not, is not asked again.
  void begin() noexcept;
  /// Asks every 100 ms. False: the effects are not ours any more.
  [[nodiscard]] bool undisturbed(std::int64_t now_ns) noexcept;

private:
  PidEngine& engine_;
  std::vector<std::uint8_t> own_; ///< its answer while no other program made one; empty: not asked
  std::int64_t asked_ns_ = 0;
};

} // namespace palpate
