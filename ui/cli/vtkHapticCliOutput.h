// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliOutput_h
#define vtkHapticCliOutput_h

#include <fstream>
#include <string>
#include <vector>

/// A CSV file that appears whole or not at all: rows go to a temporary beside it, which takes its name at the end. A
/// file of that name stays until then. Throws vtkHapticCliProblem.
class vtkHapticCliOutput
{
public:
  /// Fails at once where the file cannot be written or is one of `inputs`.
  vtkHapticCliOutput(const std::string& file, const std::vector<std::string>& inputs);
  /// Removes the temporary unless Commit() was called.
  ~vtkHapticCliOutput();
  vtkHapticCliOutput(const vtkHapticCliOutput&) = delete;
  vtkHapticCliOutput& operator=(const vtkHapticCliOutput&) = delete;

  /// Of ticks: time [s], device, proxy [scene units], force on the hand as seen in the scene [N], contacts, cost [us].
  static constexpr const char* TickColumns =
    "t,device_x,device_y,device_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contacts,cost_us";
  void Header(const std::string& names);
  /// Values with 17 significant digits, enough to read back the same bits.
  void Row(const std::vector<double>& values);
  void Commit();

private:
  std::string File;
  std::string Temporary;
  std::ofstream Stream;
};

#endif
