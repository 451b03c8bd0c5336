// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "devices/common/Condition.h"
#include "devices/hid/report/ReportDescriptor.h"
#include "testing/devices/hid/VirtualHandle.h"
#include "testing/devices/hid/VirtualHid.h"

namespace palpate::test
{

/// How a family of firmwares packs its reports. All of them number their output reports, effect types and operations
/// alike: 1 settings, 3 condition, 4 periodic, 5 constant force, 10 operation, 11 free, 12 control, 13 gain.
struct ModelWire
{
  std::uint8_t create = 5, load = 6, pool = 7; ///< features
  bool startDelay = false;                     ///< two bytes before the gain
  int directionBytes = 1, turn = 255;
  double forces = 10000.0, conditions = 10000.0; ///< the largest numbers
  bool oneCoefficient = false;                   ///< bytes: a centre and one coefficient
  int firstBlock = 1, blocks = 14;
};

/// Treatment of each report by the firmwares that people have, written by us from facts in their public sources; the
/// class holds their common part. The model reads reports by the place of their bytes, not through a descriptor.
/// Positions and forces are shares, as those of VirtualHandle.
class FirmwareModel
  : public VirtualHid
  , public VirtualHandle
{
public:
  enum Type : std::uint8_t
  {
    Constant = 1,
    Sine = 4,
    Spring = 8,
    Damper = 9,
  };
  struct Effect
  {
    bool used = false, playing = false;
    std::uint8_t type = 0, trigger = 0, axes = 0;
    std::int64_t duration_ms = 0, age_ms = 0;
    double gain = 1.0, angle_rad = 0.0, magnitude = 0.0, period_ms = 1.0;
    std::array<Condition, 2> conditions{};
    unsigned conditionsSeen = 0;           ///< a bit for each axis
    std::array<double, 2> factors{};       ///< of the force along each axis, for firmwares that keep such
    bool sameForBoth = true, held = false; ///< one condition for both axes; its trigger is down
  };

  FirmwareModel(std::span<const std::uint8_t> descriptor, const ModelWire& wire);

  bool take(HidReportKind kind, std::span<const std::uint8_t> bytes) override;
  [[nodiscard]] std::vector<std::uint8_t> feature(std::uint8_t id) override;
  [[nodiscard]] std::vector<std::uint8_t> nextInput() override;
  void advance(int duration_ms) override;

  [[nodiscard]] Axes force() const;
  /// Frees all effects, as another program's reset does; no report says so.
  void wipe();

  std::uint8_t buttons = 0;
  int badReports = 0;

protected:
  virtual void settingsCame(Effect&) {}
  virtual void conditionCame(Effect&, std::size_t) {}
  virtual void control(int number) = 0;
  /// A start, a stop or the end of a millisecond changes the effects that play.
  virtual void started(Effect& effect) { effect.playing = true; }
  virtual void tick(Effect&) {}
  /// Its share along an axis.
  [[nodiscard]] virtual double forceOf(const Effect& effect, std::size_t axis) const = 0;
  [[nodiscard]] virtual bool givesForce() const { return true; }
  [[nodiscard]] virtual double ownForce(std::size_t) const { return 0.0; }

  void stopAll();
  /// Of constant forces and sines, whatever their direction.
  [[nodiscard]] static double strength(const Effect& effect);
  /// Position of a spring, speed of a damper.
  [[nodiscard]] double metric(const Effect& effect, std::size_t axis) const;

  double gain = 1.0;

private:
  void create(std::uint8_t type);
  void settings(Effect& effect, std::span<const std::uint8_t> bytes);
  void condition(Effect& effect, std::span<const std::uint8_t> bytes);
  void operate(Effect& effect, int operation);
  void showInput();

  ReportDescriptor descriptor_;
  ModelWire wire_;
  std::vector<Effect> effects_; ///< by their block
  std::deque<std::vector<std::uint8_t>> inputs_;
  int lastBlock_ = 0;
};

} // namespace palpate::test
