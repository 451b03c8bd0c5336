// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMarksSource_h
#define vtkHapticMarksSource_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

/**
 * @class vtkHapticMarksSource
 * @brief The marks that were set while touching, as a source.
 *
 * Port 0: a vertex each, with all that was found there as point arrays; port 1: the same as a vtkTable with the columns
 * Source, X, Y, Z and so on. Made from the text in which a session has its marks (vtkHapticSession::GetMarksText()), so
 * that state files and scripts hold them.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticMarksSource : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticMarksSource* New();
  vtkTypeMacro(vtkHapticMarksSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Comma-separated, with a header line. Default: no marks.
  vtkSetStringMacro(Text);
  vtkGetStringMacro(Text);
  ///@}

protected:
  vtkHapticMarksSource();
  ~vtkHapticMarksSource() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  char* Text = nullptr;
};

#endif
