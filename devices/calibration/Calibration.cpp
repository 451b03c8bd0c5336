// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/Calibration.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

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

/// Takes a text apart: each method takes what it names from the front, or notes that it is not there.
class Reader
{
public:
  explicit Reader(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool ok() const { return this->ok_; }
  [[nodiscard]] bool atEnd() const { return this->rest_.empty(); }
  [[nodiscard]] bool startsWith(std::string_view text) const { return this->rest_.starts_with(text); }
  [[nodiscard]] int line() const { return this->line_; }

  void literal(std::string_view text)
  {
    this->require(this->rest_.starts_with(text));
    this->skip(text.size());
  }

  std::string restOfLine()
  {
    const std::size_t end = this->rest_.find('\n');
    this->require(end != std::string_view::npos);
    const std::string_view text = this->rest_.substr(0, this->ok_ ? end : 0);
    this->require(isPlain(text));
    this->skip(text.size());
    this->newLine();
    return std::string(this->ok_ ? text : std::string_view());
  }

  void newLine()
  {
    this->literal("\n");
    this->line_ += this->ok_;
  }

  double finite()
  {
    double value = 0.0;
    const auto [end, error] = std::from_chars(this->rest_.data(), this->rest_.data() + this->rest_.size(), value);
    this->require(error == std::errc() && std::isfinite(value));
    this->skip(static_cast<std::size_t>(end - this->rest_.data()));
    return value;
  }

  int axis()
  {
    const std::size_t at = this->rest_.empty() ? std::string_view::npos : axisNames.find(this->rest_.front());
    this->require(at != std::string_view::npos);
    this->skip(1);
    return this->ok_ ? static_cast<int>(at) : 0;
  }

  int sign()
  {
    const bool minus = this->rest_.starts_with('-');
    this->require(minus || this->rest_.starts_with('+'));
    this->skip(1);
    return minus ? -1 : 1;
  }

  HeldProof held()
  {
    const std::string_view word = this->rest_.substr(0, this->rest_.find('\n'));
    const auto found = std::find(heldWords.begin(), heldWords.end(), word);
    this->require(found != heldWords.end());
    this->skip(word.size());
    return this->ok_ ? static_cast<HeldProof>(found - heldWords.begin()) : HeldProof::Unfelt;
  }

  void require(bool holds) { this->ok_ = this->ok_ && holds; }

private:
  void skip(std::size_t count)
  {
    if (this->ok_)
    {
      this->rest_.remove_prefix(count);
    }
  }

  std::string_view rest_;
  int line_ = 1;
  bool ok_ = true;
};

AxisCalibration readAxis(Reader& reader, int expected)
{
  AxisCalibration axis;
  reader.literal("axis ");
  reader.require(reader.axis() == expected);
  reader.literal(" sensor ");
  axis.sensor = reader.axis();
  axis.sensorSign = reader.sign();
  reader.literal(" low ");
  axis.low_m = reader.finite();
  reader.literal(" high ");
  axis.high_m = reader.finite();
  reader.literal(" motor ");
  axis.motor = reader.axis();
  axis.motorSign = reader.sign();
  reader.literal(" response ");
  axis.response_m_per_N = reader.finite();
  reader.literal(" strength ");
  axis.strength = reader.finite();
  reader.newLine();
  return axis;
}

Calibration readAll(Reader& reader)
{
  Calibration calibration;
  reader.literal(firstLine);
  reader.literal(version);
  reader.newLine();
  reader.literal("device ");
  calibration.device = reader.restOfLine();
  reader.literal("serial ");
  calibration.serial = reader.restOfLine();
  reader.literal("date ");
  calibration.date = reader.restOfLine();
  while (reader.ok() && calibration.axisCount < Calibration::mostAxes && reader.startsWith("axis "))
  {
    calibration.axes[static_cast<std::size_t>(calibration.axisCount)] = readAxis(reader, calibration.axisCount);
    ++calibration.axisCount;
  }
  reader.literal("held ");
  calibration.held = reader.held();
  reader.newLine();
  reader.literal("end");
  reader.newLine();
  reader.require(reader.atEnd());
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

ParsedCalibration parseCalibration(std::string_view text)
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
  Reader reader(text);
  Calibration calibration = readAll(reader);
  if (!reader.ok())
  {
    return { std::nullopt, "line " + std::to_string(reader.line()) + " is damaged or not as expected" };
  }
  std::string problem = calibration.refusal();
  if (!problem.empty())
  {
    return { std::nullopt, std::move(problem) };
  }
  return { std::move(calibration), {} };
}

} // namespace palpate
