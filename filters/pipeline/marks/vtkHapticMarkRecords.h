// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMarkRecords_h
#define vtkHapticMarkRecords_h

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vtkHapticPipelineModule.h" // for the export macro

class vtkPolyData;
class vtkTable;

/// Data at a contact: the name of the source ("": a place in space without a source) and named numbers, the place X, Y
/// and Z [u] first.
struct VTKHAPTICPIPELINE_EXPORT vtkHapticMarkRecord
{
  std::string Source;
  std::vector<std::pair<std::string, double>> Numbers; ///< NaN: not known
  std::string Name{};                                  ///< given by a person; "": none, and the number stands for it

  /// NaN when there is none of that name.
  [[nodiscard]] double Number(std::string_view name) const;
};

/// Marks in their order, as a table, as points and as text. Records need not have the same numbers: every one gets all
/// columns, NaN where it has none.
class VTKHAPTICPIPELINE_EXPORT vtkHapticMarkRecords
{
public:
  static constexpr const char* NameColumn = "Name";

  std::vector<vtkHapticMarkRecord> Records;

  /// A column for the source, then one a number, in the order in which they come first; the column Name is the last.
  void FillTable(vtkTable* table) const;
  /// A vertex each, with the same columns as point arrays, Source as text.
  void FillPoints(vtkPolyData* points) const;
  /// Comma-separated (RFC 4180), a header line first; numbers are read back to the bit. Empty without records. The
  /// column Name comes after Z, where any record has a name.
  [[nodiscard]] std::string ToText() const;
  /// Reads the output of ToText(). Empty, or the fault of its line; then there are no records.
  [[nodiscard]] std::string FromText(std::string_view text);
  /// Reads a file of that text. Empty, or one line with the file, the reason and the remedy; then there are no records.
  [[nodiscard]] std::string Read(const std::string& path);
  /// Writes csv or vtp, by the suffix, whole or not at all. Empty, or one line with the file, the reason and the
  /// remedy.
  [[nodiscard]] std::string Write(const std::string& path) const;

private:
  [[nodiscard]] std::vector<std::string> Columns() const;
};

#endif
