// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticNeighbourhood_h
#define vtkHapticNeighbourhood_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory>

/**
 * The part of a surface around a hand, cut out where the surface is.
 *
 * Clients that touch data of a server ask this filter there. A surface of no more polygons than the limit comes whole.
 * Of a larger one come all polygons that reach into a box around the hand, and those that share a point with one of
 * these, so that normals of the points within are those of the whole. Where the box has more than the limit it is made
 * smaller; where it has none it is made larger until it has some. On several ranks each cuts out of its own piece, and
 * the first has the answer. vtkHapticPartOf() describes the part.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticNeighbourhood : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticNeighbourhood* New();
  vtkTypeMacro(vtkHapticNeighbourhood, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Where the hand is, in the frame of the data [u], and how far along each axis the box is to reach from there.
  vtkSetVector3Macro(Centre, double);
  vtkGetVector3Macro(Centre, double);
  vtkSetMacro(Reach, double);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /// The most polygons and strips that come, but for those that share a point with them.
  vtkSetMacro(Limit, int);
  vtkGetMacro(Limit, int);
  ///@}

  ///@{
  /// Of the request, for who asks.
  vtkSetMacro(Number, int);
  vtkGetMacro(Number, int);
  ///@}

protected:
  vtkHapticNeighbourhood();
  ~vtkHapticNeighbourhood() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  double Centre[3] = { 0.0, 0.0, 0.0 };
  double Reach = 1.0;
  int Limit = 100000;
  int Number = 0;

  struct Looked;
  std::unique_ptr<Looked> Data;
};

#endif
