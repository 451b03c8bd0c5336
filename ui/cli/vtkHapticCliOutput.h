// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliOutput_h
#define vtkHapticCliOutput_h

#include <fstream>
#include <string>
#include <vector>

/// A CSV file that appears whole or not at all: rows go to a temporary beside it, which takes its name at the end.
/// What stood under that name before stays until then. Throws vtkHapticCliProblem.
class vtkHapticCliOutput
{
public:
  /// Fails at once where the file cannot be written or is one of `inputs`.
  vtkHapticCliOutput(const std::string& file, const std::vector<std::string>& inputs);
  /// Removes the temporary unless Commit() was called.
  ~vtkHapticCliOutput();
  vtkHapticCliOutput(const vtkHapticCliOutput&) = delete;
  vtkHapticCliOutput& operator=(const vtkHapticCliOutput&) = delete;

  void Header(const std::string& names);
  /// The values of a row with 17 significant digits, enough to read back the same bits.
  void Value(double value);
  void Value(int value);
  void EndRow();
  void Commit();

private:
  std::string File;
  std::string Temporary;
  std::ofstream Stream;
  bool RowStarted = false;
};

#endif
