// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticTextRows_h
#define vtkHapticTextRows_h

#include <string>
#include <string_view>
#include <vector>

#include "vtkHapticPipelineModule.h" // for the export macro

/// One row after another of comma-separated text (RFC 4180), whose quoted fields may hold commas and lines.
class VTKHAPTICPIPELINE_EXPORT vtkHapticTextRows
{
public:
  /// `text` outlives it.
  explicit vtkHapticTextRows(std::string_view text) : Rest(text) {}

  [[nodiscard]] bool AtEnd() const { return this->Rest.empty(); }
  [[nodiscard]] std::vector<std::string> Next();

  /// A field as such a text has it.
  [[nodiscard]] static std::string Quoted(const std::string& field);
  /// The shortest digits that give the same number back.
  [[nodiscard]] static std::string Digits(double value);
  /// Reads the output of Digits(). Throws std::runtime_error for text that is no number.
  [[nodiscard]] static double Number(const std::string& field);

private:
  std::string NextField();

  std::string_view Rest;
};

#endif
