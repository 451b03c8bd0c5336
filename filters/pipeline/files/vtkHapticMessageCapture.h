// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMessageCapture_h
#define vtkHapticMessageCapture_h

#include <string>

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkSmartPointer.h"

class vtkOutputWindow;

/// While it lives, VTK's errors and warnings are collected instead of printed: the caller turns them into one
/// sentence. VTK's output window and log are one per process, so use it from one thread at a time.
class VTKHAPTICPIPELINE_EXPORT vtkHapticMessageCapture
{
public:
  vtkHapticMessageCapture();
  ~vtkHapticMessageCapture();
  vtkHapticMessageCapture(const vtkHapticMessageCapture&) = delete;
  vtkHapticMessageCapture& operator=(const vtkHapticMessageCapture&) = delete;

  /// The first error without VTK's preamble and line breaks; empty when there was none.
  [[nodiscard]] const std::string& FirstError() const;
  /// Likewise the first warning.
  [[nodiscard]] const std::string& FirstWarning() const;

private:
  class Window;
  vtkSmartPointer<vtkOutputWindow> Previous;
  int PreviousVerbosity;
  vtkSmartPointer<Window> Current;
};

#endif
