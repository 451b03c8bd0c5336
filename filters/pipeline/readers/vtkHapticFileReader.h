// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFileReader_h
#define vtkHapticFileReader_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

/**
 * @class vtkHapticFileReader
 * @brief Opens files that neither VTK nor ParaView read: OFF files as polygons, SVG drawings as lines.
 *
 * Output: vtkPolyData with double points [scene units] and polygons as the file gives them; or lines in the plane
 * z = 0, y upwards, with the field arrays Start and Exit where shapes of the drawing have these ids. A file that cannot
 * be used leaves the output empty and reports one line with its name and the reason.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticFileReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticFileReader* New();
  vtkTypeMacro(vtkHapticFileReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the file. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkHapticFileReader();
  ~vtkHapticFileReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  char* FileName = nullptr;
};

#endif
