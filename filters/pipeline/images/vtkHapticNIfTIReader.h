// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticNIfTIReader_h
#define vtkHapticNIfTIReader_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for the header

struct vtkHapticNIfTIHeader;

/**
 * @class vtkHapticNIfTIReader
 * @brief Opens NIfTI-1 and NIfTI-2 images, packed or not, of either byte order.
 *
 * Output: vtkImageData with origin, spacing and direction as the sform or else the qform of the header says, in the
 * file's unit of length, and the point array "NIFTI" with its values rescaled as the header says. The fourth dimension
 * is time [s], the fifth and those of a complex number or colour are components. Always the whole image. A file that
 * cannot be used leaves the output empty and reports one line with its name and the reason.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticNIfTIReader : public vtkImageAlgorithm
{
public:
  static vtkHapticNIfTIReader* New();
  vtkTypeMacro(vtkHapticNIfTIReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the file. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkHapticNIfTIReader();
  ~vtkHapticNIfTIReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  char* FileName = nullptr;
  std::unique_ptr<vtkHapticNIfTIHeader> Header; ///< as RequestInformation() found it
};

#endif
