// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/Calibration.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <vector>

#include "haptics/core/Text.h"

namespace palpate
{
namespace
{

constexpr std::string_view firstLine = "palpate calibration ";
constexpr std::string_view version = "2", formerVersion = "1";
constexpr std::string_view axisNames = "xyz";
constexpr std::size_t longestText = 4096;
constexpr std::size_t longestName = 256;
constexpr std::array<std::string_view, 10> heldWords{ "unfelt", "felt", "wrong-way", "no-force", "wrong-size", "drives",
  "no-brake", "unclear", "misplaced", "no-limit" }; // in the order of HeldProof
constexpr double farthest_m = 100.0;
constexpr double strongest = 1000.0;

bool isPlain(std::string_view text)
{
  return text.size() <= longestName &&
         std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

bool isDate(std::string_view text)
{
  constexpr std::string_view shape = "0000-00-00";
  return text.size() == shape.size() &&
         std::equal(text.begin(), text.end(), shape.begin(),
           [](char c, char like) { return like == '-' ? c == '-' : c >= '0' && c <= '9'; });
}

std::string number(double value)
{
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return { digits.data(), end };
}

std::string signedAxis(int axis, int sign)
{
  return { axisNames[static_cast<std::size_t>(axis)], sign < 0 ? '-' : '+' };
}

bool isAxis(int axis, int sign, int count)
{
  return axis >= 0 && axis < count && (sign == 1 || sign == -1);
}

std::string refusalOf(const AxisCalibration& axis, int count)
{
  if (!isAxis(axis.sensor, axis.sensorSign, count) || !isAxis(axis.motor, axis.motorSign, count))
  {
    return "names an axis that the device lacks";
  }
  if (!(std::fabs(axis.low_m) <= farthest_m && std::fabs(axis.high_m) <= farthest_m))
  {
    return "has an end outside the lengths of a device";
  }
  if (!(axis.low_m < axis.high_m))
  {
    return "has no range: its low end must be below its high end";
  }
  if (!(axis.response_m_per_N >= 0.0 && axis.response_m_per_N <= farthest_m && axis.strength >= 0.0 &&
        axis.strength <= strongest))
  {
    return "has an impossible response or strength";
  }
  return {};
}

/// Takes a text apart line by line. The first line that is not as expected is the last that is taken.
class Lines
{
public:
  explicit Lines(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool ok() const { return this->ok_; }
  [[nodiscard]] int number() const { return this->number_; }
  [[nodiscard]] bool startsWith(std::string_view text) const { return this->rest_.starts_with(text); }
  void require(bool holds) { this->ok_ = this->ok_ && holds; }

  /// The rest of a line that begins so.
  std::string_view after(std::string_view begin)
  {
    this->number_ += this->ok_ ? 1 : 0;
    this->require(this->rest_.starts_with(begin) && this->rest_.find('\n') != std::string_view::npos);
    return this->ok_ ? takeUntil(this->rest_, '\n').substr(begin.size()) : std::string_view();
  }
  std::string textAfter(std::string_view begin)
  {
    const std::string_view text = this->after(begin);
    this->require(isPlain(text));
    return std::string(text);
  }
  /// A line, and no more.
  void whole(std::string_view line) { this->require(this->after(line).empty()); }
  void end()
  {
    this->number_ += this->ok_ ? 1 : 0;
    this->require(this->rest_.empty());
  }

private:
  std::string_view rest_;
  int number_ = 0;
  bool ok_ = true;
};

double finite(Lines& lines, std::string_view word)
{
  const std::optional<double> value = numberIn<double>(word);
  lines.require(value && std::isfinite(*value));
  return value.value_or(0.0);
}

void takeAxis(Lines& lines, std::string_view word, int& axis, int& sign)
{
  const std::size_t at = word.size() == 2 ? axisNames.find(word[0]) : std::string_view::npos;
  lines.require(at != std::string_view::npos && (word[1] == '+' || word[1] == '-'));
  axis = lines.ok() ? static_cast<int>(at) : 0;
  sign = word.ends_with('-') ? -1 : 1;
}

AxisCalibration readAxis(Lines& lines, int expected)
{
  constexpr std::array<std::string_view, 7> names{ "", "sensor", "low", "high", "motor", "response", "strength" };
  const std::string_view rest = lines.after("axis ");
  std::vector<std::string> words = partsOf(rest, ' '); // a name and its value in turn, behind the axis
  lines.require(words.size() == 2 * names.size() - 1 && !rest.ends_with(' '));
  words.resize(2 * names.size() - 1);
  lines.require(words[0] == axisNames.substr(static_cast<std::size_t>(expected), 1));
  for (std::size_t i = 1; i < names.size(); ++i)
  {
    lines.require(words[2 * i - 1] == names[i]);
  }
  AxisCalibration axis;
  takeAxis(lines, words[2], axis.sensor, axis.sensorSign);
  axis.low_m = finite(lines, words[4]);
  axis.high_m = finite(lines, words[6]);
  takeAxis(lines, words[8], axis.motor, axis.motorSign);
  axis.response_m_per_N = finite(lines, words[10]);
  axis.strength = finite(lines, words[12]);
  return axis;
}

Calibration readAll(Lines& lines)
{
  Calibration calibration;
  lines.whole(std::string(firstLine) + std::string(version));
  calibration.device = lines.textAfter("device ");
  calibration.serial = lines.textAfter("serial ");
  calibration.date = lines.textAfter("date ");
  while (lines.ok() && calibration.axisCount < Calibration::mostAxes && lines.startsWith("axis "))
  {
    calibration.axes[static_cast<std::size_t>(calibration.axisCount)] = readAxis(lines, calibration.axisCount);
    ++calibration.axisCount;
  }
  const auto held = std::find(heldWords.begin(), heldWords.end(), lines.after("held "));
  lines.require(held != heldWords.end());
  calibration.held = lines.ok() ? static_cast<HeldProof>(held - heldWords.begin()) : HeldProof::Unfelt;
  lines.whole("end");
  lines.end();
  return calibration;
}

} // namespace

std::string Calibration::refusal() const
{
  if (this->device.empty() || !isPlain(this->device) || !isPlain(this->serial))
  {
    return "the name or serial number of the device is empty, too long or not text";
  }
  if (!isDate(this->date))
  {
    return "the date is not YYYY-MM-DD";
  }
  if (this->axisCount < 1 || this->axisCount > mostAxes)
  {
    return "the number of axes is not 1 to 3";
  }
  const int known = std::max(2, this->axisCount); // a wheel may call itself a stick
  int sensors = 0, motors = 0;
  for (int i = 0; i < this->axisCount; ++i)
  {
    const AxisCalibration& axis = this->axes[static_cast<std::size_t>(i)];
    const std::string wrong = refusalOf(axis, known);
    if (!wrong.empty())
    {
      return "axis " + std::string(1, axisNames[static_cast<std::size_t>(i)]) + ' ' + wrong;
    }
    sensors |= 1 << axis.sensor;
    motors |= 1 << axis.motor;
  }
  const int each = (1 << this->axisCount) - 1;
  return this->axisCount == 1 || (sensors == each && motors == each) ? "" : "two axes share a sensor or a motor";
}

std::string writeCalibration(const Calibration& calibration)
{
  std::string text = std::string(firstLine) + std::string(version) + "\ndevice " + calibration.device + "\nserial " +
                     calibration.serial + "\ndate " + calibration.date + '\n';
  for (int i = 0; i < calibration.axisCount; ++i)
  {
    const AxisCalibration& axis = calibration.axes[static_cast<std::size_t>(i)];
    text += std::string("axis ") + axisNames[static_cast<std::size_t>(i)] + " sensor " +
            signedAxis(axis.sensor, axis.sensorSign) + " low " + number(axis.low_m) + " high " + number(axis.high_m) +
            " motor " + signedAxis(axis.motor, axis.motorSign) + " response " + number(axis.response_m_per_N) +
            " strength " + number(axis.strength) + '\n';
  }
  return text + "held " + std::string(heldWords[static_cast<std::size_t>(calibration.held)]) + "\nend\n";
}

Outcome<std::optional<Calibration>> parseCalibration(std::string_view text)
{
  if (text.size() > longestText)
  {
    return { std::nullopt, "the file is longer than any calibration" };
  }
  if (!text.starts_with(firstLine))
  {
    return { std::nullopt, "not a calibration file" };
  }
  if (text.substr(firstLine.size()).starts_with(std::string(formerVersion) + '\n'))
  {
    return { std::nullopt, "the file comes from an old version with another convention for directions" };
  }
  if (!text.substr(firstLine.size()).starts_with(std::string(version) + '\n'))
  {
    return { std::nullopt, "the version of the file is unknown to this program" };
  }
  Lines lines(text);
  Calibration calibration = readAll(lines);
  if (!lines.ok())
  {
    return { std::nullopt, "line " + std::to_string(lines.number()) + " is damaged or not as expected" };
  }
  std::string problem = calibration.refusal();
  if (!problem.empty())
  {
    return { std::nullopt, std::move(problem) };
  }
  return { std::move(calibration), {} };
}

} // namespace palpate
