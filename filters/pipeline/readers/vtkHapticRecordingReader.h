// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticRecordingReader_h
#define vtkHapticRecordingReader_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the member
#include <vector> // for the member

namespace palpate
{
struct TrajectoryPoint;
}

/**
 * @class vtkHapticRecordingReader
 * @brief Opens a recording as the path of the hand and of its proxy, in time. The touched data need not be there.
 *
 * Port 0, *Moment*: at the time asked for the hand (point 0) and the proxy (point 1), as vertices, and the line between
 * them. Port 1, *Path*: all of it, two polylines, first the hand's, then the proxy's. Point arrays of both ports: Force
 * (3) [N], Depth [u], Lateness (periods that were missed before the tick) [s], StiffnessShare [1], ExcessEnergy [J],
 * Contacts, Tick, Time (since the first tick) [s] and Part (0: the hand, 1: the proxy).
 * Force is the active array of scalars, by whose magnitude ParaView colours both.
 * A file that cannot be used leaves both empty and reports one line with its name and the reason.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticRecordingReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticRecordingReader* New();
  vtkTypeMacro(vtkHapticRecordingReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the recording, of any format that is still read. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /// Time steps per second of the recording [Hz]; 0: one for each tick. Default: 60.
  vtkSetMacro(StepRate, double);
  vtkGetMacro(StepRate, double);
  ///@}

protected:
  vtkHapticRecordingReader();
  ~vtkHapticRecordingReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  /// Empty, or the fault of the file.
  std::string Read();

  char* FileName = nullptr;
  double StepRate = 60.0;
  std::vector<palpate::TrajectoryPoint> Points; ///< of the file that was read last
  std::string ReadFile;                         ///< its name
  long ReadTime = 0;                            ///< when it was changed
};

#endif
