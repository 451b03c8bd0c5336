// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticMechanism
 * @brief   bodies and the constraints that join them, from a scene file
 *
 * Output: the surfaces of the bodies as they are at first, a needle at the origin, a wire in its sheath and its
 * vessel, with
 *
 *     Body          (m)    int     of cells, and likewise of points: which body, by its place in the file; a wire's
 *                                  vessel counts as the body behind the wire
 *     Vertex        (n)    int     of a soft body's points: which one of its tetrahedra's; of a wire's: which one of
 *                                  its own; else -1
 *     Displacement  (n, 3) double  how far the nodes of soft bodies and a wire's skin have gone, else 0 [u]
 *     Dent          (n, 3) double  how much further they are shown, where a constraint presses [u]
 *
 * and the whole description as field data, which a session and Touch Along Path take. The file is described in
 * docs/mechanisms.md. Bad input is an error of one line and leaves the output empty.
 */
#ifndef vtkHapticMechanism_h
#define vtkHapticMechanism_h

#include <string> // for the file

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyData.h"             // for members
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for members

struct vtkHapticMechanismResult;

class VTKHAPTICPIPELINE_EXPORT vtkHapticMechanism : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticMechanism* New();
  vtkTypeMacro(vtkHapticMechanism, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// A scene file, .json.
  void SetFileName(const std::string& file);
  vtkGetMacro(FileName, std::string);
  ///@}

  /// The scene file and those of its bodies are read anew with the next update: they may be others by now.
  void ReadAgain();

  /// Has the output show its bodies elsewhere until it is made anew; null: where they are at first.
  void ShowMoved(vtkPolyData* moved);
  /// The bodies where they are at first; null before they have been made. Another object each time they are made anew.
  vtkPolyData* GetAtFirst() const { return this->AtFirst; }

  /// Why there are no bodies, in one line; "": there are, or it has not run.
  const char* GetProblem() const { return this->Problem.c_str(); }

  /// Its properties, a line each: rows, rank, free rotations, redundant constraints; empty before it has run.
  const char* GetText() const { return this->Text.c_str(); }

protected:
  vtkHapticMechanism();
  ~vtkHapticMechanism() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

  /// The mechanism, or its problem; may begin Text.
  virtual vtkHapticMechanismResult ReadScene();
  /// The next RequestData() makes the bodies anew.
  void AskAgain() { this->Asked = true; }

  std::string Refusal = "The mechanism cannot be read: "; ///< in front of a problem
  std::string Text;

private:
  /// Null with Problem.
  vtkSmartPointer<vtkPolyData> Make();

  std::string FileName;
  std::string Problem;
  vtkSmartPointer<vtkPolyData> AtFirst, Moved;
  bool Asked = true; ///< for a file that has not been read since
};

#endif
