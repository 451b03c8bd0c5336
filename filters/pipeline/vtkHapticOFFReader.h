// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticOFFReader_h
#define vtkHapticOFFReader_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

/**
 * @class vtkHapticOFFReader
 * @brief Opens OFF files, which neither VTK nor ParaView read, as polygons.
 *
 * Output: vtkPolyData with double points [scene units] and polygons as the file gives them. A file that cannot be
 * used leaves the output empty and reports one line with its name and the reason.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticOFFReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticOFFReader* New();
  vtkTypeMacro(vtkHapticOFFReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the file. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkHapticOFFReader();
  ~vtkHapticOFFReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHapticOFFReader(const vtkHapticOFFReader&) = delete;
  void operator=(const vtkHapticOFFReader&) = delete;

  char* FileName = nullptr;
};

#endif
